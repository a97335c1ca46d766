// SPDX-License-Identifier: MIT

// ---- Objects: upright boxes. Of six faces three can be seen, and only these are drawn.
class BoxFaces {
  constructor(gl) {
    this.shader = new Shader(gl, `
      layout(location = 0) in vec3 center;
      layout(location = 1) in vec3 halfSize;
      layout(location = 2) in vec2 heading;
      layout(location = 3) in vec3 color;
      uniform mat4 toClip;
      uniform vec3 eye;
      uniform float pixelAngle;
      out vec3 base;
      out vec2 onFace;
      out vec2 border;
      vec2 corners[6] = vec2[](vec2(-1, -1), vec2(1, -1), vec2(1, 1),
                               vec2(-1, -1), vec2(1, 1), vec2(-1, 1));
      float shades[3] = float[](0.80, 0.90, 1.06);
      void main() {
        int axis = gl_VertexID / 6;
        vec2 corner = corners[gl_VertexID % 6];
        vec3 away = eye - center;
        vec3 seenFrom = vec3(dot(away.xy, heading),
                             dot(away.xy, vec2(-heading.y, heading.x)), away.z);
        float side = seenFrom[axis] < 0.0 ? -1.0 : 1.0;
        vec3 unit = axis == 0 ? vec3(side, corner) :
                    axis == 1 ? vec3(corner.x, side, corner.y) : vec3(corner, side);
        vec3 local = unit * halfSize;
        vec3 world = center + vec3(local.x * heading - local.y * vec2(heading.y, -heading.x),
                                   local.z);
        gl_Position = toClip * vec4(world, 1);
        base = color * shades[axis];
        onFace = corner;
        vec2 across = axis == 0 ? halfSize.yz : axis == 1 ? halfSize.xz : halfSize.xy;
        border = min(vec2(0.9), 1.4 * pixelAngle * length(away) / across);
      }`, `
      in vec3 base;
      in vec2 onFace;
      in vec2 border;
      uniform float dark;
      out vec4 pixel;
      void main() {
        vec2 inside = 1.0 - abs(onFace);
        bool edge = inside.x < border.x || inside.y < border.y;
        vec3 line = dark > 0.5 ? base * 0.55 : base * 0.62;
        pixel = vec4(edge ? line : base, 1);
      }`);
    this.instances = new Instances(gl, [3, 3, 2, 3]);
    this.gl = gl;
  }

  // The objects that are shown, each in its color.
  fill(map, shown, colorOf) {
    const numbers = new Float32Array(11 * shown.length);
    shown.forEach((object, i) => {
      numbers.set(map.position.subarray(3 * object, 3 * object + 3), 11 * i);
      numbers.set(map.half.subarray(3 * object, 3 * object + 3), 11 * i + 3);
      numbers.set(map.heading.subarray(2 * object, 2 * object + 2), 11 * i + 6);
      numbers.set(colorOf(object), 11 * i + 8);
    });
    this.instances.fill(numbers);
  }

  draw(frame) {
    this.shader.use(frame.uniforms(['toClip', 'eye', 'pixelAngle', 'dark']));
    this.instances.draw(this.gl.TRIANGLES, 18);
  }
}
