// SPDX-License-Identifier: MIT
// What the tests of pages have in common: Chromium without a screen, and what a page complains of.
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';

/** Opens a file; `check` is given the page, and what it asked for and complained of till then. */
export const openPage = async (file, graphics, check) => {
  const browser = await chromium.launch({
    executablePath: '/usr/bin/chromium',
    args: [
      '--headless', '--no-sandbox', '--disable-quic', '--no-first-run', ...graphics,
      '--disable-background-networking', '--disable-component-update', '--disable-sync',
    ],
  });
  try {
    const page = await browser.newPage({ viewport: { width: 1280, height: 900 } });
    const complaints = [];
    const elsewhere = [];
    const url = pathToFileURL(path.resolve(file)).href;
    page.on('console', (message) => {
      if (['error', 'warning'].includes(message.type())) complaints.push(message.text());
    });
    page.on('pageerror', (error) => complaints.push(error.message));
    page.on('requestfailed', (request) => complaints.push('not loaded: ' + request.url()));
    page.on('request', (request) => {
      const asked = request.url();
      if (asked !== url && !asked.startsWith('data:')) elsewhere.push(asked);
    });
    await page.goto(url);
    await check({ page, complaints, elsewhere });
  } finally {
    await browser.close();
  }
};

/** The page's colors and its picture under a color scheme. */
export const look = async (page, colorScheme) => {
  await page.emulateMedia({ colorScheme });
  const colors = await page.evaluate(() => {
    const { color, backgroundColor } = getComputedStyle(document.body);
    return [color, backgroundColor];
  });
  return { colors, picture: await page.screenshot() };
};
