// SPDX-License-Identifier: MIT
// Opens the page of a map with matches in Chromium: node view_page.js MAP.html
// Ends with an error at the first thing that is not as it should be.
import assert from 'node:assert/strict';
import { look, openPage } from './open_page.js';

const graphics = ['--use-angle=swiftshader', '--enable-unsafe-swiftshader'];
await openPage(process.argv[2], graphics, async ({ page, complaints, elsewhere }) => {
  const data = JSON.parse(await page.locator('#map-data').textContent());
  const text = (id) => page.locator('#' + id).textContent();
  const chosen = () => page.locator('#details-body .kind').textContent({ timeout: 5000 });
  assert.deepEqual(elsewhere, []);
  assert.equal(await page.locator('#failure').isHidden(), true);

  // What it holds is said, and drawn: the canvas has more than its ground.
  assert.equal((await text('title')).replaceAll('\u200b', ''), data.title);
  assert.match(await text('counts'), new RegExp(`^${data.objects.class.length} objects .* ` +
    `${data.keyframes.name.length} key frames$`));
  assert.equal(await page.locator('#classes button').count(), data.classes.length);
  const drawn = async () => (await page.locator('#scene').screenshot()).length;
  const whole = await drawn();
  const hide = page.locator('#none');
  await hide.click();
  assert.ok(await drawn() < whole, 'hidden objects are still drawn');
  assert.equal(await page.locator('#classes [aria-pressed=true]').count(), 0);
  await page.locator('#all').click();
  assert.equal(await page.locator('#classes [aria-pressed=false]').count(), 0);

  // Search by class, and go to what is found.
  const wanted = data.classes[data.objects.class[0]];
  await page.keyboard.press('/');
  await page.keyboard.type(wanted);
  const count = data.objects.class.filter((label) => data.classes[label].includes(wanted)).length;
  assert.match(await text('found'), new RegExp(`^${count} found`));
  await page.keyboard.press('Enter');
  assert.match(await chosen(), /^Object/);
  assert.ok((await page.locator('#details h2').textContent()).includes(wanted));
  await page.keyboard.press('Escape');
  await page.keyboard.press('Escape');

  // The keyboard goes through time and matches; a match is explained.
  const canvas = page.locator('#scene');
  await canvas.focus();
  await page.keyboard.press('Escape');
  assert.equal(await page.locator('#details').isHidden(), true);
  const when = await text('when');
  await page.keyboard.press('p');
  assert.notEqual(await text('when'), when);
  await page.keyboard.press('n');
  assert.equal(await text('when'), when);
  await page.keyboard.press('m');
  assert.match(await chosen(), /^Match/);
  const best = data.matches.reduce((a, b) => (b.score > a.score ? b : a));
  assert.equal((await page.locator('.sentence').textContent()),
    best.sentence.replaceAll('10^', '10'));
  assert.match(await page.locator('#said').textContent(), /^match /);
  await page.locator('#close').click();

  // At an early time less is held, and all of it again at the end.
  await page.locator('#build').check();
  await page.locator('#slider').focus();
  await page.keyboard.press('Home');
  assert.ok(await drawn() < whole, 'what was seen later is still drawn');
  await page.keyboard.press('End');
  await page.locator('#build').uncheck();

  // A click in the picture chooses what is there.
  await page.locator('#home').click();
  await page.keyboard.press('h');
  await page.waitForTimeout(1500);
  const label = await page.locator('#labels span:visible').first().boundingBox();
  await page.mouse.click(label.x + label.width / 2, label.y + label.height + 6);
  assert.match(await chosen(), /^(Object|Key frame|Match)/);
  await page.keyboard.press('Escape');

  // Focus is seen, the keys are listed, and nothing is wider than the page.
  await page.keyboard.press('Tab');
  const outline = await page.evaluate(() => getComputedStyle(document.activeElement).outlineStyle);
  assert.equal(outline, 'solid');
  await page.locator('#help').click();
  assert.ok(await page.locator('#keys').isVisible());
  await page.keyboard.press('Escape');
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));

  // Light and dark: the system's, then the reader's.
  const light = await look(page, 'light');
  const dark = await look(page, 'dark');
  assert.notDeepEqual(light.colors, dark.colors);
  assert.ok(!light.picture.equals(dark.picture));
  await page.locator('#theme').click();
  assert.equal(await page.evaluate(() => document.documentElement.dataset.theme), 'light');

  assert.deepEqual(complaints, []);
  console.log(`${data.objects.class.length} objects, ${data.matches.length} matches`);
});
