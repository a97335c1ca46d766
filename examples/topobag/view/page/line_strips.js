// SPDX-License-Identifier: MIT

// ---- Lines some pixels wide, straight or bowed upwards, dashed or not
const bowShare = 0.22;  // how high an arc rises, as a share of its length
const bowed = (a, b, bow, share) =>
  add(mix(a, b, share), [0, 0, 4 * share * (1 - share) * bow * norm(sub(b, a))]);

class LineStrips {
  constructor(gl, segments, bow = 0) {
    Object.assign(this, { gl, bow, vertices: 6 * segments });
    this.shader = new Shader(gl, `${recordReader}
      const int segments = ${segments};
      uniform mat4 toClip;
      uniform vec2 viewport;
      uniform float bow;
      out vec4 ink;
      out float along;
      out float dash;
      void main() {
        vec4 from = record(6 * segments, 0), to = record(6 * segments, 1);
        vec3 a = from.xyz, b = to.xyz;
        float rise = 4.0 * bow * distance(a, b);
        int segment = gl_VertexID % (6 * segments) / 6, corner = gl_VertexID % 6;
        bool second = corner == 1 || corner == 3 || corner == 4;
        float side = corner == 2 || corner == 4 || corner == 5 ? 1.0 : -1.0;
        float here = float(segment + (second ? 1 : 0)) / float(segments);
        float there = float(segment + (second ? 0 : 1)) / float(segments);
        vec4 p = toClip * vec4(mix(a, b, here) + vec3(0, 0, here * (1.0 - here) * rise), 1);
        vec4 q = toClip * vec4(mix(a, b, there) + vec3(0, 0, there * (1.0 - there) * rise), 1);
        const float nearest = 1e-3;
        if (p.w < nearest && q.w > nearest) p = mix(p, q, (nearest - p.w) / (q.w - p.w));
        vec2 onScreen = p.xy / p.w * viewport;
        vec2 direction = q.xy / max(q.w, nearest) * viewport - onScreen;
        direction = normalize(direction + vec2(1e-6, 0)) * (second ? -1.0 : 1.0);
        gl_Position = p;
        gl_Position.xy += side * from.w * vec2(-direction.y, direction.x) / viewport * p.w;
        gl_Position.z -= 1e-4 * p.w;
        vec4 start = toClip * vec4(a, 1);
        along = length(onScreen - start.xy / max(start.w, nearest) * viewport) / 2.0;
        dash = to.w;
        ink = record(6 * segments, 2);
      }`, `
      in vec4 ink;
      in float along;
      in float dash;
      out vec4 pixel;
      void main() {
        if (dash > 0.0 && mod(along, 2.0 * dash) > dash) discard;
        pixel = ink;
      }`);
    this.records = new Records(gl);
  }

  // Each from a to b, with a color and its opacity; width and dash in px.
  fill(lines) {
    const numbers = this.records.reserve(lines.length);
    lines.forEach(({ a, b, color, width = 1.5, dash = 0 }, i) => {
      numbers.set([...a, width, ...b, dash, ...color], recordSize * i);
    });
    this.records.send(lines.length);
  }

  draw(frame) {
    this.shader.use({ ...frame.uniforms(['toClip', 'viewport']), bow: this.bow });
    this.records.draw(this.gl.TRIANGLES, this.vertices);
  }
}
