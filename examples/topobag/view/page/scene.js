// SPDX-License-Identifier: MIT

// ---- What is drawn, and where it falls on the canvas
class Scene {
  constructor(canvas, map, camera) {
    Object.assign(this, { canvas, map, camera });
    const gl = canvas.getContext('webgl2', { antialias: false, alpha: false });
    if (!gl) throw new Error('This browser has no WebGL 2, which the view is drawn with.');
    this.gl = gl;
    this.boxes = new BoxFaces(gl);
    this.cones = new ViewCones(gl);
    this.fine = new FineTarget(gl);
    this.path = new PathLine(gl);
    this.arcs = new LineStrips(gl, 14, bowShare);
    this.chosen = new LineStrips(gl, 1);
    this.grid = new GroundGrid(gl);
    gl.enable(gl.DEPTH_TEST);
    gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
  }

  // The colors of the style sheet, after each change of theme.
  readColors(dark) {
    this.classColors = classColors(this.map.countOf, dark);
    this.colors = {};
    for (const name of ['page', 'grid', 'path', 'cone', 'text', 'accent', 'good', 'loose', 'bad']) {
      this.colors[name] = styleColor(name);
    }
  }

  resize(share) {
    const { canvas } = this;
    const sharp = share * Math.min(devicePixelRatio || 1, 2);
    const [width, height] = [canvas.clientWidth, canvas.clientHeight].map((n) =>
      Math.max(1, Math.round(n * sharp)));
    if (canvas.width !== width || canvas.height !== height) {
      Object.assign(canvas, { width, height });
    }
    return sharp;
  }

  // One picture of the map as the camera sees it now.
  prepare(quick) {
    const sharp = this.resize(quick ? 0.5 : 1);
    const { canvas, camera, map } = this;
    const m = this.toClip = camera.toClip;
    const [x, y] = camera.target;
    return {
      toClip: m, sharp, quick, eye: camera.eye, image: map.image,
      coneLength: map.coneLength, viewport: [canvas.clientWidth, canvas.clientHeight],
      pixelAngle: 2 * Math.tan(camera.angle / 2) / canvas.clientHeight,
      middle: [x, y, map.floor], reach: camera.distance * 2.2,
      cell: roundLength(camera.distance / 6), lineColor: this.colors.grid,
      // How far a ball's centre is along the line of sight, m; 0 where none of it is in the picture.
      depthInView(x, y, z, radius) {
        const w = m[3] * x + m[7] * y + m[11] * z + m[15];
        if (w < -radius) return 0;
        const room = Math.abs(w) + 2.5 * radius;
        if (Math.abs(m[0] * x + m[4] * y + m[8] * z + m[12]) > room) return 0;
        if (Math.abs(m[1] * x + m[5] * y + m[9] * z + m[13]) > room) return 0;
        return w || 1e-9;
      },
      uniforms(names) { return Object.fromEntries(names.map((name) => [name, this[name]])); },
    };
  }

  draw(quick) {  // see Pace
    const { gl, canvas } = this;
    const frame = this.prepare(quick);
    if (!quick) this.fine.begin(canvas.width, canvas.height);
    gl.viewport(0, 0, canvas.width, canvas.height);
    gl.clearColor(...this.colors.page, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    this.boxes.draw(frame);
    gl.enable(gl.BLEND);
    this.grid.draw(frame);
    for (const lines of [this.path, this.cones, this.arcs, this.chosen]) lines.draw(frame);
    gl.disable(gl.BLEND);
    if (!quick) this.fine.end();
    return frame;
  }

  // Where a point falls on the canvas, px from its upper left corner, and how far off it is, m;
  // nothing behind the eye.
  onScreen([x, y, z]) {
    const m = this.toClip;
    const w = m[3] * x + m[7] * y + m[11] * z + m[15];
    if (w <= 0) return null;
    const across = (m[0] * x + m[4] * y + m[8] * z + m[12]) / w;
    const up = (m[1] * x + m[5] * y + m[9] * z + m[13]) / w;
    return [(across + 1) / 2 * this.canvas.clientWidth, (1 - up) / 2 * this.canvas.clientHeight, w];
  }
}
