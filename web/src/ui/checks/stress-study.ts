import { type ReadonlySignal, signal } from '@preact/signals';
import {
  type FitHold,
  type PointLoad,
  readStressAnswer,
  type StressAnswer,
  type StressOptions,
} from '../../model/stress.ts';
import type { SolverClient } from '../../solver/worker-client.ts';
import { roomSolver } from '../share/room-solver.ts';

/** An analysis that was asked for. */
export type StressProgress =
  | { readonly state: 'waiting' }
  | { readonly state: 'done'; readonly answer: StressAnswer; readonly options: StressOptions }
  | { readonly state: 'failed'; readonly message: string };

const FIRST: StressOptions = { friction: 'held', loads: [] };

/** Stresses of one model: what is asked, and the answer to what was asked last. */
export class StressStudy {
  readonly #json: string;
  readonly #solver: () => Pick<SolverClient, 'ask'>;
  readonly #options = signal<StressOptions>(FIRST);
  readonly #progress = signal<StressProgress>({ state: 'waiting' });
  #asked = 0;

  constructor(modelJson: string, solver: () => Pick<SolverClient, 'ask'> = roomSolver) {
    this.#json = modelJson;
    this.#solver = solver;
  }

  get options(): ReadonlySignal<StressOptions> {
    return this.#options;
  }

  get progress(): ReadonlySignal<StressProgress> {
    return this.#progress;
  }

  /** Asks for the first time; later calls do nothing. */
  start(): void {
    if (this.#asked === 0) {
      void this.#ask();
    }
  }

  setFriction(friction: FitHold): void {
    this.#set({ ...this.#options.value, friction });
  }

  addLoad(load: PointLoad): void {
    this.#set({ ...this.#options.value, loads: [...this.#options.value.loads, load] });
  }

  removeLoad(index: number): void {
    const loads = this.#options.value.loads.filter((_, i) => i !== index);
    this.#set({ ...this.#options.value, loads });
  }

  #set(options: StressOptions): void {
    this.#options.value = options;
    void this.#ask();
  }

  async #ask(): Promise<void> {
    this.#asked += 1;
    const number = this.#asked;
    const options = this.#options.value;
    const progress = await this.#answerTo(options);
    if (number === this.#asked) {
      this.#progress.value = progress;
    }
  }

  async #answerTo(options: StressOptions): Promise<StressProgress> {
    const question = {
      about: 'stress',
      modelJson: this.#json,
      optionsJson: JSON.stringify(options),
    } as const;
    try {
      const reply = await this.#solver().ask(question);
      return reply.outcome === 'ok'
        ? { state: 'done', answer: readStressAnswer(reply.text), options }
        : { state: 'failed', message: reply.message };
    } catch (error) {
      return { state: 'failed', message: error instanceof Error ? error.message : String(error) };
    }
  }
}

const studies = new WeakMap<object, StressStudy>();

/** The study of a model on screen; made when it is first asked for. */
export function studyOf(shown: { readonly json: string; readonly model: object }): StressStudy {
  const known = studies.get(shown.model);
  if (known) {
    return known;
  }
  const made = new StressStudy(shown.json);
  studies.set(shown.model, made);
  return made;
}
