// SPDX-License-Identifier: MIT

// ---- Lines some pixels wide, straight or bowed upwards, dashed or not
const bowShare = 0.22;  // how high an arc rises, as a share of its length
const bowed = (a, b, bow, share) =>
  add(mix(a, b, share), [0, 0, 4 * share * (1 - share) * bow * norm(sub(b, a))]);

class LineStrips {
  constructor(gl, segments) {
    this.segments = segments;
    this.shader = new Shader(gl, `
      layout(location = 0) in vec3 a;
      layout(location = 1) in vec3 b;
      layout(location = 2) in vec4 color;
      layout(location = 3) in vec3 shape;  // width px, dash px, bow
      uniform mat4 toClip;
      uniform vec2 viewport;
      out vec4 ink;
      out float along;
      out float dash;
      vec4 at(float share) {
        vec3 point = mix(a, b, share);
        point.z += 4.0 * share * (1.0 - share) * shape.z * distance(a, b);
        return toClip * vec4(point, 1);
      }
      void main() {
        float segments = ${segments}.0;
        float step = float(gl_VertexID / 2);
        float side = gl_VertexID % 2 == 0 ? -1.0 : 1.0;
        vec4 here = at(step / segments);
        vec4 other = at((step + (step < segments ? 1.0 : -1.0)) / segments);
        float nearest = 1e-3;
        if (here.w < nearest && other.w > nearest) {
          here = mix(here, other, (nearest - here.w) / (other.w - here.w));
        }
        vec2 from = here.xy / here.w * viewport;
        vec2 to = other.xy / max(other.w, nearest) * viewport;
        vec2 direction = normalize(to - from + vec2(1e-6, 0)) * (step < segments ? 1.0 : -1.0);
        vec2 normal = vec2(-direction.y, direction.x);
        gl_Position = here;
        gl_Position.xy += side * shape.x * normal / viewport * here.w;
        gl_Position.z -= 1e-4 * here.w;
        vec4 start = at(0.0);
        along = length(from - start.xy / max(start.w, nearest) * viewport) / 2.0;
        dash = shape.y;
        ink = color;
      }`, `
      in vec4 ink;
      in float along;
      in float dash;
      out vec4 pixel;
      void main() {
        if (dash > 0.0 && mod(along, 2.0 * dash) > dash) discard;
        pixel = ink;
      }`);
    this.instances = new Instances(gl, [3, 3, 4, 3]);
    this.gl = gl;
  }

  // Each from a to b, with a color and its opacity; width and dash in px.
  fill(lines) {
    const numbers = new Float32Array(13 * lines.length);
    lines.forEach(({ a, b, color, width = 1.5, dash = 0, bow = 0 }, i) => {
      numbers.set(a, 13 * i);
      numbers.set(b, 13 * i + 3);
      numbers.set(color, 13 * i + 6);
      numbers.set([width, dash, bow], 13 * i + 10);
    });
    this.instances.fill(numbers);
  }

  draw(frame) {
    this.shader.use(frame.uniforms(['toClip', 'viewport']));
    this.instances.draw(this.gl.TRIANGLE_STRIP, 2 * (this.segments + 1));
  }
}
