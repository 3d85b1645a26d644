import { type ReadonlySignal, signal } from '@preact/signals';
import { type GearTrain, trainPath } from '../../model/gear-motion.ts';
import {
  type MotionAnswer,
  type MotionPath,
  type MovedPart,
  readMotionAnswer,
  readMotionPath,
} from '../../model/motion.ts';
import type { Drive } from '../../model/shafts.ts';
import type { SolverClient } from '../../solver/worker-client.ts';
import { roomSolver } from '../share/room-solver.ts';

/** What is moved: an annotated joint, one of the free motions, or shafts with their gears. */
export interface Mover {
  readonly of: 'joint' | 'motion' | 'train';
  readonly index: number;
}

export type MotionProgress =
  | { readonly state: 'waiting' }
  | { readonly state: 'done'; readonly answer: MotionAnswer }
  | { readonly state: 'failed'; readonly message: string };

/** What the motion of a train takes from a model's file. */
interface ModelOfTrain {
  readonly parts: readonly MovedPart[];
  readonly sketch?: { readonly drives?: readonly Drive[] };
}

type Asker = Pick<SolverClient, 'ask'>;

/** How one model stands and moves; asked once, and each motion once. */
export class MotionStudy {
  readonly #json: string;
  readonly #solver: () => Asker;
  readonly #progress = signal<MotionProgress>({ state: 'waiting' });
  readonly #paths = new Map<string, Promise<MotionPath>>();
  #started = false;
  #answer: Promise<MotionAnswer> | null = null;

  constructor(modelJson: string, solver: () => Asker = roomSolver) {
    this.#json = modelJson;
    this.#solver = solver;
  }

  get progress(): ReadonlySignal<MotionProgress> {
    return this.#progress;
  }

  /** Asks for the first time; later calls do nothing. */
  start(): void {
    if (!this.#started) {
      this.#started = true;
      void this.#ask();
    }
  }

  /** How the model stands and moves. Rejects when it cannot be computed. */
  answer(): Promise<MotionAnswer> {
    this.#answer ??= this.#askAnswer();
    return this.#answer;
  }

  async #askAnswer(): Promise<MotionAnswer> {
    const reply = await this.#solver().ask({ about: 'motion', modelJson: this.#json });
    if (reply.outcome !== 'ok') {
      throw new Error(reply.message);
    }
    return readMotionAnswer(reply.text);
  }

  /** Key poses of a motion. Rejects when they cannot be computed. */
  path(mover: Mover): Promise<MotionPath> {
    const key = `${mover.of} ${mover.index}`;
    const known = this.#paths.get(key);
    if (known !== undefined) {
      return known;
    }
    const asked = this.#askPath(mover);
    this.#paths.set(key, asked);
    return asked;
  }

  async #askPath({ of, index }: Mover): Promise<MotionPath> {
    if (of === 'train') {
      const { trains } = await this.answer();
      return this.#pathOfTrain(trains[index]);
    }
    const reply = await this.#solver().ask({ about: 'path', modelJson: this.#json, of, index });
    if (reply.outcome !== 'ok') {
      throw new Error(reply.message);
    }
    return readMotionPath(reply.text);
  }

  #pathOfTrain(train: GearTrain | undefined): MotionPath {
    if (!train) {
      throw new Error('there is no such train');
    }
    const { parts, sketch } = JSON.parse(this.#json) as ModelOfTrain;
    return trainPath(train, parts, sketch?.drives);
  }

  async #ask(): Promise<void> {
    try {
      this.#progress.value = { state: 'done', answer: await this.answer() };
    } catch (error) {
      const message = error instanceof Error ? error.message : String(error);
      this.#progress.value = { state: 'failed', message };
    }
  }
}

const studies = new WeakMap<object, MotionStudy>();

/** The study of a model on screen; made when it is first asked for. */
export function motionStudyOf(shown: {
  readonly json: string;
  readonly model: object;
}): MotionStudy {
  const known = studies.get(shown.model);
  if (known) {
    return known;
  }
  const made = new MotionStudy(shown.json);
  studies.set(shown.model, made);
  return made;
}
