// SPDX-License-Identifier: MIT

// ---- What the pointer is at: a thing is { kind: 'object' | 'keyframe' | 'match', index }
class Pointing {
  constructor(scene, state) { Object.assign(this, { scene, state }); }

  // Of what is shown: matches and key frames before the objects that they run through.
  at(x, y) {
    return this.keyframe(x, y, 6) ?? this.match(x, y, 5) ?? this.object(x, y) ??
      this.keyframe(x, y, 12);
  }

  keyframe(x, y, reach) {
    const { scene, state } = this;
    if (!state.showKeyframes) return null;
    let best = null;
    for (const index of state.shownKeyframes) {
      const place = scene.onScreen(pointAt(scene.map.camera, index));
      if (!place) continue;
      const off = Math.hypot(place[0] - x, place[1] - y);
      if (off < reach && (!best || place[2] < best.depth)) best = { index, depth: place[2] };
    }
    return best && { kind: 'keyframe', index: best.index };
  }

  match(x, y, reach) {
    const { scene, state } = this;
    const { map } = scene;
    let best = null;
    for (const index of state.shownMatches) {
      const match = map.matches[index];
      const [a, b] = [map.queryPlace(match), pointAt(map.camera, match.candidate)];
      const points = [0, 1, 2, 3, 4, 5, 6, 7, 8].map((i) =>
        scene.onScreen(bowed(a, b, bowShare, i / 8)));
      for (let i = 0; i < 8; ++i) {
        if (!points[i] || !points[i + 1]) continue;
        const off = this.offSegment([x, y], points[i], points[i + 1]);
        if (off < (best?.off ?? reach)) best = { index, off };
      }
    }
    return best && { kind: 'match', index: best.index };
  }

  offSegment(p, a, b) {
    const [dx, dy] = [b[0] - a[0], b[1] - a[1]];
    const along = ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / (dx * dx + dy * dy || 1);
    const share = Math.min(Math.max(along, 0), 1);
    return Math.hypot(a[0] + share * dx - p[0], a[1] + share * dy - p[1]);
  }

  // The first box that the ray through the pixel meets.
  object(x, y) {
    const { scene, state } = this;
    const { map, camera } = scene;
    const ray = camera.rayThrough(x, y);
    const eye = camera.eye;
    let best = null;
    for (const index of state.shownObjects) {
      const far = this.meets(eye, ray, index, map);
      if (far !== null && (!best || far < best.far)) best = { index, far };
    }
    return best && { kind: 'object', index: best.index };
  }

  // How far along the ray a box begins; nothing where it is missed.
  meets(eye, ray, index, map) {
    const [hx, hy] = [map.heading[2 * index], map.heading[2 * index + 1]];
    const off = sub(eye, pointAt(map.position, index));
    const from = [off[0] * hx + off[1] * hy, off[1] * hx - off[0] * hy, off[2]];
    const along = [ray[0] * hx + ray[1] * hy, ray[1] * hx - ray[0] * hy, ray[2]];
    let [enter, leave] = [0, Infinity];
    for (let axis = 0; axis < 3; ++axis) {
      const half = map.half[3 * index + axis];
      const one = (-half - from[axis]) / along[axis];
      const other = (half - from[axis]) / along[axis];
      enter = Math.max(enter, Math.min(one, other));
      leave = Math.min(leave, Math.max(one, other));
    }
    return enter <= leave ? enter : null;
  }
}
