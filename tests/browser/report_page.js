// SPDX-License-Identifier: MIT
// Opens a report in Chromium: node report_page.js REPORT.html
// Ends with an error at the first thing that is not as it should be.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { look, openPage } from './open_page.js';

await openPage(process.argv[2], ['--disable-gpu'], async ({ page, complaints, elsewhere }) => {
  // A drawing in every figure, and nothing from elsewhere.
  const figures = await page.locator('figure').count();
  assert.ok(figures >= 6, `only ${figures} figures`);
  assert.equal(await page.locator('figure:has(svg, canvas)').count(), figures);
  assert.deepEqual(elsewhere, []);

  // No text reaches beyond its drawing, and no drawing beyond the page.
  const cut = await page.evaluate(() => [...document.querySelectorAll('figure svg text')].filter((text) => {
    const inner = text.getBoundingClientRect();
    const outer = text.ownerSVGElement.getBoundingClientRect();
    return inner.left < outer.left - 1 || inner.right > outer.right + 1 ||
      inner.top < outer.top - 1 || inner.bottom > outer.bottom + 1;
  }).map((text) => text.textContent));
  assert.deepEqual(cut, []);
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));

  // The pointer on a cell of a matrix reads its pair, and off it again reads none.
  const matrix = page.locator('canvas.matrix').first();
  const readout = page.locator('figure:has(canvas.matrix) .readout').first();
  const atRest = await readout.textContent();
  await matrix.hover();
  assert.match(await readout.textContent(), /^query \S+, candidate \S+: /);
  await page.mouse.move(0, 0);
  assert.equal(await readout.textContent(), atRest);

  // The numbers: in the page, and to keep.
  await page.locator('summary').first().click();
  await page.locator('details[open] td').first().waitFor({ timeout: 5000 });
  const downloaded = async (link) => {
    const [download] = await Promise.all([
      page.waitForEvent('download'), page.locator(link).first().click(),
    ]);
    return readFile(await download.path(), 'utf8');
  };
  assert.match(await downloaded('figure a.download'), /^\w+(,\w+)+\n/);
  const json = JSON.parse(await downloaded('header a.download'));
  assert.equal(json.title, await page.locator('h1').textContent());
  assert.ok(Object.keys(json.figures).length > 0);

  // Light and dark.
  const light = await look(page, 'light');
  const dark = await look(page, 'dark');
  assert.notDeepEqual(light.colors, dark.colors);
  assert.ok(!light.picture.equals(dark.picture));

  assert.deepEqual(complaints, []);
  console.log(`${figures} figures`);
});
