// SPDX-License-Identifier: MIT

// ---- Key frames: what each camera sees, as a thin pyramid, where it is large enough in the picture
const leastCone = { fine: 4, quick: 10 };  // px

class ViewCones {
  constructor(gl) {
    this.shader = new Shader(gl, `${recordReader}
      uniform mat4 toClip;
      uniform vec4 image;
      uniform float coneLength;
      out vec4 ink;
      void main() {
        vec4 turn = record(16, 1);
        // From the eye to each corner, then from each corner to the next.
        int at = gl_VertexID % 16;
        int number = at < 8 ? at / 2 : (at / 2 + at % 2) % 4;
        bool tip = at < 8 && at % 2 == 0;
        vec3 corner = tip ? vec3(0) : coneLength * vec3(
          number == 0 || number == 3 ? image.x : image.z, number < 2 ? image.y : image.w, 1);
        vec3 t = 2.0 * cross(turn.xyz, corner);
        vec3 world = record(16, 0).xyz + corner + turn.w * t + cross(turn.xyz, t);
        gl_Position = toClip * vec4(world, 1);
        ink = record(16, 2);
      }`, `
      in vec4 ink;
      out vec4 pixel;
      void main() { pixel = ink; }`);
    this.shown = new Records(gl);
    this.cones = [];
    this.gl = gl;
  }

  // Each a place, a turn and a color with its opacity.
  fill(cones) { this.cones = cones; }

  draw(frame) {
    const numbers = this.shown.reserve(this.cones.length);
    const least = (frame.quick ? leastCone.quick : leastCone.fine) * frame.pixelAngle;
    let count = 0;
    for (const { place, turn, color } of this.cones) {
      const depth = frame.depthInView(place[0], place[1], place[2], 2 * frame.coneLength);
      if (depth === 0 || frame.coneLength / Math.abs(depth) < least) continue;
      const to = recordSize * count++;
      numbers.set(place, to);
      numbers.set(turn, to + 4);
      numbers.set(color, to + 8);
    }
    this.shown.send(count);
    this.shader.use(frame.uniforms(['toClip', 'image', 'coneLength']));
    this.shown.draw(this.gl.LINES, 16);
  }
}

// The edges of one pyramid as pairs of points, to draw it in thick lines.
const coneEdges = (map, place, turn, length) => {
  const [left, top, right, bottom] = map.image;
  const corners = [[left, top], [right, top], [right, bottom], [left, bottom]].map(([x, y]) =>
    add(place, rotated(turn, scaled([x, y, 1], length))));
  return corners.flatMap((corner, i) => [[place, corner], [corner, corners[(i + 1) % 4]]]);
};
