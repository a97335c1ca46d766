// SPDX-License-Identifier: MIT

// ---- The reader's switches, pointer and keys, but for those of the camera
class Input {
  constructor(page) {
    const { map, state, canvas, camera, pointing, lines, timeline, matchList } = page;
    Object.assign(this, { page, map, state, canvas, camera, pointing, lines, timeline, matchList,
      hint: document.getElementById('hint'), hoverAsked: false });
    this.listen((id) => document.getElementById(id));
  }

  listen(byId) {
    const { state, canvas } = this;
    for (const [id, name] of [['show-keyframes', 'showKeyframes'], ['show-names', 'showNames'],
      ['show-matches', 'showMatches']]) {
      byId(id).addEventListener('change', (event) => state.change({ [name]: event.target.checked }));
    }
    byId('least').addEventListener('input', (event) => {
      byId('least-value').textContent = event.target.value;
      state.change({ least: Number(event.target.value) });
    });
    byId('home').addEventListener('click', () => this.page.showPart(this.map.partOf(state.keyframe)));
    byId('above').addEventListener('click', () => this.page.seeFromAbove());
    byId('help').addEventListener('click', () => byId('keys').showModal());
    canvas.addEventListener('pointermove', (event) => this.hover(event));
    canvas.addEventListener('pointerleave', () => this.setHovered(null));
    canvas.addEventListener('click', (event) => {
      if (!this.camera.dragged) state.choose(this.pointing.at(event.offsetX, event.offsetY));
    });
    canvas.addEventListener('dblclick', (event) => {
      const thing = this.pointing.at(event.offsetX, event.offsetY);
      if (thing) state.choose(thing, true);
    });
    canvas.addEventListener('keydown', (event) => this.pressCanvas(event));
    addEventListener('keydown', (event) => this.press(event));
    addEventListener('resize', () => this.page.leaveRoom());
  }

  // Keys that mean the same everywhere but where one types.
  press(event) {
    if (event.target.matches('input[type=search]') || event.ctrlKey || event.metaKey) return;
    const keys = {
      '/': () => document.getElementById('search').focus(),
      '?': () => document.getElementById('keys').showModal(),
      n: () => this.timeline.step(1), p: () => this.timeline.step(-1),
      m: () => this.matchList.step(1), M: () => this.matchList.step(-1),
      h: () => this.page.showPart(this.map.partOf(this.state.keyframe)),
      t: () => this.page.seeFromAbove(),
      Escape: () => this.state.choose(null),
    };
    if (!(event.key in keys) || document.getElementById('keys').open) return;
    event.preventDefault();
    keys[event.key]();
  }

  pressCanvas(event) {
    const camera = this.camera;
    const arrows = { ArrowLeft: [1, 0], ArrowRight: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
    if (event.key in arrows) {
      const [right, down] = arrows[event.key];
      if (event.shiftKey) camera.pan(40 * right, 40 * down);
      else camera.turn(-0.12 * right, 0.08 * down);
    } else if (event.key === '+' || event.key === '=') camera.zoom(0.85);
    else if (event.key === '-') camera.zoom(1 / 0.85);
    else return;
    event.preventDefault();
  }

  hover(event) {
    if (this.camera.pointers.size || this.hoverAsked) return;
    this.hoverAsked = true;
    requestAnimationFrame(() => {
      this.hoverAsked = false;
      this.setHovered(this.pointing.at(event.offsetX, event.offsetY));
      this.hint.style.transform = `translate(${event.clientX + 14}px, ${event.clientY + 14}px)`;
    });
  }

  setHovered(thing) {
    if (JSON.stringify(thing) === JSON.stringify(this.state.hovered)) return;
    this.state.hovered = thing;
    this.canvas.style.cursor = thing ? 'pointer' : 'grab';
    this.hint.hidden = !thing;
    if (thing) this.hint.textContent = this.page.nameOf(thing);
    this.lines.fill();
    this.page.requestDraw();
  }
}
