import { describe, expect, it } from 'vitest';
import type { MotionPath, PathPose } from '../../../web/src/model/motion.ts';
import type { MotionStudy, Mover } from '../../../web/src/ui/checks/motion-study.ts';
import { MotionBoard, moved } from '../../../web/src/ui/motion/motion-board.ts';

const REST: PathPose = [0, 0, 0, 0, 0, 0, 1];

function path(from: number, to: number, parts: readonly number[]): MotionPath {
  const angles = [from, 0, to];
  return {
    turns: true,
    message: '',
    parts,
    angles,
    poses: angles.map(() => parts.map(() => REST)),
  };
}

const PATHS: readonly MotionPath[] = [
  path(-180, 180, [0]),
  path(-30, 60, [1]),
  path(-90, 90, [0, 2]),
  { turns: false, message: 'Does not turn.', parts: [], angles: [], poses: [] },
];

const STUDY = {
  path: ({ index }: Mover) => {
    const found = PATHS[index];
    return found ? Promise.resolve(found) : Promise.reject(new Error('gone'));
  },
} as unknown as MotionStudy;

const joint = (index: number): Mover => ({ of: 'joint', index });

async function board(...indices: readonly number[]): Promise<MotionBoard> {
  const made = new MotionBoard(STUDY);
  const [first = 0, ...more] = indices;
  await made.choose(joint(first), null);
  for (const index of more) {
    await made.toggle(joint(index), null);
  }
  return made;
}

const stand = ({ drivers }: MotionBoard) => drivers.value.map(({ degrees }) => degrees);

describe('playing', () => {
  it('goes round where a full turn is free', async () => {
    const made = await board(0);
    made.advance(7);
    expect(stand(made)).toEqual([-45]);
  });

  it('goes there and back where it is not', async () => {
    const made = await board(1);
    made.advance(2);
    expect(stand(made)).toEqual([30]);
    made.advance(1);
    expect(stand(made)).toEqual([-15]);
  });

  it('goes there and back where that is wanted', async () => {
    const made = await board(0);
    made.mode.value = 'swing';
    made.advance(5);
    expect(stand(made)).toEqual([135]);
  });

  it('is as fast as it is told', async () => {
    const made = await board(0);
    made.speed.value = 2;
    made.advance(1);
    expect(stand(made)).toEqual([90]);
  });

  it('comes back after its period', async () => {
    const made = await board(1);
    const [driver] = made.drivers.value;
    if (!driver) {
      throw new Error('nothing is driven');
    }
    // From -30 to 60 degrees and back.
    const period = 2 * (60 + 30);
    for (const mode of ['loop', 'swing'] as const) {
      const later = moved({ ...driver, degrees: 12, way: -1 }, period, mode);
      expect(later.degrees).toBeCloseTo(12);
      expect(later.way).toBe(-1);
    }
  });
});

describe('several drivers', () => {
  it('move at once where they move different parts', async () => {
    const made = await board(0, 1);
    made.advance(1);
    expect(stand(made)).toEqual([45, 45]);
  });

  it('are let go one by one', async () => {
    const made = await board(0, 1);
    await made.toggle(joint(1), null);
    expect(stand(made)).toEqual([0]);
  });

  it('are refused where they cannot be had together', async () => {
    const made = await board(0);
    const twin: Mover = { of: 'motion', index: 0 };
    expect(await made.toggle(twin, null)).toBe('not together');
    expect(stand(made)).toEqual([0]);
  });
});

describe('by hand', () => {
  it('stays within the range and stops what plays', async () => {
    const made = await board(1);
    made.playing.value = true;
    made.put(joint(1), 100);
    expect(stand(made)).toEqual([60]);
    expect(made.playing.value).toBe(false);
  });
});

it('says why something does not turn', async () => {
  const made = await board(3);
  expect(made.message.value).toBe('Does not turn.');
  expect(made.drivers.value).toEqual([]);
});

it('says that a study failed', async () => {
  const made = await board(9);
  expect(made.failure.value).toBe('gone');
});
