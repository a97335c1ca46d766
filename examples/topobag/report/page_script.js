// SPDX-License-Identifier: MIT
'use strict';
const read = (id) => JSON.parse(document.getElementById(id).textContent);
const report = read('report-data');
const drawn = read('drawn-data');

// ---- Numbers: tables in the page, CSV and JSON to keep
const csvField = (value) => {
  const text = value === null ? '' : String(value);
  return /[",\n]/.test(text) ? '"' + text.replaceAll('"', '""') + '"' : text;
};
const csv = (table) =>
  [table.columns, ...table.rows].map((row) => row.map(csvField).join(',')).join('\n') + '\n';

for (const link of document.querySelectorAll('a.download')) {
  link.addEventListener('click', () => {
    const table = link.dataset.table;
    const text = table ? csv(report.figures[table]) : JSON.stringify(report);
    const type = table ? 'text/csv' : 'application/json';
    link.href = 'data:' + type + ';charset=utf-8,' + encodeURIComponent(text);
  });
}

const rowsShown = 200;
const addCells = (tr, values, tag) => {
  for (const value of values) {
    const cell = tr.appendChild(document.createElement(tag));
    const number = typeof value === 'number' && !Number.isInteger(value);
    cell.textContent = value === null ? '' : number ? Number(value.toPrecision(5)) : value;
  }
};
for (const details of document.querySelectorAll('details[data-table]')) {
  details.addEventListener('toggle', () => {
    if (details.querySelector('table')) return;
    const { columns, rows } = report.figures[details.dataset.table];
    const box = details.appendChild(document.createElement('div'));
    const table = box.appendChild(document.createElement('table'));
    addCells(table.insertRow(), columns, 'th');
    for (const row of rows.slice(0, rowsShown)) addCells(table.insertRow(), row, 'td');
    if (rows.length > rowsShown) {
      box.append('and ' + (rows.length - rowsShown) + ' more rows in the CSV');
    }
  });
}

// ---- Matrices
const bytes = (text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
const color = (name) => getComputedStyle(document.documentElement).getPropertyValue('--' + name);
const TRUE_PLACE = 1, CORRECT = 2, IMPRECISE = 4, WRONG = 8, ACCEPTED = 16;

// Dark blue over gray to yellow: even steps of lightness, the same for color-blind readers.
const scale = [[0, 32, 81], [60, 77, 110], [127, 124, 117], [187, 175, 113], [253, 234, 69]];
const shade = (share) => {
  const at = Math.min(Math.max(share, 0), 1) * (scale.length - 1);
  const i = Math.min(Math.floor(at), scale.length - 2);
  return scale[i].map((low, k) => Math.round(low + (at - i) * (scale[i + 1][k] - low)));
};

class MatrixView {
  constructor(canvas, data) {
    this.canvas = canvas;
    this.data = data;
    this.scores = new Float32Array(bytes(data.scores).buffer);
    this.flags = bytes(data.flags);
    this.readout = canvas.parentElement.querySelector('.readout');
    this.rest = this.readout.textContent;
    this.left = 58; this.top = 8;
    const across = 500, tall = 560;
    const size = Math.min(across / data.columns, tall / data.rows);
    this.width = data.columns * size;
    this.height = data.rows * size;
    this.full = [this.left + this.width + 76, this.top + this.height + 46];
    canvas.style.maxWidth = this.full[0] + 'px';
    canvas.addEventListener('pointermove', (event) => this.point(event));
    canvas.addEventListener('pointerleave', () => { this.readout.textContent = this.rest; });
    this.draw();
  }

  number(score) { return Number((this.data.sign * score).toPrecision(4)); }

  draw() {
    const sharp = 2;
    const [width, height] = this.full;
    this.canvas.width = width * sharp;
    this.canvas.height = height * sharp;
    const g = this.canvas.getContext('2d');
    g.scale(sharp, sharp);
    this.cells(g);
    g.save();
    g.translate(this.left, this.top);
    g.scale(this.width / this.data.columns, this.height / this.data.rows);
    this.outline(g);
    g.restore();
    this.accepted(g);
    this.axes(g);
    this.bar(g);
  }

  cells(g) {
    const { rows, columns, low, high } = this.data;
    const image = new ImageData(columns, rows);
    this.scores.forEach((score, i) => {
      if (Number.isNaN(score)) return;
      image.data.set([...shade((score - low) / (high - low || 1)), 255], 4 * i);
    });
    const cells = document.createElement('canvas');
    cells.width = columns;
    cells.height = rows;
    cells.getContext('2d').putImageData(image, 0, 0);
    g.fillStyle = color('panel');
    g.fillRect(this.left, this.top, this.width, this.height);
    g.imageSmoothingEnabled = false;
    g.drawImage(cells, this.left, this.top, this.width, this.height);
  }

  // Around the regions of true places.
  outline(g) {
    const { rows, columns } = this.data;
    const inside = (r, c) => r >= 0 && c >= 0 && r < rows && c < columns &&
      (this.flags[r * columns + c] & TRUE_PLACE) !== 0;
    g.beginPath();
    for (let r = 0; r <= rows; ++r) {
      for (let c = 0; c <= columns; ++c) {
        if (inside(r, c) !== inside(r - 1, c)) { g.moveTo(c, r); g.lineTo(c + 1, r); }
        if (inside(r, c) !== inside(r, c - 1)) { g.moveTo(c, r); g.lineTo(c, r + 1); }
      }
    }
    const cell = this.width / columns;
    g.lineWidth = Math.min(1.6, 0.5 * cell + 0.5) / cell;
    g.strokeStyle = '#ff5a36';
    g.stroke();
  }

  // As small as the cells, but for what is wrong.
  accepted(g) {
    const { rows, columns } = this.data;
    const cell = this.width / columns;
    for (let i = 0; i < rows * columns; ++i) {
      const flags = this.flags[i];
      if ((flags & (CORRECT | IMPRECISE | WRONG | ACCEPTED)) === 0) continue;
      const x = this.left + (i % columns + 0.5) * cell;
      const y = this.top + (Math.floor(i / columns) + 0.5) * this.height / rows;
      const r = flags & WRONG ? 4 : Math.min(Math.max(0.8 * cell, 0.9), 3.5);
      g.beginPath();
      if (flags & WRONG) {
        g.moveTo(x - r, y - r); g.lineTo(x + r, y + r);
        g.moveTo(x - r, y + r); g.lineTo(x + r, y - r);
      } else if (flags & IMPRECISE) {
        g.moveTo(x - r, y + r); g.lineTo(x + r, y + r); g.lineTo(x, y - r); g.closePath();
      } else {
        g.arc(x, y, r, 0, 7);
      }
      g.lineWidth = r; g.strokeStyle = '#000'; g.stroke();
      g.lineWidth = r / 2; g.strokeStyle = '#fff'; g.stroke();
    }
  }

  axes(g) {
    const { rows, columns, block, row_names, column_names, row_label, column_label } = this.data;
    g.fillStyle = color('text');
    g.strokeStyle = color('quiet');
    g.lineWidth = 1;
    g.font = '12px system-ui, sans-serif';
    const step = (names, room) => {
      const least = names.length / Math.max(2, room / 55);
      return [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000].find((s) => s >= least) ||
        Math.ceil(least);
    };
    const bottom = this.top + this.height;
    const tick = (x1, y1, x2, y2) => {
      g.beginPath(); g.moveTo(x1, y1); g.lineTo(x2, y2); g.stroke();
    };
    g.textAlign = 'center';
    for (let i = 0; i < column_names.length; i += step(column_names, this.width)) {
      const x = this.left + (i + 0.5) / (columns * block) * this.width;
      tick(x, bottom, x, bottom + 4);
      g.fillText(column_names[i], x, bottom + 17);
    }
    g.textAlign = 'right';
    for (let i = 0; i < row_names.length; i += step(row_names, this.height)) {
      const y = this.top + (i + 0.5) / (rows * block) * this.height;
      tick(this.left - 4, y, this.left, y);
      g.fillText(row_names[i], this.left - 8, y + 4);
    }
    g.fillStyle = color('quiet');
    g.textAlign = 'center';
    g.fillText(column_label, this.left + this.width / 2, bottom + 37);
    g.save();
    g.translate(14, this.top + this.height / 2);
    g.rotate(-Math.PI / 2);
    g.fillText(row_label, 0, 0);
    g.restore();
  }

  bar(g) {
    const x = this.left + this.width + 14, tall = Math.min(this.height, 200);
    for (let i = 0; i < tall; ++i) {
      g.fillStyle = 'rgb(' + shade(1 - i / tall).join() + ')';
      g.fillRect(x, this.top + i, 12, 1.5);
    }
    g.fillStyle = color('text');
    g.textAlign = 'left';
    const { low, high, sign } = this.data;
    const decimals = Math.min(Math.max(2 - Math.floor(Math.log10(high - low || 1)), 0), 8);
    for (const share of [0, 0.5, 1]) {
      const y = this.top + (1 - share) * tall;
      const text = (sign * (low + share * (high - low))).toFixed(decimals);
      g.fillText(text, x + 17, Math.min(Math.max(y + 4, this.top + 10), this.top + tall));
    }
  }

  point(event) {
    const box = this.canvas.getBoundingClientRect();
    const shrink = this.full[0] / box.width;
    const { rows, columns, block, row_names, column_names } = this.data;
    const c = Math.floor(((event.clientX - box.left) * shrink - this.left) / this.width * columns);
    const r = Math.floor(((event.clientY - box.top) * shrink - this.top) / this.height * rows);
    if (r < 0 || c < 0 || r >= rows || c >= columns) {
      this.readout.textContent = this.rest;
      return;
    }
    const name = (names, i) => {
      const last = Math.min((i + 1) * block, names.length) - 1;
      return names[i * block] + (last > i * block ? '–' + names[last] : '');
    };
    const score = this.scores[r * columns + c];
    const flags = this.flags[r * columns + c];
    const said = [Number.isNaN(score) ? 'no score' :
      (block > 1 ? 'best ' : '') + this.data.score_label + ' ' + this.number(score)];
    if (flags & TRUE_PLACE) said.push('true place');
    if (flags & CORRECT) said.push('accepted: correct');
    if (flags & IMPRECISE) said.push('accepted: imprecise');
    if (flags & WRONG) said.push('accepted: wrong');
    if (flags & ACCEPTED) said.push('accepted');
    const extra = this.data.hints[r * columns + c];
    if (extra) said.push(extra);
    this.readout.textContent = 'query ' + name(row_names, r) + ', candidate ' +
      name(column_names, c) + ': ' + said.join(', ');
  }
}

const views = [...document.querySelectorAll('canvas.matrix')].map(
  (canvas) => new MatrixView(canvas, drawn[canvas.closest('figure').id]));
const redraw = () => views.forEach((view) => view.draw());
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', redraw);
addEventListener('beforeprint', redraw);
addEventListener('afterprint', redraw);
