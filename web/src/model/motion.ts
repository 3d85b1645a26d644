import type { Mat3, Vec3 } from '../geometry/vec.ts';
import { type GearTrain, type Spin, spun } from './gear-motion.ts';

/** How a model stands and moves; mirrors analyseMotionJson in core/design/design_session.h. */
export interface MotionAnswer {
  readonly freedoms: {
    /** Internal freedoms when every pin turns, and when pins with friction hold. */
    readonly free: number;
    readonly held: number;
    readonly expected: number;
    readonly beyondJoints: number;
    readonly heldBeyondJoints: number;
    readonly spinning: number;
  };
  /** Rigid group of each part. */
  readonly groups: readonly number[];
  readonly motions: readonly FreeMotion[];
  readonly joints: readonly JointRange[];
  /** What turns on shafts: those that gears couple, and those of the drawing. */
  readonly trains: readonly GearTrain[];
  readonly balance: Balance | null;
  readonly braces: readonly Brace[];
}

export interface FreeMotion {
  /** The annotated joint that it turns. */
  readonly joint: number | null;
  readonly parts: readonly number[];
}

/** Degrees. */
export interface JointRange {
  readonly index: number;
  /** Of the sketch, and which two of its bodies where more than two share it. */
  readonly joint: number;
  readonly bodies?: readonly [number, number];
  readonly turns: boolean;
  readonly from: number;
  readonly to: number;
  readonly stoppedBy: { readonly from: readonly number[]; readonly to: readonly number[] };
  readonly message: string;
}

/** Modules, degrees. */
export interface Balance {
  readonly stable: boolean;
  readonly centre: Vec3;
  readonly polygon: readonly (readonly [number, number])[];
  readonly ground: number;
  /** From the centre to the nearest side of the polygon; negative outside. */
  readonly margin: number;
  readonly tippingAngle: number;
  readonly direction: readonly [number, number];
}

/** A line that would take a free motion away. */
export interface Brace {
  readonly lines: readonly number[];
  readonly from: Vec3;
  readonly to: Vec3;
}

/** x, y, z in modules and a unit quaternion x, y, z, w. */
export type PathPose = readonly [number, number, number, number, number, number, number];

/** Key poses along a motion; mirrors jointMotionJson. */
export interface MotionPath {
  readonly turns: boolean;
  readonly message: string;
  readonly parts: readonly number[];
  /** Degrees, rising. */
  readonly angles: readonly number[];
  readonly poses: readonly (readonly PathPose[])[];
  /** Instead of key poses, for each of the parts: all turn about fixed axes. */
  readonly spins?: readonly Spin[];
  /** Whether the last angle is the first again; where it is left out, a full turn is. */
  readonly round?: boolean;
  /** How fast it is played, of what is usual; 1 when left out. */
  readonly pace?: number;
}

/** A part in its place. */
export interface MovedPart {
  readonly position: Vec3;
  readonly rotation: Mat3;
}

/** The text is our own module's: tests/contract checks its fields. */
export function readMotionAnswer(text: string): MotionAnswer {
  return JSON.parse(text) as MotionAnswer;
}

export function readMotionPath(text: string): MotionPath {
  return JSON.parse(text) as MotionPath;
}

/** Where the moving parts are at an angle, by their index; outside the range, at its end. */
export function posesAt(path: MotionPath, degrees: number): Map<number, MovedPart> {
  const key = keyAt(path, degrees);
  const places = new Map<number, MovedPart>();
  path.parts.forEach((part, i) => {
    const place = placeAt(path, key, i);
    if (place) {
      places.set(part, place);
    }
  });
  return places;
}

/** The same of one part alone, the i-th of those that move. */
export function poseAt(path: MotionPath, degrees: number, i: number): MovedPart | null {
  return placeAt(path, keyAt(path, degrees), i);
}

/** Two key poses, and the share of the second. */
interface Key {
  readonly degrees: number;
  readonly first: number;
  readonly last: number;
  readonly share: number;
}

function keyAt({ angles }: MotionPath, degrees: number): Key {
  const after = angles.findIndex((angle) => angle >= degrees);
  const last = after < 0 ? angles.length - 1 : after;
  const first = Math.max(0, last - 1);
  const [a, b] = [angles[first] ?? 0, angles[last] ?? 0];
  const share = b > a ? Math.min(1, Math.max(0, (degrees - a) / (b - a))) : 0;
  return { degrees, first, last, share };
}

function placeAt(
  { poses, spins }: MotionPath,
  { degrees, first, last, share }: Key,
  i: number,
): MovedPart | null {
  const spin = spins?.[i];
  if (spin) {
    return spun(spin, degrees);
  }
  const [p, q] = [poses[first]?.[i], poses[last]?.[i]];
  return p && q ? between(p, q, share) : null;
}

/** Between two poses that are a few degrees apart: mixed and made unit again. */
function between(p: PathPose, q: PathPose, share: number): MovedPart {
  const turn = p[3] * q[3] + p[4] * q[4] + p[5] * q[5] + p[6] * q[6];
  const sign = turn < 0 ? -1 : 1;
  const mix = (i: 3 | 4 | 5 | 6) => (1 - share) * p[i] + share * sign * q[i];
  const [x, y, z, w] = [mix(3), mix(4), mix(5), mix(6)];
  const at = (i: 0 | 1 | 2) => (1 - share) * p[i] + share * q[i];
  return { position: [at(0), at(1), at(2)], rotation: rotationOf(x, y, z, w) };
}

function rotationOf(x: number, y: number, z: number, w: number): Mat3 {
  const s = 2 / (x * x + y * y + z * z + w * w || 1);
  return [
    1 - s * (y * y + z * z),
    s * (x * y - w * z),
    s * (x * z + w * y),
    s * (x * y + w * z),
    1 - s * (x * x + z * z),
    s * (y * z - w * x),
    s * (x * z - w * y),
    s * (y * z + w * x),
    1 - s * (x * x + y * y),
  ];
}

/** Lightness alternates so that neighbours in number differ without colour too. */
const GROUP_HUES = [0x2b5fb8, 0xf2b21d, 0x2fa39a, 0xd2622a, 0x7b4fa3, 0x9cc73c, 0x8a5a3b, 0xd678a8];
const SMALL_GROUP = 0xb8bcc2;

/** A colour for each part by its rigid group; groups of one part are pale grey. */
export function groupColours(groups: readonly number[]): number[] {
  const sizes = new Map<number, number>();
  for (const group of groups) {
    sizes.set(group, (sizes.get(group) ?? 0) + 1);
  }
  const large = [...sizes].filter(([, size]) => size > 1).map(([group]) => group);
  const rank = new Map(large.map((group, i): [number, number] => [group, i]));
  return groups.map((group) => {
    const i = rank.get(group);
    return i === undefined ? SMALL_GROUP : (GROUP_HUES[i % GROUP_HUES.length] ?? SMALL_GROUP);
  });
}
