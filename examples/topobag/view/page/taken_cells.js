// SPDX-License-Identifier: MIT

// ---- Which small squares of the picture something is drawn at already
class TakenCells {
  constructor(cellSize) { Object.assign(this, { cellSize, cells: new Uint8Array(0) }); }

  // None, of a picture.
  clear(frame) {
    const [wide, tall] = frame.viewport;
    Object.assign(this, { toClip: frame.toClip,
      columns: Math.ceil(wide / this.cellSize), rows: Math.ceil(tall / this.cellSize) });
    const count = this.columns * this.rows;
    if (this.cells.length < count) this.cells = new Uint8Array(count);
    else this.cells.fill(0, 0, count);
  }

  // Takes the square where a point falls; false where it was taken, or is beside the picture.
  take(x, y, z) {
    const m = this.toClip;
    const w = m[3] * x + m[7] * y + m[11] * z + m[15];
    const right = (m[0] * x + m[4] * y + m[8] * z + m[12]) / w;
    const up = (m[1] * x + m[5] * y + m[9] * z + m[13]) / w;
    if (!(w > 0 && Math.abs(right) < 1 && Math.abs(up) < 1)) return false;
    const column = Math.floor((right + 1) / 2 * this.columns);
    const cell = Math.floor((1 - up) / 2 * this.rows) * this.columns + column;
    if (this.cells[cell]) return false;
    this.cells[cell] = 1;
    return true;
  }
}
