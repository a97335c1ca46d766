// SPDX-License-Identifier: MIT

// ---- Objects: upright boxes. Of six faces three can be seen, and only these are drawn; of a box
// that is a few pixels large, a point.
const leastBox = { fine: 5, quick: 9 };  // px

class BoxFaces {
  constructor(gl) {
    this.shader = new Shader(gl, `${recordReader}
      uniform mat4 toClip;
      uniform vec3 eye;
      uniform float pixelAngle;
      out vec3 base;
      out vec2 onFace;
      out vec2 border;
      void main() {
        vec4 place = record(18, 0), shape = record(18, 1);
        vec3 center = place.xyz, halfSize = vec3(place.w, shape.xy);
        vec2 heading = shape.zw;
        int axis = gl_VertexID % 18 / 6, at = gl_VertexID % 6;
        vec2 corner = vec2(at == 0 || at == 3 || at == 5 ? -1 : 1,
                           at == 0 || at == 1 || at == 3 ? -1 : 1);
        vec3 away = eye - center;
        vec3 seenFrom = vec3(dot(away.xy, heading),
                             dot(away.xy, vec2(-heading.y, heading.x)), away.z);
        vec3 side = vec3(seenFrom.x < 0.0 ? -1 : 1, seenFrom.y < 0.0 ? -1 : 1,
                         seenFrom.z < 0.0 ? -1 : 1);
        vec3 local = halfSize * (axis == 0 ? vec3(side.x, corner) :
                                 axis == 1 ? vec3(corner.x, side.y, corner.y) :
                                 vec3(corner, side.z));
        vec3 world = center + vec3(local.x * heading + local.y * vec2(-heading.y, heading.x),
                                   local.z);
        gl_Position = toClip * vec4(world, 1);
        base = record(18, 2).rgb * (axis == 0 ? 0.80 : axis == 1 ? 0.90 : 1.06);
        onFace = corner;
        vec2 across = axis == 0 ? halfSize.yz : axis == 1 ? halfSize.xz : halfSize.xy;
        border = min(vec2(0.3), 1.4 * pixelAngle * length(away) / across);
      }`, `
      in vec3 base;
      in vec2 onFace;
      in vec2 border;
      out vec4 pixel;
      void main() {
        vec2 inside = 1.0 - abs(onFace);
        bool edge = inside.x < border.x || inside.y < border.y;
        pixel = vec4(edge ? base * 0.6 : base, 1);
      }`);
    this.pointShader = new Shader(gl, `${recordReader}
      uniform mat4 toClip;
      uniform float sharp;
      out vec3 base;
      void main() {
        gl_Position = toClip * vec4(record(1, 0).xyz, 1);
        vec4 look = record(1, 2);
        gl_PointSize = max(look.w * sharp, 1.0);
        base = look.rgb;
      }`, `
      in vec3 base;
      out vec4 pixel;
      void main() { pixel = vec4(base, 1); }`);
    this.gl = gl;
    this.near = new Records(gl);
    this.far = new Records(gl);
    this.taken = new TakenCells(4);
    this.count = 0;
  }

  // The objects that are shown, each in its color.
  fill(map, shown, colorOf) {
    this.count = shown.length;
    this.all = new Float32Array(recordSize * shown.length);
    shown.forEach((object, i) => {
      const at = recordSize * i;
      this.all.set(map.position.subarray(3 * object, 3 * object + 3), at);
      this.all.set(map.half.subarray(3 * object, 3 * object + 3), at + 3);
      this.all.set(map.heading.subarray(2 * object, 2 * object + 2), at + 6);
      this.all.set(colorOf(object), at + 8);
    });
  }

  // Those in the picture, by how large they are in it; in a quick one, of points that fall together
  // the first.
  select(frame) {
    const { all } = this;
    const [near, far] = [this.near.reserve(this.count), this.far.reserve(this.count)];
    const least = frame.quick ? leastBox.quick : leastBox.fine;
    if (frame.quick) this.taken.clear(frame);
    let [nearCount, farCount] = [0, 0];
    for (let at = 0; at < recordSize * this.count; at += recordSize) {
      const reach = all[at + 3] + all[at + 4] + all[at + 5];
      const depth = frame.depthInView(all[at], all[at + 1], all[at + 2], reach);
      if (depth === 0) continue;
      const size = (all[at + 3] + all[at + 5]) / Math.abs(depth) / frame.pixelAngle;
      const list = size < least ? far : near;
      if (list === far && frame.quick && !this.taken.take(all[at], all[at + 1], all[at + 2])) continue;
      const to = recordSize * (list === far ? farCount++ : nearCount++);
      for (let k = 0; k < recordSize; ++k) list[to + k] = all[at + k];
      list[to + 11] = size;
    }
    this.near.send(nearCount);
    this.far.send(farCount);
  }

  draw(frame) {
    this.select(frame);
    this.shader.use(frame.uniforms(['toClip', 'eye', 'pixelAngle']));
    this.near.draw(this.gl.TRIANGLES, 18);
    this.pointShader.use(frame.uniforms(['toClip', 'sharp']));
    this.far.draw(this.gl.POINTS, 1);
  }
}
