// SPDX-License-Identifier: MIT

// ---- The floor: a grid of round metres around what is looked at, which fades away
class GroundGrid {
  constructor(gl) {
    this.shader = new Shader(gl, `
      uniform mat4 toClip;
      uniform vec3 middle;
      uniform float reach;
      out vec2 place;
      void main() {
        vec2 corner = vec2(gl_VertexID % 2, gl_VertexID / 2) * 2.0 - 1.0;
        place = corner * reach + middle.xy;
        gl_Position = toClip * vec4(place, middle.z, 1);
      }`, `
      in vec2 place;
      uniform vec3 middle;
      uniform float reach;
      uniform float cell;
      uniform vec3 lineColor;
      out vec4 pixel;
      void main() {
        vec2 at = place / cell;
        vec2 off = abs(fract(at - 0.5) - 0.5) / fwidth(at);
        float line = 1.0 - min(min(off.x, off.y), 1.0);
        float fade = 1.0 - smoothstep(0.2, 1.0, distance(place, middle.xy) / reach);
        pixel = vec4(lineColor, line * fade);
      }`);
    this.array = gl.createVertexArray();
    this.gl = gl;
  }

  draw(frame) {
    const gl = this.gl;
    this.shader.use(frame.uniforms(['toClip', 'middle', 'reach', 'cell', 'lineColor']));
    gl.bindVertexArray(this.array);
    gl.depthMask(false);
    gl.drawArrays(gl.TRIANGLE_STRIP, 0, 4);
    gl.depthMask(true);
  }
}

// The round length (1, 2 or 5 times a power of ten) next below.
const roundLength = (length) => {
  const power = 10 ** Math.floor(Math.log10(length));
  return power * ([5, 2].find((step) => step * power <= length) ?? 1);
};
