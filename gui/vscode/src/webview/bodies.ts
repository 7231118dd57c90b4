/** Where the seven bodies of an arm are, and what they look like: cylinders, as `models` has them. */
import type { Arm } from 'pendant:arms';
import { IDENTITY, chain, moved, turnedX, turnedZ, type Matrix } from './matrix';

/** Twists of the Denavit-Hartenberg frames, the same for all arms. */
const TWISTS = [Math.PI / 2, 0, 0, Math.PI / 2, -Math.PI / 2, 0] as const;

/** Triangles: of each corner place and normal, six numbers. */
export type Mesh = number[];

/**
 * The places of base, shoulder, upper arm, forearm and the wrists in the base frame; the last one is the flange.
 *
 * @param joints positions, rad
 */
export function places(arm: Arm, joints: readonly number[]): Matrix[] {
  const { d1, a2, a3, d4, d5, d6 } = arm.dh;
  const offsets = [d1, 0, 0, d4, d5, d6];
  const lengths = [0, a2, a3, 0, 0, 0];
  const bodies: Matrix[] = [IDENTITY];
  let frame = IDENTITY;
  for (let i = 0; i < 6; i++) {
    // Upper arm and forearm have no offset: their bodies are at the turned frame itself.
    const body = chain(frame, turnedZ(joints[i] ?? 0), moved(0, 0, offsets[i] ?? 0));
    bodies.push(body);
    frame = chain(body, moved(lengths[i] ?? 0, 0, 0), turnedX(TWISTS[i] ?? 0));
  }
  return bodies;
}

/** The bodies in the order of their places. */
export function meshes(arm: Arm): Mesh[] {
  const { base, shoulder, upperArm, forearm, wrist1, wrist2, wrist3 } = arm.shape;
  const foot: Mesh = [];
  lathe(foot, 'z', 0, 0, [
    [0, base.footRadiusM],
    [0.12 * base.heightM, base.footRadiusM],
    [0.3 * base.heightM, base.topRadiusM],
    [base.heightM, base.topRadiusM],
  ]);
  return [foot, housing(shoulder), limb(upperArm), limb(forearm), housing(wrist1), housing(wrist2), housing(wrist3)];
}

function housing(of: Arm['shape']['shoulder']): Mesh {
  const mesh: Mesh = [];
  cylinder(mesh, 'z', 0, 0, of.alongZM, of.radiusM);
  cylinder(mesh, 'y', 0, 0, of.alongYM, of.radiusM);
  return mesh;
}

function limb(of: Arm['shape']['upperArm']): Mesh {
  const mesh: Mesh = [];
  const [near, middle, far] = of.tube.radiiM;
  cylinder(mesh, 'z', 0, 0, of.near.alongZM, of.near.radiusM);
  cylinder(mesh, 'z', -of.lengthM, 0, of.far.alongZM, of.far.radiusM);
  lathe(mesh, 'x', 0, of.tube.centreZM, [
    [-of.lengthM, far],
    [-of.lengthM / 2, middle],
    [0, near],
  ]);
  return mesh;
}

function cylinder(mesh: Mesh, axis: Axis, a: number, b: number, [from, to]: readonly [number, number], radius: number): void {
  const edge = Math.min(0.15 * radius, (to - from) / 4);
  lathe(mesh, axis, a, b, [
    [from, radius - edge],
    [from + edge, radius],
    [to - edge, radius],
    [to, radius - edge],
  ]);
}

type Axis = 'x' | 'y' | 'z';
const AROUND = 40;

/**
 * Turns a profile around an axis, with caps.
 *
 * @param a of an axis z or y its x, of an axis x its y
 * @param b of an axis z its y, else its z
 * @param profile places along the axis, with the radius there
 */
function lathe(mesh: Mesh, axis: Axis, a: number, b: number, profile: readonly (readonly [number, number])[]): void {
  const first = profile[0] ?? [0, 0];
  const last = profile[profile.length - 1] ?? [0, 0];
  const all = [[first[0], 0] as const, ...profile, [last[0], 0] as const];
  for (let i = 0; i + 1 < all.length; i++) {
    const [p0, r0] = all[i] ?? [0, 0];
    const [p1, r1] = all[i + 1] ?? [0, 0];
    const slope = Math.hypot(p1 - p0, r1 - r0);
    if (slope === 0) {
      continue;
    }
    const outward = (p1 - p0) / slope;
    const along = -(r1 - r0) / slope;
    for (let k = 0; k < AROUND; k++) {
      const angles = [(2 * Math.PI * k) / AROUND, (2 * Math.PI * (k + 1)) / AROUND] as const;
      for (const [at, radius, side] of [
        [p0, r0, 0], [p1, r1, 0], [p1, r1, 1],
        [p0, r0, 0], [p1, r1, 1], [p0, r0, 1],
      ] as const) {
        const c = Math.cos(angles[side]);
        const s = Math.sin(angles[side]);
        mesh.push(...put(axis, at, radius * c, radius * s, a, b), ...put(axis, along, outward * c, outward * s, 0, 0));
      }
    }
  }
}

/** Puts what is `along` an axis and `u`, `v` beside it into x, y, z. */
function put(axis: Axis, along: number, u: number, v: number, a: number, b: number): [number, number, number] {
  switch (axis) {
    case 'x':
      return [along, u + a, v + b];
    case 'y':
      return [u + a, along, v + b];
    case 'z':
      return [u + a, v + b, along];
  }
}
