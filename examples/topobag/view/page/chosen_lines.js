// SPDX-License-Identifier: MIT

// ---- The lines of what is chosen: a key frame's graph, a match with its objects, a box's outline
class ChosenLines {
  constructor(scene, state) { Object.assign(this, { scene, state, map: scene.map }); }

  fill() {
    const { scene, state } = this;
    state.marks = [];
    const lines = state.chosen?.kind === 'match' ? this.ofMatch(state.chosen.index) :
      this.ofKeyframe(state.keyframe);
    for (const thing of [state.hovered, state.chosen]) {
      if (thing?.kind === 'object') lines.push(...this.outline(thing.index));
      if (thing?.kind === 'keyframe' && thing === state.hovered) {
        lines.push(...this.cone(thing.index, [...scene.colors.text, 1], 1));
      }
    }
    if (state.chosen?.kind === 'object') this.markObject(state.chosen.index);
    scene.chosen.fill(lines);
  }

  markObject(object) {
    const point = pointAt(this.map.position, object);
    point[2] += this.map.half[3 * object + 2];
    const label = this.map.label[object];
    this.state.marks.push({ text: this.map.classes[label], point,
      color: cssOf(this.scene.classColors[label]) });
  }

  cone(keyframe, color, larger) {
    const { map } = this;
    return coneEdges(map, pointAt(map.camera, keyframe),
      map.rotation.subarray(4 * keyframe, 4 * keyframe + 4), larger * map.coneLength)
      .map(([a, b]) => ({ a, b, color, width: 2 }));
  }

  ofKeyframe(keyframe) {
    const { map, scene } = this;
    const accent = scene.colors.accent;
    const lines = this.cone(keyframe, [...accent, 1], 1.6);
    const edges = map.edgesOf[keyframe];
    for (let i = 0; i < edges.length; i += 2) {
      lines.push({ a: pointAt(map.position, edges[i]), b: pointAt(map.position, edges[i + 1]),
        color: [...accent, 0.75], width: 1.6 });
    }
    const place = pointAt(map.camera, keyframe);
    for (const object of map.objectsOf[keyframe]) {
      lines.push({ a: place, b: pointAt(map.position, object), color: [...accent, 0.3], width: 1 });
    }
    return lines;
  }

  ofMatch(index) {
    const { map, scene, state } = this;
    const match = map.matches[index];
    const color = scene.colors[verdictOf(match).color];
    const lines = this.cone(match.candidate, [...scene.colors.text, 1], 1.6);
    const place = match.camera;
    const candidate = pointAt(map.camera, match.candidate);
    lines.push(...coneEdges(map, place, match.turn, 1.6 * map.coneLength)
      .map(([a, b]) => ({ a, b, color: [...color, 1], width: 2.5 })));
    for (const { object } of match.matched) {
      if (object === null) continue;
      const b = pointAt(map.position, object);
      lines.push({ a: place, b, color: [...color, 0.9], width: 1.6 });
      lines.push({ a: candidate, b, color: [...scene.colors.text, 0.5], width: 1, dash: 4 });
    }
    for (const { class: name, place: at } of match.missing) {
      const half = map.coneLength / 3;
      for (const [x, y] of [[half, half], [half, -half]]) {
        lines.push({ a: add(at, [-x, 0, -y]), b: add(at, [x, 0, y]),
          color: [...scene.colors.bad, 1], width: 2 });
      }
      state.marks.push({ text: `missing: ${name}`, point: add(at, [0, 0, half]),
        color: 'var(--bad)' });
    }
    state.marks.push({ text: 'now', point: place, color: cssOf(color) });
    state.marks.push({ text: 'in the map', point: candidate, color: 'var(--text)' });
    return lines;
  }

  outline(object) {
    const { map, scene } = this;
    const center = pointAt(map.position, object);
    const [hx, hy] = map.heading.subarray(2 * object, 2 * object + 2);
    const half = pointAt(map.half, object);
    const corner = (bits) => {
      const [x, y, z] = half.map((h, axis) => (bits >> axis & 1 ? h : -h));
      return add(center, [x * hx - y * hy, x * hy + y * hx, z]);
    };
    const lines = [];
    for (let from = 0; from < 8; ++from) {
      for (const axis of [1, 2, 4]) {
        if (from & axis) continue;
        lines.push({ a: corner(from), b: corner(from | axis),
          color: [...scene.colors.text, 1], width: 2 });
      }
    }
    return lines;
  }
}
