// SPDX-License-Identifier: MIT

// ---- Names beside objects: of what is chosen, then of what is large in the picture
const mostLabels = 28;
const leastSize = 16;  // px that an object has to be high to be named unasked

class Labels {
  constructor(layer, scene, state) {
    Object.assign(this, { layer, scene, state });
    this.pool = Array.from({ length: mostLabels + 30 }, () => {
      const label = document.createElement('span');
      label.hidden = true;
      return layer.appendChild(label);
    });
  }

  // A quick picture has no names but those of what is chosen.
  draw(frame, quick) {
    const { scene, state } = this;
    const taken = [];
    let used = 0;
    const place = (text, point, color, strong) => {
      const at = scene.onScreen(point);
      if (!at || used >= this.pool.length) return;
      const [x, onTop] = [Math.round(at[0]), Math.round(at[1])];
      const half = 3.6 * text.length + 14;
      let box, y = onTop + 22;
      const covered = () => taken.some((other) => box[0] < other[2] && other[0] < box[2] &&
        box[1] < other[3] && other[1] < box[3]);
      do {  // what has to be named goes above what is there
        y -= 22;
        box = [x - half, y - 20, x + half, y];
      } while (strong && y > 40 && covered());
      if (x < 0 || y < 0 || x > frame.viewport[0] || y > frame.viewport[1]) return;
      if (!strong && covered()) return;
      taken.push(box);
      const label = this.pool[used++];
      label.hidden = false;
      if (label.textContent !== text) label.textContent = text;
      label.style.transform = `translate(${x}px, ${y}px) translate(-50%, -100%)`;
      label.style.setProperty('--dot', color);
      label.className = strong ? 'strong' : '';
    };
    for (const { text, point, color } of state.marks) place(text, point, color, true);
    if (state.showNames && !quick) {
      for (const object of this.largest(frame)) {
        this.placeObject(place, object);
        if (used >= mostLabels) break;
      }
    }
    for (const label of this.pool.slice(used)) label.hidden = true;
  }

  placeObject(place, object) {
    const { map } = this.scene;
    const point = pointAt(map.position, object);
    point[2] += map.half[3 * object + 2];
    const label = map.label[object];
    place(map.classes[label], point, cssOf(this.scene.classColors[label]), false);
  }

  // The objects in the picture that are large enough, those of the chosen key frame first.
  largest(frame) {
    const { scene, state } = this;
    const { map } = scene;
    const m = scene.toClip;
    const found = [];
    const perAngle = 1 / frame.pixelAngle;
    for (const object of state.shownObjects) {
      const i = 3 * object;
      const [x, y, z] = [map.position[i], map.position[i + 1], map.position[i + 2]];
      const w = m[3] * x + m[7] * y + m[11] * z + m[15];
      if (w <= 0) continue;
      const size = (map.half[i] + map.half[i + 2]) / w * perAngle;
      const first = state.named.has(object);
      if (size < leastSize && !first || state.dimmed(object)) continue;
      if (Math.abs(m[0] * x + m[4] * y + m[8] * z + m[12]) > w) continue;
      found.push([first ? 1e6 + size : size, object]);
    }
    return found.sort((a, b) => b[0] - a[0]).slice(0, 4 * mostLabels).map(([, object]) => object);
  }
}
