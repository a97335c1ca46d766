// SPDX-License-Identifier: MIT

// ---- Time: a slider over the key frames, and which part of the map is looked at
class Timeline {
  constructor(map, state, showPart) {
    Object.assign(this, { map, state, showPart, playing: 0 });
    for (const id of ['slider', 'play', 'when', 'ticks', 'build', 'part', 'parts']) {
      this[id] = document.getElementById(id);
    }
    this.slider.addEventListener('input', () => this.go(Number(this.slider.value)));
    this.play.addEventListener('click', () => this.toggle());
    this.build.addEventListener('change', () => state.change({ buildUp: this.build.checked }));
    this.parts.hidden = map.partStarts.length < 2;
    document.getElementById('part-before').addEventListener('click', () => this.stepPart(-1));
    document.getElementById('part-after').addEventListener('click', () => this.stepPart(1));
  }

  // Chooses a key frame, whatever was chosen before.
  go(keyframe) {
    const index = Math.min(Math.max(keyframe, 0), this.map.keyframeCount - 1);
    const chosen = this.state.chosen?.kind === 'keyframe' ? { kind: 'keyframe', index } :
      this.state.chosen?.kind === 'match' ? null : this.state.chosen;
    this.state.change({ keyframe: index, chosen });
  }

  step(by) { this.go(this.state.keyframe + by); }

  stepPart(by) {
    const { map, state } = this;
    const count = map.partStarts.length;
    const part = (map.partOf(state.keyframe) + by + count) % count;
    this.go(map.keyframesOf(part)[1] - 1);
    this.showPart(part);
  }

  // From the beginning of the part, where it is at its end; a part in twenty seconds.
  toggle() {
    if (this.playing) return this.stop();
    const [begin, end] = this.map.keyframesOf(this.map.partOf(this.state.keyframe));
    if (this.state.keyframe >= end - 1) this.go(begin);
    const from = this.state.keyframe;
    const perSecond = Math.min(Math.max((end - begin) / 20, 4), 60);
    const begun = performance.now();
    const step = (now) => {
      if (!this.playing) return;
      const at = Math.min(from + Math.floor((now - begun) / 1000 * perSecond), end - 1);
      if (at !== this.state.keyframe) this.go(at);
      if (at === end - 1) this.stop();
      else this.playing = requestAnimationFrame(step);
    };
    this.playing = requestAnimationFrame(step);
    this.play.textContent = 'Pause';
  }

  stop() {
    cancelAnimationFrame(this.playing);
    this.playing = 0;
    this.play.textContent = 'Play';
  }

  draw() {
    const { map, state } = this;
    const part = map.partOf(state.keyframe);
    const [begin, end] = map.keyframesOf(part);
    Object.assign(this.slider, { min: begin, max: end - 1, value: state.keyframe });
    const text = `${map.name[state.keyframe]}, ${seconds(map.elapsed(state.keyframe))}`;
    this.when.textContent = text;
    this.slider.setAttribute('aria-valuetext', text);
    this.part.textContent = `Part ${part + 1} of ${map.partStarts.length}`;
    this.drawTicks(begin, end);
  }

  // A tick for each key frame of the part that was recognised.
  drawTicks(begin, end) {
    if (this.tickedPart === begin) return;
    this.tickedPart = begin;
    this.ticks.replaceChildren();
    for (const match of this.map.matches) {
      const at = match.query ?? match.candidate;
      if (at < begin || at >= end) continue;
      const tick = this.ticks.appendChild(document.createElement('i'));
      tick.style.left = `${100 * (at - begin) / Math.max(end - 1 - begin, 1)}%`;
      tick.style.background = `var(--${verdictOf(match).color})`;
    }
  }
}
