/** The arms of `models`, as tools/build.mjs puts them into the bundle: by id, kinematics and outside. */
declare module 'pendant:arms' {
  interface Housing {
    readonly radiusM: number;
    readonly alongZM: readonly [number, number];
    readonly alongYM: readonly [number, number];
  }
  interface End {
    readonly radiusM: number;
    readonly alongZM: readonly [number, number];
  }
  interface Limb {
    readonly lengthM: number;
    readonly near: End;
    readonly far: End;
    readonly tube: { readonly centreZM: number; readonly radiiM: readonly [number, number, number] };
  }
  export interface Arm {
    readonly name: string;
    readonly reachM: number;
    readonly dh: {
      readonly d1: number;
      readonly a2: number;
      readonly a3: number;
      readonly d4: number;
      readonly d5: number;
      readonly d6: number;
    };
    readonly shape: {
      readonly base: { readonly heightM: number; readonly footRadiusM: number; readonly topRadiusM: number };
      readonly shoulder: Housing;
      readonly upperArm: Limb;
      readonly forearm: Limb;
      readonly wrist1: Housing;
      readonly wrist2: Housing;
      readonly wrist3: Housing;
    };
  }
  export const arms: { readonly [id: string]: Arm };
}
