// SPDX-License-Identifier: MIT

// ---- Key frames: what each camera sees, as a thin pyramid
class ViewCones {
  constructor(gl) {
    this.shader = new Shader(gl, `
      layout(location = 0) in vec3 place;
      layout(location = 1) in vec4 turn;
      layout(location = 2) in vec4 color;
      uniform mat4 toClip;
      uniform vec4 image;
      uniform float coneLength;
      out vec4 ink;
      int ends[16] = int[](0, 1, 0, 2, 0, 3, 0, 4, 1, 2, 2, 3, 3, 4, 4, 1);
      void main() {
        int end = ends[gl_VertexID];
        vec3 corner = end == 0 ? vec3(0) :
          vec3(end == 1 || end == 4 ? image.x : image.z, end < 3 ? image.y : image.w, 1);
        corner *= coneLength;
        vec3 t = 2.0 * cross(turn.xyz, corner);
        vec3 world = place + corner + turn.w * t + cross(turn.xyz, t);
        gl_Position = toClip * vec4(world, 1);
        ink = color;
      }`, `
      in vec4 ink;
      out vec4 pixel;
      void main() { pixel = ink; }`);
    this.instances = new Instances(gl, [3, 4, 4]);
    this.gl = gl;
  }

  // Each a place, a turn and a color with its opacity.
  fill(cones) {
    const numbers = new Float32Array(11 * cones.length);
    cones.forEach(({ place, turn, color }, i) => {
      numbers.set(place, 11 * i);
      numbers.set(turn, 11 * i + 3);
      numbers.set(color, 11 * i + 7);
    });
    this.instances.fill(numbers);
  }

  draw(frame) {
    this.shader.use(frame.uniforms(['toClip', 'image', 'coneLength']));
    this.instances.draw(this.gl.LINES, 16);
  }
}

// The edges of one pyramid as pairs of points, to draw it in thick lines.
const coneEdges = (map, place, turn, length) => {
  const [left, top, right, bottom] = map.image;
  const corners = [[left, top], [right, top], [right, bottom], [left, bottom]].map(([x, y]) =>
    add(place, rotated(turn, scaled([x, y, 1], length))));
  return corners.flatMap((corner, i) => [[place, corner], [corner, corners[(i + 1) % 4]]]);
};
