// SPDX-License-Identifier: MIT
// Turns, moves and nears a large map in Chromium and says how fast it is drawn: node pace_page.js MAP.html
// Ends with an error where a picture takes more than some calls, or is drawn though nothing moved.
import assert from 'node:assert/strict';
import { openPage } from './open_page.js';
import { processorTime } from './processor_time.js';

const graphics = ['--use-angle=swiftshader', '--enable-unsafe-swiftshader'];
const pictures = Number(process.argv[3] ?? 120);

/** In the page: counts what goes to the graphics from now on. */
const countCalls = () => {
  window.calls = { draws: 0, sent: 0 };
  const gl = WebGL2RenderingContext.prototype;
  for (const [name, count] of [
    ['drawArrays', () => { ++window.calls.draws; }],
    ['drawArraysInstanced', () => { ++window.calls.draws; }],
    ['drawElements', () => { ++window.calls.draws; }],
    ['drawElementsInstanced', () => { ++window.calls.draws; }],
    ['texImage2D', ([, , , width, height]) => { window.calls.sent += 16 * width * height; }],
  ]) {
    const original = gl[name];
    gl[name] = function (...args) {
      count(args);
      return original.apply(this, args);
    };
  }
};

/** In the page: presses a key before each picture; how long the pictures took, ms, and their calls. */
const press = ([keys, count]) => new Promise((resolve) => {
  const canvas = document.getElementById('scene');
  const times = [];
  const before = { ...window.calls };
  const step = (now) => {
    times.push(now);
    if (times.length > count) {
      const { draws, sent } = window.calls;
      resolve({ times, draws: draws - before.draws, sent: sent - before.sent });
      return;
    }
    const [key, shiftKey] = keys[times.length % keys.length];
    canvas.dispatchEvent(new KeyboardEvent('keydown', { key, shiftKey, bubbles: true }));
    requestAnimationFrame(step);
  };
  requestAnimationFrame(step);
});

const middle = (values) => [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)];

await openPage(process.argv[2], graphics, async ({ page, complaints }) => {
  const data = JSON.parse(await page.locator('#map-data').textContent());
  console.log(`${data.keyframes.name.length} key frames, ${data.objects.class.length} objects`);
  await page.evaluate(countCalls);
  await page.waitForTimeout(500);

  const measure = async (what, keys) => {
    const worked = processorTime();
    const { times, draws, sent } = await page.evaluate(press, [keys, pictures]);
    const work = (processorTime() - worked) / pictures;
    const taken = times.slice(1).map((time, i) => time - times[i]);
    const rate = 1000 * taken.length / (times.at(-1) - times[0]);
    console.log(`${what}: ${rate.toFixed(1)} pictures a second, median ` +
      `${middle(taken).toFixed(1)} ms, longest ${Math.max(...taken).toFixed(1)} ms; ` +
      `a picture takes the browser ${work.toFixed(0)} ms of the processors, ` +
      `${(draws / pictures).toFixed(1)} draw calls and ${(sent / pictures / 1e3).toFixed(0)} kB`);
    assert.ok(draws > 0, 'nothing is drawn');
    assert.ok(draws <= 8 * pictures, `${draws} draw calls for ${pictures} pictures`);
  };
  const motions = {
    'turned': [['ArrowRight', false]],
    'moved': [['ArrowRight', true], ['ArrowUp', true], ['ArrowLeft', true], ['ArrowDown', true]],
    'nearer and farther': [['+', false], ['-', false]],
  };
  for (const [where, key, nearer] of [['the whole map', 'h', 0], ['from above', 't', 0],
    ['in its midst', 'h', 10]]) {
    await page.locator('#scene').focus();
    await page.keyboard.press(key);
    await page.waitForTimeout(2000);
    for (let i = 0; i < nearer; ++i) await page.keyboard.press('+');
    for (const [motion, keys] of Object.entries(motions)) await measure(`${where}, ${motion}`, keys);
  }

  // What the browser takes for a picture with nothing but the floor.
  await page.locator('#none').click();
  await page.locator('#show-keyframes').uncheck();
  await page.locator('#scene').focus();
  await measure('an empty picture, turned', motions.turned);

  // At rest nothing is drawn, and few names stand in the picture.
  await page.waitForTimeout(1500);
  const before = await page.evaluate(() => window.calls.draws);
  await page.waitForTimeout(500);
  assert.equal(await page.evaluate(() => window.calls.draws), before);
  assert.ok(await page.locator('#labels span:visible').count() <= 58);
  assert.deepEqual(complaints, []);
});
