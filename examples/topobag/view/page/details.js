// SPDX-License-Identifier: MIT

// ---- The card that tells of what is chosen
const element = (tag, properties = {}, ...children) => {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...children.filter((child) => child !== null));
  return made;
};
const metres = (value) => `${value.toFixed(value < 10 ? 2 : 1)} m`;
const seconds = (value) => `${value.toFixed(1)} s`;
const short = (value) => (Number.isInteger(value) ? value : value.toFixed(2)).toString();
const plural = (count, noun) => `${count.toLocaleString('en')} ${noun}${count === 1 ? '' : 's'}`;

// Text with powers of ten raised: 10^6.1.
const raised = (text) => text.split(/(10\^-?[\d.]*\d)/).map((part) => {
  const power = /^10\^(.*)$/.exec(part);
  return power ? element('span', {}, '10', element('sup', {}, power[1])) : part;
});

class Details {
  constructor(map, state) {
    Object.assign(this, { map, state });
    this.card = document.getElementById('details');
    this.body = document.getElementById('details-body');
    document.getElementById('close').addEventListener('click', () => state.choose(null));
  }

  draw() {
    const { chosen } = this.state;
    this.card.hidden = chosen === null;
    if (!chosen) return;
    const key = JSON.stringify(chosen);
    if (key === this.drawn) return;
    this.drawn = key;
    this.body.replaceChildren(...this[chosen.kind](chosen.index));
    this.body.scrollTop = 0;
  }

  numbers(rows) {
    return element('dl', {}, ...rows.flatMap(([name, value]) =>
      [element('dt', {}, name), element('dd', {}, value)]));
  }

  point(list, i) { return pointAt(list, i).map((v) => v.toFixed(2)).join(', ') + ' m'; }

  // A button that chooses another thing.
  link(text, thing) {
    const button = element('button', { className: 'link' }, text);
    button.addEventListener('click', () => this.state.choose(thing, true));
    return button;
  }

  keyframeLink(index) {
    return this.link(`${this.map.name[index]}, ${seconds(this.map.elapsed(index))}`,
      { kind: 'keyframe', index });
  }

  object(index) {
    const { map } = this;
    return [
      element('p', { className: 'kind' }, 'Object'),
      element('h2', {}, map.classes[map.label[index]]),
      this.numbers([
        ['Held by', plural(map.seen[index], 'key frame')],
        ['First', this.keyframeLink(map.first[index])],
        ['Last', this.keyframeLink(map.last[index])],
        ['Width × height in the image',
          `${map.size[2 * index].toFixed(2)} × ${map.size[2 * index + 1].toFixed(2)} m`],
        ['Position x, y, z', this.point(map.worldPosition, index)],
      ]),
    ];
  }

  keyframe(index) {
    const { map } = this;
    const counts = new Map();
    for (const object of map.objectsOf[index]) {
      const name = map.classes[map.label[object]];
      counts.set(name, (counts.get(name) ?? 0) + 1);
    }
    const related = map.matches.flatMap((match, i) =>
      (match.query === index || match.candidate === index ? [[match, i]] : []));
    return [
      element('p', { className: 'kind' }, 'Key frame'),
      element('h2', {}, map.name[index]),
      this.numbers([
        ['Time', `${map.time[index].toFixed(2)} s (${seconds(map.elapsed(index))} from the start)`],
        ['Camera x, y, z', this.point(map.worldCamera, index)],
        ['Graph', `${plural(map.objectsOf[index].length, 'object')}, ` +
          plural(map.edgesOf[index].length / 2, 'edge')],
        ['Objects', [...counts].map(([name, count]) => `${count} ${name}`).join(', ') || 'none'],
      ]),
      related.length ? element('h3', {}, 'Matches') : null,
      ...related.map(([match, i]) => element('p', {}, this.link(match.query === index ?
        `found at ${map.name[match.candidate]}` : `${match.name} was found here`,
      { kind: 'match', index: i }))),
    ].filter((part) => part !== null);
  }

  match(index) {
    const { map } = this;
    const match = map.matches[index];
    const { color, sign, text } = verdictOf(match);
    const badge = element('span', { className: 'badge' }, `${sign} ${text}`);
    badge.style.setProperty('--badge', `var(--${color})`);
    const rows = [
      ['Looked up', match.query === null ? match.name : this.keyframeLink(match.query)],
      ['Found at', this.keyframeLink(match.candidate)],
    ];
    if (match.translation_error_m !== undefined) {
      rows.push(['Off the true pose', `${metres(match.translation_error_m)}, ` +
        `${match.rotation_error_deg.toFixed(1)}°`]);
    }
    return [
      element('p', { className: 'kind' }, 'Match ', badge),
      element('p', { className: 'sentence' }, ...raised(match.sentence)),
      this.numbers(rows),
      element('h3', {}, 'What was asked of it'),
      this.table(['', 'has', 'asked'], match.stages.map((stage) => [stage.name,
        short(stage.value) + stage.unit, ('at_least' in stage ? '≥ ' : '≤ ') +
          short(stage.at_least ?? stage.at_most) + stage.unit])),
      element('h3', {}, `Objects that agree: ${match.matched.length}`),
      this.table(['', 'off by'], match.matched.map((object) => [object.object === null ?
        object.class : this.link(object.class, { kind: 'object', index: object.object }),
      metres(object.distance_m)])),
      element('h3', {}, `Expected and not seen: ${match.missing.length}`),
      element('p', {}, match.missing.map((object) => object.class).join(', ') || 'nothing'),
    ];
  }

  table(head, rows) {
    const row = (tag, cells) => element('tr', {}, ...cells.map((cell) => element(tag, {}, cell)));
    return element('table', {}, row('th', head), ...rows.map((cells) => row('td', cells)));
  }
}
