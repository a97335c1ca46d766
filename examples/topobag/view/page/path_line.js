// SPDX-License-Identifier: MIT

// ---- The camera's way, from key frame to key frame: a line that has no more corners than are seen
class PathLine {
  constructor(gl) {
    this.lines = new LineStrips(gl, 1);
    this.points = [];
  }

  // Places in their order, each { place, begins }: a part of the way begins there.
  fill(points, color, width) { Object.assign(this, { points, color, width }); }

  draw(frame) {
    this.select(frame);
    this.lines.draw(frame);
  }

  // Leaves out what is beside the picture, and corners that are hardly apart in it.
  select(frame) {
    const { points, color, width, lines: { records } } = this;
    const least = frame.quick ? 5 : 1;  // px
    const m = frame.toClip;
    const [wide, tall] = [frame.viewport[0] / 2, frame.viewport[1] / 2];
    const numbers = records.reserve(points.length);
    let count = 0, from = null, fromX = 0, fromY = 0, fromW = 0;
    for (let i = 0; i < points.length; ++i) {
      const { place, begins } = points[i];
      const [x, y, z] = place;
      const w = m[3] * x + m[7] * y + m[11] * z + m[15];
      const onX = m[0] * x + m[4] * y + m[8] * z + m[12];
      const onY = m[1] * x + m[5] * y + m[9] * z + m[13];
      if (begins || from === null) {
        [from, fromX, fromY, fromW] = [place, onX, onY, w];
        continue;
      }
      const last = i + 1 === points.length || points[i + 1].begins;
      if (!last && w > 0 && fromW > 0 && Math.abs(onX / w - fromX / fromW) * wide < least &&
        Math.abs(onY / w - fromY / fromW) * tall < least) continue;
      const beside = (onX > w && fromX > fromW) || (onX < -w && fromX < -fromW) ||
        (onY > w && fromY > fromW) || (onY < -w && fromY < -fromW);
      if (!beside) {
        const to = recordSize * count++;
        numbers.set(from, to);
        numbers[to + 3] = width;
        numbers.set(place, to + 4);
        numbers[to + 7] = 0;
        numbers.set(color, to + 8);
      }
      [from, fromX, fromY, fromW] = [place, onX, onY, w];
    }
    records.send(count);
  }
}
