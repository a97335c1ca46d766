// SPDX-License-Identifier: MIT

// ---- The eye that circles a target; drag, wheel, fingers and keys move it
class OrbitCamera {
  constructor(canvas, onChange) {
    Object.assign(this, {
      canvas, onChange, target: [0, 0, 0], distance: 5, azimuth: -2.2, elevation: 0.6,
      angle: 0.85, moved: 0, pointers: new Map(), flight: 0, covered: { left: 0, right: 0, bottom: 0 },
    });
    canvas.addEventListener('pointerdown', (event) => this.press(event));
    canvas.addEventListener('pointermove', (event) => this.drag(event));
    for (const end of ['pointerup', 'pointercancel']) {
      canvas.addEventListener(end, (event) => this.pointers.delete(event.pointerId));
    }
    canvas.addEventListener('contextmenu', (event) => event.preventDefault());
    canvas.addEventListener('wheel', (event) => {
      event.preventDefault();
      this.zoom(Math.exp(Math.min(Math.max(event.deltaY, -200), 200) * 0.0015));
    }, { passive: false });
  }

  get away() {
    const level = Math.cos(this.elevation);
    return [level * Math.cos(this.azimuth), level * Math.sin(this.azimuth),
      Math.sin(this.elevation)];
  }

  get eye() { return add(this.target, scaled(this.away, this.distance)); }

  // To the right, up the page and towards the reader.
  get axes() {
    const right = [-Math.sin(this.azimuth), Math.cos(this.azimuth), 0];
    return [right, cross(this.away, right), this.away];
  }

  // By how much the target is off the canvas' middle, as a share of its half: so much is covered.
  get shift() {
    const { left, right, bottom } = this.covered;
    return [(left - right) / this.canvas.clientWidth, bottom / this.canvas.clientHeight];
  }

  get toClip() {
    const [near, far] = [this.distance * 0.02, this.distance * 60];
    const aspect = this.canvas.clientWidth / this.canvas.clientHeight;
    const matrix = matrixProduct(perspective(this.angle, aspect, near, far),
      lookingAt(this.eye, ...this.axes));
    const [right, up] = this.shift;
    for (let column = 0; column < 16; column += 4) {
      matrix[column] += right * matrix[column + 3];
      matrix[column + 1] += up * matrix[column + 3];
    }
    return matrix;
  }

  // The unit vector from the eye through a pixel of the canvas.
  rayThrough(x, y) {
    const { clientWidth, clientHeight } = this.canvas;
    const [shiftRight, shiftUp] = this.shift;
    const tall = Math.tan(this.angle / 2);
    const across = (2 * x / clientWidth - 1 - shiftRight) * tall * clientWidth / clientHeight;
    const [right, up, back] = this.axes;
    return unit(add(add(scaled(right, across),
      scaled(up, (1 - 2 * y / clientHeight - shiftUp) * tall)), scaled(back, -1)));
  }

  changed() {
    this.flight = 0;
    this.onChange();
  }

  turn(right, up) {
    this.azimuth -= right;
    this.elevation = Math.min(Math.max(this.elevation + up, -0.2), 1.5607);
    this.changed();
  }

  zoom(factor) {
    this.distance = Math.min(Math.max(this.distance * factor, 0.05), 1e5);
    this.changed();
  }

  // Moves the target so that the picture follows by so many px.
  pan(right, down) {
    const perPixel = 2 * this.distance * Math.tan(this.angle / 2) / this.canvas.clientHeight;
    const [toRight, upwards] = this.axes;
    this.target = add(this.target,
      add(scaled(toRight, -right * perPixel), scaled(upwards, down * perPixel)));
    this.changed();
  }

  press(event) {
    this.canvas.setPointerCapture(event.pointerId);
    this.pointers.set(event.pointerId, [event.clientX, event.clientY]);
    if (this.pointers.size === 1) this.moved = 0;
  }

  drag(event) {
    const before = this.pointers.get(event.pointerId);
    if (!before) return;
    const now = [event.clientX, event.clientY];
    const [right, down] = [now[0] - before[0], now[1] - before[1]];
    this.moved += Math.abs(right) + Math.abs(down);
    this.pointers.set(event.pointerId, now);
    if (this.pointers.size === 2) {
      const [other] = [...this.pointers].filter(([id]) => id !== event.pointerId).map((p) => p[1]);
      const apart = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1]) || 1;
      this.zoom(apart(before, other) / apart(now, other));
      this.pan(right / 2, down / 2);
    } else if (event.buttons & 6 || event.shiftKey) {
      this.pan(right, down);
    } else {
      this.turn(right * 0.006, down * 0.006);
    }
  }

  // Whether the pointer has gone too far for a click.
  get dragged() { return this.moved > 5; }

  // Goes there, at once where the reader wants no motion.
  flyTo({ target = this.target, distance = this.distance, elevation = this.elevation,
    azimuth = this.azimuth, right = 0 }) {
    const from = [...this.target, Math.log(this.distance), this.elevation, this.azimuth,
      this.covered.right];
    const to = [...target, Math.log(distance), elevation, azimuth, right];
    const flight = this.flight = Math.random();
    const begun = performance.now();
    const length = matchMedia('(prefers-reduced-motion: reduce)').matches ? 1 : 350;
    const step = (now) => {
      if (this.flight !== flight) return;
      const share = Math.min(Math.max((now - begun) / length, 0), 1);
      const at = mix(from, to, share * share * (3 - 2 * share));
      this.target = at.slice(0, 3);
      this.distance = Math.exp(at[3]);
      [this.elevation, this.azimuth, this.covered.right] = at.slice(4);
      this.onChange();
      if (share < 1) requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
  }
}
