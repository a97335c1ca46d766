// SPDX-License-Identifier: MIT

// ---- Where fine pictures are drawn: with four samples a pixel, which are then averaged. The canvas
// itself has one, so that quick pictures do not pay for what they can do without.
class FineTarget {
  constructor(gl) {
    const most = Math.max(0, ...gl.getInternalformatParameter(gl.RENDERBUFFER, gl.RGBA8, gl.SAMPLES));
    Object.assign(this, { gl, samples: Math.min(4, most), width: 0, height: 0 });
    [this.drawn, this.averaged] = [gl.createFramebuffer(), gl.createFramebuffer()];
    [this.color, this.depth, this.flat] = [0, 1, 2].map(() => gl.createRenderbuffer());
  }

  // The picture goes here from now on.
  begin(width, height) {
    const { gl } = this;
    if (this.width !== width || this.height !== height) this.resize(width, height);
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.drawn);
  }

  resize(width, height) {
    const { gl } = this;
    Object.assign(this, { width, height });
    const attach = (target, place, buffer, format, samples) => {
      gl.bindFramebuffer(gl.FRAMEBUFFER, target);
      gl.bindRenderbuffer(gl.RENDERBUFFER, buffer);
      gl.renderbufferStorageMultisample(gl.RENDERBUFFER, samples, format, width, height);
      gl.framebufferRenderbuffer(gl.FRAMEBUFFER, place, gl.RENDERBUFFER, buffer);
    };
    attach(this.drawn, gl.COLOR_ATTACHMENT0, this.color, gl.RGBA8, this.samples);
    attach(this.drawn, gl.DEPTH_ATTACHMENT, this.depth, gl.DEPTH_COMPONENT24, this.samples);
    attach(this.averaged, gl.COLOR_ATTACHMENT0, this.flat, gl.RGBA8, 0);
  }

  // The picture goes to the canvas. Its format may be another than that of many samples, so that it
  // takes two steps.
  end() {
    const { gl, width, height } = this;
    for (const [from, to] of [[this.drawn, this.averaged], [this.averaged, null]]) {
      gl.bindFramebuffer(gl.READ_FRAMEBUFFER, from);
      gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, to);
      gl.blitFramebuffer(0, 0, width, height, 0, 0, width, height, gl.COLOR_BUFFER_BIT, gl.NEAREST);
    }
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  }
}
