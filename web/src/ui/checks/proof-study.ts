import { type ReadonlySignal, signal } from '@preact/signals';
import type { ProofProgress } from '../../solver/proof/prove.ts';
import { type ProofWatch, proveInWorker } from '../../solver/proof-client.ts';
import type { SolveSettings } from '../../solver/protocol.ts';
import type { SolverClient } from '../../solver/worker-client.ts';
import { roomSolver } from '../share/room-solver.ts';

export type ProofState =
  | { readonly state: 'open' }
  | { readonly state: 'working'; readonly progress: ProofProgress | null }
  /** At least so many beams and axles along lines. */
  | { readonly state: 'proved'; readonly bound: number }
  | { readonly state: 'failed'; readonly message: string };

interface Provers {
  readonly solver: () => Pick<SolverClient, 'ask'>;
  readonly prove: (
    placementsJson: string,
    watch: ProofWatch,
  ) => Promise<{ readonly bound: number } | null>;
}

/** The proof about one sketch with the parts in use: begun by a click, and can be stopped. */
export class ProofStudy {
  readonly #provers: Provers;
  readonly #now = signal<ProofState>({ state: 'open' });
  #abort: AbortController | null = null;

  constructor(provers: Provers = { solver: roomSolver, prove: proveInWorker }) {
    this.#provers = provers;
  }

  get now(): ReadonlySignal<ProofState> {
    return this.#now;
  }

  /** Resolves when the proof is found, has failed or was stopped. */
  async start(sketchJson: string, settings: SolveSettings): Promise<void> {
    this.stop();
    const abort = new AbortController();
    this.#abort = abort;
    this.#now.value = { state: 'working', progress: null };
    const ended = await this.#prove(sketchJson, settings, abort.signal);
    if (this.#abort === abort) {
      this.#abort = null;
      this.#now.value = ended;
    }
  }

  stop(): void {
    this.#abort?.abort();
    this.#abort = null;
    if (this.#now.value.state === 'working') {
      this.#now.value = { state: 'open' };
    }
  }

  async #prove(
    sketchJson: string,
    settings: SolveSettings,
    signal: AbortSignal,
  ): Promise<ProofState> {
    try {
      const question = { about: 'placements', sketchJson, settings } as const;
      const reply = await this.#provers.solver().ask(question, signal);
      if (reply.outcome !== 'ok') {
        return { state: 'failed', message: reply.message };
      }
      const proof = await this.#provers.prove(reply.text, {
        signal,
        onProgress: (progress) => {
          if (!signal.aborted) {
            this.#now.value = { state: 'working', progress };
          }
        },
      });
      return proof ? { state: 'proved', bound: proof.bound } : { state: 'open' };
    } catch (error) {
      return { state: 'failed', message: error instanceof Error ? error.message : String(error) };
    }
  }
}

const studies = new WeakMap<object, ProofStudy>();

/** The study of a model on screen; made when it is first asked for. */
export function proofStudyOf(shown: { readonly model: object }): ProofStudy {
  const known = studies.get(shown.model) ?? new ProofStudy();
  studies.set(shown.model, known);
  return known;
}
