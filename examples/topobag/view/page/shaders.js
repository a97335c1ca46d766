// SPDX-License-Identifier: MIT

// ---- WebGL: a program, its uniforms, and the numbers of its instances
class Shader {
  constructor(gl, vertex, fragment) {
    this.gl = gl;
    this.program = gl.createProgram();
    for (const [type, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
      const shader = gl.createShader(type);
      gl.shaderSource(shader, '#version 300 es\nprecision highp float;\n' + text);
      gl.compileShader(shader);
      gl.attachShader(this.program, shader);
    }
    gl.linkProgram(this.program);
    if (!gl.getProgramParameter(this.program, gl.LINK_STATUS)) {
      throw new Error(gl.getProgramInfoLog(this.program));
    }
    this.places = new Map();
  }

  // Sets uniforms by their names: a number, two to four numbers or a matrix.
  use(uniforms) {
    const gl = this.gl;
    gl.useProgram(this.program);
    for (const [name, value] of Object.entries(uniforms)) {
      if (!this.places.has(name)) {
        this.places.set(name, gl.getUniformLocation(this.program, name));
      }
      const place = this.places.get(name);
      if (typeof value === 'number') gl.uniform1f(place, value);
      else if (value.length === 16) gl.uniformMatrix4fv(place, false, value);
      else gl['uniform' + value.length + 'fv'](place, value);
    }
  }
}

// Many things of one kind, each of twelve numbers: three texels, which the vertex shader reads with
// `record(vertices of a thing, which of the three)`. Instanced drawing does the same, but drivers
// are slow at instances of few vertices.
const perRow = 512;
const recordSize = 12;
const recordReader = `
  uniform highp sampler2D records;
  vec4 record(int vertices, int part) {
    int thing = gl_VertexID / vertices;
    return texelFetch(records, ivec2(3 * (thing % ${perRow}) + part, thing / ${perRow}), 0);
  }`;

class Records {
  constructor(gl) {
    this.gl = gl;
    this.count = 0;
    this.numbers = new Float32Array(0);
    this.texture = gl.createTexture();
    this.array = gl.createVertexArray();
    gl.bindTexture(gl.TEXTURE_2D, this.texture);
    for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) {
      gl.texParameteri(gl.TEXTURE_2D, filter, gl.NEAREST);
    }
  }

  // Room for so many records, to be written and then sent.
  reserve(count) {
    const rows = Math.ceil(count / perRow);
    const length = rows * perRow * recordSize;
    if (this.numbers.length < length) this.numbers = new Float32Array(length);
    return this.numbers;
  }

  send(count) {
    const gl = this.gl;
    this.count = count;
    gl.bindTexture(gl.TEXTURE_2D, this.texture);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, 3 * perRow, Math.ceil(count / perRow), 0, gl.RGBA,
      gl.FLOAT, this.numbers);
  }

  draw(mode, vertices) {
    if (this.count === 0) return;
    this.gl.bindTexture(this.gl.TEXTURE_2D, this.texture);
    this.gl.bindVertexArray(this.array);
    this.gl.drawArrays(mode, 0, vertices * this.count);
  }
}
