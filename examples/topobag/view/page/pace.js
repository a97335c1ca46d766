// SPDX-License-Identifier: MIT

// ---- How fine a picture is: at rest as fine as can be, and in motion as well, unless pictures take
// too long: then it has fewer pixels, and no names but those of what is chosen
class Pace {
  constructor() { Object.assign(this, { slowOnes: 0, slow: false }); }

  // How long a picture took, ms: till the browser was ready for the next.
  add(taken) {
    const slowest = 34;
    this.slowOnes = taken > slowest ? this.slowOnes + 1 : 0;
    if (this.slowOnes > 4) this.slow = true;
  }
}
