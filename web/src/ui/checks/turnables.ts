import { driverOf, type GearTrain } from '../../model/gear-motion.ts';
import type { JointRange, MotionAnswer } from '../../model/motion.ts';
import type { SketchDocument } from '../../model/sketch.ts';
import { formatNumber } from '../text/language.ts';
import type { Mover } from './motion-study.ts';
import { motionWords as words } from './motion-words.ts';

/** What a person can turn: a joint, or shafts with their gears. */
export interface Turnable {
  readonly mover: Mover;
  readonly name: string;
  /** How far it turns, or how fast. */
  readonly says: string;
  readonly turns: boolean;
  /** Why it does not turn, as the core says it. */
  readonly message: string;
  readonly range: JointRange | null;
}

/** The joints, then the trains. */
export function turnablesOf(
  { joints, trains }: Pick<MotionAnswer, 'joints' | 'trains'>,
  sketch: Pick<SketchDocument, 'drives'> | null = null,
): Turnable[] {
  return [
    ...joints.map((range) => ({
      mover: { of: 'joint', index: range.index } as const,
      name: nameOfJoint(range),
      says: rangeText(range),
      turns: range.turns,
      message: range.message,
      range,
    })),
    ...trains.map((train) => ({
      mover: { of: 'train', index: train.index } as const,
      name: nameOfTrain(train),
      says: train.turns ? ratiosOf(train, sketch) : words.stiff,
      turns: train.turns,
      message: train.message,
      range: null,
    })),
  ];
}

export function isSame(a: Mover, b: Mover): boolean {
  return a.of === b.of && a.index === b.index;
}

export function rangeText(range: JointRange): string {
  if (!range.turns) {
    return words.stiff;
  }
  return range.to - range.from >= 359
    ? words.fullTurn
    : words.range(formatNumber(range.from), formatNumber(range.to));
}

function nameOfJoint({ joint, bodies }: JointRange): string {
  const name = words.joint(String(joint + 1));
  return bodies ? words.bodies(name, String(bodies[0] + 1), String(bodies[1] + 1)) : name;
}

/** By the shafts of the drawing that it has. */
function nameOfTrain({ index, shafts }: GearTrain): string {
  const drawn = shafts.flatMap((shaft) => (shaft.drawn === null ? [] : [shaft.drawn]));
  const numbers = drawn.sort((a, b) => a - b).map((shaft) => String(shaft + 1));
  const [first, ...more] = numbers;
  if (first === undefined) {
    return words.train(String(index + 1));
  }
  return more.length === 0 ? words.shaft(first) : words.shafts(numbers.join(', '));
}

/** Turns of the driver against those of each other shaft of the drawing, such as 15 : 1. */
function ratiosOf(train: GearTrain, sketch: Pick<SketchDocument, 'drives'> | null): string {
  const driver = driverOf(train, sketch?.drives);
  const others = train.shafts.filter(
    (shaft) => shaft !== driver && (shaft.drawn !== null || driver?.drawn === null),
  );
  if (!driver || others.length === 0) {
    return words.fullTurn;
  }
  return others
    .map(({ speed }) => {
      const ratio = Math.abs(driver.speed / speed);
      return ratio >= 1 ? `${formatNumber(ratio)} : 1` : `1 : ${formatNumber(1 / ratio)}`;
    })
    .join(', ');
}
