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

// Attributes that each instance has one of; a layout is the counts of numbers, in their order.
class Instances {
  constructor(gl, layout) {
    this.gl = gl;
    this.stride = layout.reduce((sum, size) => sum + size, 0);
    this.count = 0;
    this.array = gl.createVertexArray();
    this.buffer = gl.createBuffer();
    gl.bindVertexArray(this.array);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.buffer);
    let offset = 0;
    layout.forEach((size, place) => {
      gl.enableVertexAttribArray(place);
      gl.vertexAttribPointer(place, size, gl.FLOAT, false, 4 * this.stride, 4 * offset);
      gl.vertexAttribDivisor(place, 1);
      offset += size;
    });
  }

  // A Float32Array, or a list of numbers.
  fill(numbers, count = numbers.length / this.stride) {
    const gl = this.gl;
    this.count = count;
    gl.bindBuffer(gl.ARRAY_BUFFER, this.buffer);
    gl.bufferData(gl.ARRAY_BUFFER, Float32Array.from(numbers), gl.DYNAMIC_DRAW);
  }

  draw(mode, vertices) {
    if (this.count === 0) return;
    this.gl.bindVertexArray(this.array);
    this.gl.drawArraysInstanced(mode, 0, vertices, this.count);
  }
}
