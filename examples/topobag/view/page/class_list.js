// SPDX-License-Identifier: MIT

// ---- The legend: each class with its color and count, to show, hide and search
class ClassList {
  constructor(map, state, onChange) {
    Object.assign(this, { map, state, onChange });
    this.list = document.getElementById('classes');
    this.search = document.getElementById('search');
    this.found = document.getElementById('found');
    const ranked = map.classes.map((_, i) => i).sort((a, b) => map.countOf[b] - map.countOf[a]);
    this.rows = ranked.map((label) => this.row(label));
    this.search.addEventListener('input', () => this.filter());
    this.search.addEventListener('keydown', (event) => {
      if (event.key === 'Enter') this.next(event.shiftKey ? -1 : 1);
      if (event.key === 'Escape') {
        this.search.value = '';
        this.filter();
      }
    });
    document.getElementById('all').addEventListener('click', () => this.showAll(true));
    document.getElementById('none').addEventListener('click', () => this.showAll(false));
    this.filter();
  }

  row(label) {
    const item = this.list.appendChild(document.createElement('li'));
    const button = item.appendChild(document.createElement('button'));
    button.innerHTML = '<i class="swatch"></i><span></span><b></b>';
    button.querySelector('span').textContent = this.map.classes[label];
    button.querySelector('b').textContent = this.map.countOf[label].toLocaleString('en');
    button.title = 'Show or hide; double-click to show it alone';
    button.addEventListener('click', () => {
      this.show(label, this.state.hiddenClasses.has(label));
      this.onChange();
    });
    button.addEventListener('dblclick', () => {
      this.state.hiddenClasses = new Set(this.map.classes.keys());
      this.show(label, true);
      this.onChange();
    });
    return { label, item, button };
  }

  show(label, shown) {
    if (shown) this.state.hiddenClasses.delete(label);
    else this.state.hiddenClasses.add(label);
  }

  showAll(shown) {
    for (const { label, item } of this.rows) if (!item.hidden) this.show(label, shown);
    this.onChange();
  }

  // Rows, and in the picture objects, of classes whose name holds what was typed.
  filter() {
    const text = this.search.value.trim().toLowerCase();
    const has = (label) => this.map.classes[label].toLowerCase().includes(text);
    for (const { label, item } of this.rows) item.hidden = !has(label);
    this.state.sought = text ? new Set([...this.map.classes.keys()].filter(has)) : null;
    this.onChange();
  }

  next(step) {
    const { state, map } = this;
    const objects = state.shownObjects.filter((object) => !state.dimmed(object));
    if (!state.sought || objects.length === 0) return;
    const chosen = state.chosen?.kind === 'object' ? objects.indexOf(state.chosen.index) : -1;
    const index = chosen < 0 && step < 0 ? objects.length - 1 :
      (chosen + step + objects.length) % objects.length;
    state.choose({ kind: 'object', index: objects[index] }, true);
    this.found.textContent = `${index + 1} of ${objects.length}: ${map.classes[map.label[objects[index]]]}`;
  }

  draw(colors) {
    const { state } = this;
    for (const { label, button } of this.rows) {
      button.setAttribute('aria-pressed', String(!state.hiddenClasses.has(label)));
      button.style.setProperty('--swatch', cssOf(colors[label]));
    }
    const found = state.shownObjects.filter((object) => !state.dimmed(object)).length;
    this.found.textContent = state.sought ?
      `${found.toLocaleString('en')} found; Enter goes through them` : '';
  }
}
