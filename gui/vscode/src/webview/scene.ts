/** The arm in 3D, by WebGL. */
import type { Arm } from 'pendant:arms';
import { meshes, places } from './bodies';
import { chain, looking, moved, perspective, turnedBy, type Matrix, type Vector } from './matrix';

const VERTEX = `#version 300 es
uniform mat4 view;
uniform mat4 body;
layout(location = 0) in vec3 place;
layout(location = 1) in vec3 normal;
out vec3 outward;
void main() {
  outward = mat3(body) * normal;
  gl_Position = view * body * vec4(place, 1.0);
}`;

const FRAGMENT = `#version 300 es
precision mediump float;
uniform vec4 colour;
uniform float lit;
in vec3 outward;
out vec4 pixel;
void main() {
  vec3 n = normalize(outward + vec3(0.0, 0.0, 1e-6));
  float sun = max(0.0, dot(n, normalize(vec3(0.4, -0.5, 0.75))));
  float light = mix(1.0, 0.45 + 0.16 * n.z + 0.45 * sun, lit);
  pixel = vec4(colour.rgb * light, colour.a);
}`;

const BODY = [0.8, 0.82, 0.85, 1] as const;
const BASE = [0.55, 0.58, 0.62, 1] as const;
const AXES = [
  [0.86, 0.27, 0.25, 1],
  [0.22, 0.66, 0.3, 1],
  [0.25, 0.47, 0.9, 1],
] as const;
const GRID_M = 0.2;

interface Part {
  readonly array: WebGLVertexArrayObject;
  readonly corners: number;
}

/** What is to be seen. */
export interface Sight {
  readonly joints: readonly number[];
  readonly tcp: readonly number[];
  /** Where the TCP has been, in the base frame. */
  readonly trail: readonly Vector[];
}

export class Scene {
  private readonly uniforms: { view: WebGLUniformLocation | null; body: WebGLUniformLocation | null; colour: WebGLUniformLocation | null; lit: WebGLUniformLocation | null };
  private readonly bodies: readonly Part[];
  private readonly grid: Part;
  private readonly axes: readonly Part[];
  private trail: Part | undefined;
  private trailOf: readonly Vector[] | undefined;
  /** Where the eye is, rad. */
  private azimuth = -0.9;
  private elevation = 0.35;
  private distance: number;

  /** @throws Error where the page has no WebGL */
  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly arm: Arm,
  ) {
    const gl = canvas.getContext('webgl2', { antialias: true });
    if (gl === null) {
      throw new Error('no WebGL');
    }
    this.gl = gl;
    const program = link(gl);
    gl.useProgram(program);
    this.uniforms = {
      view: gl.getUniformLocation(program, 'view'),
      body: gl.getUniformLocation(program, 'body'),
      colour: gl.getUniformLocation(program, 'colour'),
      lit: gl.getUniformLocation(program, 'lit'),
    };
    gl.enable(gl.DEPTH_TEST);
    gl.enable(gl.BLEND);
    // The page's colour shines through: the picture has its colours multiplied by their alpha.
    gl.blendFuncSeparate(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA, gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    this.bodies = meshes(arm).map((mesh) => this.upload(mesh));
    this.grid = this.upload(floor(Math.ceil(arm.reachM / GRID_M) * GRID_M));
    const length = 0.12 * arm.reachM;
    this.axes = AXES.map((_, i) => this.upload(line([0, 0, 0], [i === 0 ? length : 0, i === 1 ? length : 0, i === 2 ? length : 0])));
    this.distance = 2.5 * arm.reachM;
  }

  private readonly gl: WebGL2RenderingContext;

  turn(right: number, up: number): void {
    this.azimuth -= right;
    this.elevation = Math.min(1.5, Math.max(-0.3, this.elevation + up));
  }

  zoom(factor: number): void {
    this.distance = Math.min(8 * this.arm.reachM, Math.max(0.8 * this.arm.reachM, this.distance * factor));
  }

  /** @param foreground red, green and blue of lines on the floor, 0 to 1 */
  draw(sight: Sight, foreground: Vector): void {
    const { gl } = this;
    const scale = window.devicePixelRatio;
    this.canvas.width = Math.max(1, Math.round(this.canvas.clientWidth * scale));
    this.canvas.height = Math.max(1, Math.round(this.canvas.clientHeight * scale));
    gl.viewport(0, 0, this.canvas.width, this.canvas.height);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.uniformMatrix4fv(this.uniforms.view, false, this.view());
    this.paint(this.grid, chain(), [...foreground, 0.2], gl.LINES);
    const where = places(this.arm, sight.joints);
    this.bodies.forEach((body, i) => this.paint(body, where[i] ?? chain(), i === 0 ? BASE : BODY, gl.TRIANGLES));
    if (sight.trail !== this.trailOf) {
      this.trailOf = sight.trail;
      this.trail = sight.trail.length < 2 ? undefined : this.upload(sight.trail.flatMap((each) => [...each, 0, 0, 1]));
    }
    if (this.trail !== undefined) {
      this.paint(this.trail, chain(), [0.95, 0.6, 0.15, 1], gl.LINE_STRIP);
    }
    const [x, y, z, rx, ry, rz] = sight.tcp;
    if (x !== undefined && y !== undefined && z !== undefined) {
      const tool = chain(moved(x, y, z), turnedBy([rx ?? 0, ry ?? 0, rz ?? 0]));
      gl.disable(gl.DEPTH_TEST);
      this.axes.forEach((axis, i) => this.paint(axis, tool, AXES[i] ?? BODY, gl.LINES));
      gl.enable(gl.DEPTH_TEST);
    }
  }

  private view(): Matrix {
    const target: Vector = [0, 0, 0.32 * this.arm.reachM];
    const beside = this.distance * Math.cos(this.elevation);
    const eye: Vector = [
      target[0] + beside * Math.cos(this.azimuth),
      target[1] + beside * Math.sin(this.azimuth),
      target[2] + this.distance * Math.sin(this.elevation),
    ];
    const aspect = this.canvas.width / this.canvas.height;
    return chain(perspective(0.7, aspect, 0.05 * this.arm.reachM, 20 * this.arm.reachM), looking(eye, target));
  }

  private paint(part: Part, body: Matrix, colour: readonly number[], form: number): void {
    const { gl } = this;
    gl.uniformMatrix4fv(this.uniforms.body, false, body);
    gl.uniform4fv(this.uniforms.colour, colour);
    gl.uniform1f(this.uniforms.lit, form === gl.TRIANGLES ? 1 : 0);
    gl.bindVertexArray(part.array);
    gl.drawArrays(form, 0, part.corners);
  }

  private upload(mesh: readonly number[]): Part {
    const { gl } = this;
    const array = gl.createVertexArray();
    gl.bindVertexArray(array);
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(mesh), gl.STATIC_DRAW);
    gl.enableVertexAttribArray(0);
    gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 24, 0);
    gl.enableVertexAttribArray(1);
    gl.vertexAttribPointer(1, 3, gl.FLOAT, false, 24, 12);
    return { array, corners: mesh.length / 6 };
  }
}

function link(gl: WebGL2RenderingContext): WebGLProgram {
  const program = gl.createProgram();
  for (const [kind, text] of [
    [gl.VERTEX_SHADER, VERTEX],
    [gl.FRAGMENT_SHADER, FRAGMENT],
  ] as const) {
    const shader = gl.createShader(kind);
    if (shader === null) {
      throw new Error('no shader');
    }
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (gl.getProgramParameter(program, gl.LINK_STATUS) !== true) {
    throw new Error(gl.getProgramInfoLog(program) ?? 'the shaders cannot be linked');
  }
  return program;
}

function floor(reachM: number): number[] {
  const lines: number[] = [];
  const steps = Math.round(reachM / GRID_M);
  for (let i = -steps; i <= steps; i++) {
    lines.push(...line([i * GRID_M, -reachM, 0], [i * GRID_M, reachM, 0]));
    lines.push(...line([-reachM, i * GRID_M, 0], [reachM, i * GRID_M, 0]));
  }
  return lines;
}

function line(from: Vector, to: Vector): number[] {
  return [...from, 0, 0, 1, ...to, 0, 0, 1];
}
