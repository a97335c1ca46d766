// SPDX-License-Identifier: MIT

// ---- How fine a picture is: at rest as fine as can be, and in motion as well, unless pictures then
// follow each other too slowly: then it has fewer pixels, and
// no names but those of what is chosen
class Pace {
  constructor() { Object.assign(this, { last: 0, slowOnes: 0, slow: false }); }

  // Whether the next picture has to be a quick one.
  step(now, atRest) {
    const motion = 500, slowest = 34;  // ms
    const gap = now - this.last;
    this.last = now;
    if (gap < motion && !atRest) this.slowOnes = gap > slowest ? this.slowOnes + 1 : 0;
    if (this.slowOnes > 4) this.slow = true;
    return this.slow && !atRest;
  }
}
