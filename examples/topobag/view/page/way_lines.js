// SPDX-License-Identifier: MIT

// ---- The lines of the whole map: the camera's way with its key frames, and the matches' arcs
class WayLines {
  constructor(scene, state) { Object.assign(this, { scene, state, map: scene.map }); }

  fill() {
    this.fillPath();
    this.fillArcs();
  }

  fillPath() {
    const { scene, state, map } = this;
    const quiet = state.chosen?.kind === 'match' ? 0.3 : 1;
    const cones = state.showKeyframes ? state.shownKeyframes.map((i) => ({
      place: pointAt(map.camera, i), turn: map.rotation.subarray(4 * i, 4 * i + 4),
      color: [...scene.colors.cone, 0.7 * quiet],
    })) : [];
    const queries = state.shownMatches.map((i) => map.matches[i]).filter((m) => m.query === null);
    cones.push(...queries.map((match) => ({ place: match.camera, turn: match.turn,
      color: [...scene.colors[verdictOf(match).color], quiet] })));
    scene.cones.fill(cones);
    const starts = new Set(map.partStarts);
    scene.path.fill(state.showKeyframes ? state.shownKeyframes.map((i) => (
      { place: pointAt(map.camera, i), begins: starts.has(i) })) : [],
    [...scene.colors.path, quiet], 2);
  }

  fillArcs() {
    const { scene, state, map } = this;
    const chosen = state.chosen?.kind === 'match' ? state.chosen.index : null;
    const usual = Math.min(0.85, Math.max(0.35, 4 / Math.sqrt(state.shownMatches.length)));
    scene.arcs.fill(state.shownMatches.map((i) => {
      const match = map.matches[i];
      const { color, dash } = verdictOf(match);
      const opacity = chosen === null ? usual : chosen === i ? 1 : 0.12;
      return { a: map.queryPlace(match), b: pointAt(map.camera, match.candidate), dash,
        color: [...scene.colors[color], opacity], width: chosen === i ? 3 : 1.6 };
    }));
  }
}
