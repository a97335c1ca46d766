// SPDX-License-Identifier: MIT

// ---- What the reader has chosen, and what is shown because of it
class ViewState {
  constructor(map) {
    Object.assign(this, {
      map, hiddenClasses: new Set(), sought: null, least: 1, buildUp: false,
      showKeyframes: true, showMatches: true, showNames: true,
      keyframe: map.keyframesOf(0)[1] - 1, chosen: null, hovered: null,
      named: new Set(), matched: null, marks: [],
      onChange: () => {}, onChoice: () => {},
    });
    this.update();
  }

  change(values) {
    Object.assign(this, values);
    this.update();
    this.onChange();
  }

  // Chooses a thing, or none; `fly`: the picture moves to it.
  choose(thing, fly = false) {
    const values = { chosen: thing };
    if (thing?.kind === 'keyframe') values.keyframe = thing.index;
    this.change(values);
    this.onChoice(thing, fly);
  }

  update() {
    const { map } = this;
    const now = this.buildUp ? this.keyframe : Infinity;
    const all = (count) => Array.from({ length: count }, (_, i) => i);
    this.shownObjects = all(map.objectCount).filter((i) => map.seen[i] >= this.least &&
      map.first[i] <= now && !this.hiddenClasses.has(map.label[i]));
    this.shownKeyframes = all(map.keyframeCount).filter((i) => i <= now);
    this.shownMatches = this.showMatches ? all(map.matches.length).filter((i) =>
      (map.matches[i].query ?? map.matches[i].candidate) <= now) : [];
    const match = this.chosen?.kind === 'match' ? map.matches[this.chosen.index] : null;
    this.matched = match && new Set(match.matched.map(({ object }) => object));
    this.named = new Set(this.matched ?? map.objectsOf[this.keyframe]);
  }

  dimmed(object) {
    return this.matched ? !this.matched.has(object) :
      this.sought !== null && !this.sought.has(this.map.label[object]);
  }
}
