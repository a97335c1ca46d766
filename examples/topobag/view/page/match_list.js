// SPDX-License-Identifier: MIT

// ---- The accepted matches, best first
const mostRows = 200;

class MatchList {
  constructor(map, state) {
    Object.assign(this, { map, state });
    this.section = document.getElementById('match-section');
    this.list = document.getElementById('matches');
    this.ranked = map.matches.map((_, i) => i).sort((a, b) =>
      map.matches[b].score - map.matches[a].score);
    this.section.hidden = map.json.looked_up === 0;
    document.getElementById('match-count').textContent =
      `${map.matches.length.toLocaleString('en')} of ${map.json.looked_up.toLocaleString('en')} ` +
      'key frames that could be looked up';
    this.addKinds();
    for (const index of this.ranked.slice(0, mostRows)) this.addRow(index);
    if (this.ranked.length > mostRows) {
      this.list.appendChild(document.createElement('li')).textContent =
        `and ${this.ranked.length - mostRows} more: click their lines, or press M`;
    }
  }

  // What the lines mean: those of the verdicts that occur.
  addKinds() {
    const kinds = document.getElementById('match-kinds');
    for (const [name, { color, dash, sign, text }] of Object.entries(verdicts)) {
      const count = this.map.matches.filter((match) => (match.verdict ?? 'accepted') === name).length;
      if (count === 0) continue;
      const item = kinds.appendChild(document.createElement('li'));
      item.innerHTML = `<svg viewBox="0 0 30 8" aria-hidden="true"><path d="M1 4h28" ` +
        `stroke="var(--${color})" stroke-dasharray="${dash ? dash / 2 : 'none'}"/></svg>`;
      item.append(`${sign} ${count.toLocaleString('en')} ${text}`);
    }
  }

  addRow(index) {
    const match = this.map.matches[index];
    const { color, sign, text } = verdictOf(match);
    const button = this.list.appendChild(document.createElement('li'))
      .appendChild(document.createElement('button'));
    button.dataset.match = index;
    button.innerHTML = `<i style="color: var(--${color})" title="${text}">${sign}</i><span></span><b></b>`;
    button.querySelector('span').textContent = `${match.name} → ${this.map.name[match.candidate]}`;
    button.querySelector('b').textContent = match.score.toFixed(1);
    button.addEventListener('click', () => this.state.choose({ kind: 'match', index }, true));
  }

  // The next or the previous one of those that are shown, by score.
  step(by) {
    const shown = new Set(this.state.shownMatches);
    const order = this.ranked.filter((index) => shown.has(index));
    if (order.length === 0) return;
    const at = this.state.chosen?.kind === 'match' ? order.indexOf(this.state.chosen.index) : -1;
    const index = order[at < 0 && by < 0 ? order.length - 1 : (at + by + order.length) % order.length];
    this.state.choose({ kind: 'match', index }, true);
  }

  draw() {
    const { chosen } = this.state;
    for (const button of this.list.querySelectorAll('button')) {
      const current = chosen?.kind === 'match' && Number(button.dataset.match) === chosen.index;
      button.setAttribute('aria-current', String(current));
      if (current) button.scrollIntoView({ block: 'nearest' });
    }
  }
}
