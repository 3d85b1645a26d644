import { add, cross, dot, normalize, rotate, scale, subtract, type Vec3 } from '../geometry/vec.ts';
import type { MotionPath, MovedPart } from './motion.ts';
import type { Drive } from './shafts.ts';

// How shafts and what sits on them turn together.

/** An axle and what is fixed to it; mirrors "shafts" of a train in core/design/design_session.h. */
export interface TurningShaft {
  readonly parts: readonly number[];
  /** The shaft of the sketch that it is. */
  readonly drawn: number | null;
  readonly at: Vec3;
  /** Unit length. */
  readonly axis: Vec3;
  /** Turns about its axis for one of the first shaft of its train. */
  readonly speed: number;
}

/** Shafts that gears couple, or one alone. */
export interface GearTrain {
  readonly index: number;
  readonly turns: boolean;
  readonly message: string;
  readonly shafts: readonly TurningShaft[];
}

/** A part that turns about a fixed axis. */
export interface Spin {
  readonly rest: MovedPart;
  readonly at: Vec3;
  readonly axis: Vec3;
  /** Degrees for one of the driver. */
  readonly speed: number;
}

/** Degrees of the driver between two key angles. */
const KEY = 45;
/** Most turns of the driver after which all shafts are looked for where they began. */
const MOST_TURNS = 24;
const WHOLE = 1e-4;
/** The fastest shaft of a train turns at most so many times as fast as a joint that is played. */
const FASTEST = 2;

/** The shaft that a person turns: the first that drives in the drawing, else the first drawn one, else any. */
export function driverOf(train: GearTrain, drives: readonly Drive[] = []): TurningShaft | null {
  const drawn = (index: number) => train.shafts.find((shaft) => shaft.drawn === index);
  const driving = drives.map(({ from }) => drawn(from)).find((shaft) => shaft !== undefined);
  const first = train.shafts.reduce<TurningShaft | undefined>(
    (best, shaft) =>
      shaft.drawn !== null && (best?.drawn == null || shaft.drawn < best.drawn) ? shaft : best,
    undefined,
  );
  return driving ?? first ?? train.shafts[0] ?? null;
}

/** The motion of a train, by the degrees of its driver. */
export function trainPath(
  train: GearTrain,
  parts: readonly MovedPart[],
  drives: readonly Drive[] = [],
): MotionPath {
  const driver = driverOf(train, drives);
  if (!train.turns || !driver) {
    return { turns: false, message: train.message, parts: [], angles: [], poses: [] };
  }
  const moved: number[] = [];
  const spins: Spin[] = [];
  for (const { parts: indices, at, axis, speed } of train.shafts) {
    for (const part of indices) {
      const rest = parts[part];
      if (rest) {
        moved.push(part);
        spins.push({ rest, at, axis: normalize(axis), speed: speed / driver.speed });
      }
    }
  }
  const { turns, round } = periodOf(spins.map(({ speed }) => speed));
  const keys = Math.round((turns * 360) / KEY);
  const fastest = Math.max(1, ...spins.map(({ speed }) => Math.abs(speed)));
  return {
    turns: true,
    message: '',
    parts: moved,
    angles: Array.from({ length: keys + 1 }, (_, i) => i * KEY),
    poses: [],
    spins,
    round,
    pace: Math.min(1, FASTEST / fastest),
  };
}

/** Turns of the driver until everything is where it began; where that is far off, until all have gone round once. */
function periodOf(speeds: readonly number[]): { turns: number; round: boolean } {
  const isWhole = (x: number) => Math.abs(x - Math.round(x)) < WHOLE;
  for (let turns = 1; turns <= MOST_TURNS; turns++) {
    if (speeds.every((speed) => isWhole(turns * speed))) {
      return { turns, round: true };
    }
  }
  const slowest = Math.min(...speeds.map(Math.abs));
  return { turns: Math.min(MOST_TURNS, Math.ceil(1 / slowest)), round: false };
}

/** Where a part is when the driver has turned so far. */
export function spun({ rest, at, axis, speed }: Spin, degrees: number): MovedPart {
  const angle = (speed * degrees * Math.PI) / 180;
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const turned = (v: Vec3): Vec3 =>
    add(add(scale(v, c), scale(cross(axis, v), s)), scale(axis, (1 - c) * dot(axis, v)));
  const column = (v: Vec3) => turned(rotate(rest.rotation, v));
  const [x, y, z] = [column([1, 0, 0]), column([0, 1, 0]), column([0, 0, 1])];
  return {
    position: add(at, turned(subtract(rest.position, at))),
    rotation: [x[0], y[0], z[0], x[1], y[1], z[1], x[2], y[2], z[2]],
  };
}

/** Degrees of the driver for one of a part's own turn about the axis; 1 where it moves otherwise. */
export function gearingOf(path: MotionPath, part: number): number {
  const spin = path.spins?.[path.parts.indexOf(part)];
  return spin ? 1 / Math.abs(spin.speed) : 1;
}
