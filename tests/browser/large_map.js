// SPDX-License-Identifier: MIT
// Writes a made-up table of 5,000 key frames and 20,000 objects, with the names of its classes:
//   node large_map.js TABLE
// The same one each time: a robot goes up and down the aisles of a hall, and each key frame sees four
// objects that no earlier one saw; now and then five, since of boxes that fall together one is kept.
import { writeFileSync } from 'node:fs';

const aisles = 20, steps = 250, seenFor = 3, classes = 80;
const camera = { f: 500, cx: 320, cy: 240, height: 1.2 };
const ways = [  // along x, then back; both quaternions look level along their way
  { sign: 1, turn: '-0.5,0.5,-0.5,0.5' }, { sign: -1, turn: '-0.5,-0.5,0.5,0.5' },
];

let state = 1;  // of a congruential generator modulo 2^32
const random = (from, to) => {
  state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
  return from + (to - from) * state / 2 ** 32;
};

const frames = ['idx,frame,timestamp,tx,ty,tz,qx,qy,qz,qw'];
const nodes = ['idx,class_id,class,conf,u,v,w,h,z'];
const nodesOf = Array.from({ length: aisles * steps }, () => []);
let objects = 0;
for (let k = 0; k < aisles * steps; ++k) {
  const [aisle, step] = [Math.floor(k / steps), k % steps];
  const { sign, turn } = ways[aisle % 2];
  const x = 0.4 * (sign > 0 ? step : steps - 1 - step);
  frames.push(`${k},${k}.png,${k}.0,${x},${8 * aisle},${camera.height},${turn}`);
  for (let seenNew = k % 40 === 0 ? 5 : 4; seenNew > 0; --seenNew) {
    const [ahead, right, down] = [random(3, 5), random(-1.3, 1.3), random(-0.8, 0.8)];
    const [width, tall] = [random(0.1, 0.6), random(0.1, 0.6)];
    const label = objects++ % classes;
    for (let later = 0; later < seenFor && step + later < steps; ++later) {
      const z = ahead - 0.4 * later;
      const [u, v] = [camera.cx + camera.f * right / z, camera.cy + camera.f * down / z];
      const box = [u, v, camera.f * width / z, camera.f * tall / z].map((px) => px.toFixed(2));
      nodesOf[k + later].push([label, 'thing ' + label, 0.9, ...box, z.toFixed(4)].join());
    }
  }
}
nodesOf.forEach((lines, k) => lines.forEach((line) => nodes.push(`${k},${line}`)));
const table = process.argv[2];
writeFileSync(table + '.frames.csv', frames.join('\n') + '\n');
writeFileSync(table + '.nodes.csv', nodes.join('\n') + '\n');
const names = Array.from({ length: classes }, (_, label) => 'thing ' + label);
writeFileSync(table + '.names', names.join('\n') + '\n');
