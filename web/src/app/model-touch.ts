import { effect, type ReadonlySignal, signal } from '@preact/signals';
import { distance, type Vec3 } from '../geometry/vec.ts';
import { type Place, samePart } from '../model/keep.ts';
import type { Report } from '../model/report.ts';
import type { SketchDocument } from '../model/sketch.ts';
import type { SolveSettings } from '../solver/protocol.ts';
import type { SolverClient } from '../solver/worker-client.ts';
import { swapPart } from '../state/keeps.ts';
import { writeSketch } from '../state/read-sketch.ts';
import type { ShownModel } from '../ui/page.ts';
import type { Fits, Trial } from '../ui/touch/touch-types.ts';
import type { PageState } from './page-state.ts';
import type { SolveRun } from './solve-run.ts';

/** A part moved less than this is the one that was there. */
const SAME_PLACE = 0.3;
/** Rounds of a search that only asks whether a part would do. */
const TRIAL_ROUNDS = 2;

/** What a person wants to go on with once the model is solved again. */
interface Followed {
  readonly place: Place | null;
  readonly part: string;
  readonly position: Vec3;
}

interface Options {
  readonly state: PageState;
  readonly client: SolverClient;
  readonly run: Pick<SolveRun, 'layout'>;
  readonly settings: () => SolveSettings;
}

/** Parts of the model as things to take hold of: where they lie on the lines, and what else could. */
export class ModelTouch {
  readonly #options: Options;
  readonly #places = signal<readonly (Place | null)[] | null>(null);
  /** By part of the model shown; null where that is not known, or not yet. */
  readonly places: ReadonlySignal<readonly (Place | null)[] | null> = this.#places;
  #of: string | null = null;
  #followed: Followed | null = null;

  constructor(options: Options) {
    this.#options = options;
  }

  /** Asks for the places of each model once a part or a line of it is picked. @returns what stops it. */
  start(): () => void {
    const { state } = this.#options;
    return effect(() => {
      const shown = state.shown.value;
      const wanted = state.pickedPart.value !== null || state.store.selection.value.size === 1;
      if (shown?.json !== this.#of) {
        this.#places.value = null;
      }
      if (shown?.report && shown.source === 'search' && (wanted || this.#followed)) {
        this.#ask(shown).catch(() => undefined);
      }
    });
  }

  /** The part that is picked stays picked when the model is solved again. @param place where it will lie. */
  follow(index: number, place: Place | null): void {
    const placed = this.#options.state.shown.peek()?.model.parts[index];
    this.#followed = placed ? { place, part: placed.part, position: placed.position } : null;
  }

  /** What else could lie where a part does; null where nothing is known of it. */
  async fits(part: number, signal: AbortSignal): Promise<Fits | null> {
    const { state, client, run, settings } = this.#options;
    const shown = state.shown.peek();
    if (!shown || run.layout === null) {
      return null;
    }
    const model = { modelJson: shown.json, layoutJson: run.layout, settings: settings() };
    const answer = await client.ask({ about: 'fits', ...model, part }, signal);
    return answer.outcome === 'ok' ? (JSON.parse(answer.text) as Fits) : null;
  }

  /** What a part in place of another makes of the model; rejects when it is broken off. */
  async tryPart(before: Place, after: Place, signal: AbortSignal): Promise<Trial> {
    const { state, client, run, settings } = this.#options;
    const sketch: SketchDocument = swapPart(state.store.sketch.peek(), before, after);
    const now = state.shown.peek()?.report;
    const usual = settings();
    const earlier = run.layout === null ? {} : { earlier: JSON.parse(run.layout) as unknown };
    const quick = { ...usual, ...earlier, set: { ...usual.set, rounds: TRIAL_ROUNDS } };
    const result = await client.solve(writeSketch(sketch), quick, { signal });
    if (result.outcome !== 'solved') {
      return { place: after, change: null };
    }
    const then = JSON.parse(result.reportJson) as Report;
    const more = (key: 'bricks' | 'beams' | 'freedoms') => (then[key] ?? 0) - (now?.[key] ?? 0);
    return {
      place: after,
      change: then.buildable
        ? { bricks: more('bricks'), beams: more('beams'), freedoms: more('freedoms') }
        : null,
    };
  }

  async #ask(shown: ShownModel): Promise<void> {
    const { client, run, settings } = this.#options;
    if (this.#of === shown.json || run.layout === null) {
      return;
    }
    this.#of = shown.json;
    const answer = await client.ask({
      about: 'places',
      modelJson: shown.json,
      layoutJson: run.layout,
      settings: settings(),
    });
    if (this.#of !== shown.json || this.#options.state.shown.peek()?.json !== shown.json) {
      return;
    }
    const { places } =
      answer.outcome === 'ok'
        ? (JSON.parse(answer.text) as { places: (Place | null)[] })
        : { places: [] };
    this.#places.value = places;
    this.#goOn(shown, places);
  }

  /** Picks the part that was picked before the model was solved again, or what took its place. */
  #goOn(shown: ShownModel, places: readonly (Place | null)[]): void {
    const followed = this.#followed;
    if (!followed) {
      return;
    }
    this.#followed = null;
    const { place, part, position } = followed;
    const there = place
      ? places.findIndex(
          (other) =>
            other !== null && other.line === place.line && samePart(other.part, place.part),
        )
      : -1;
    const index =
      there >= 0
        ? there
        : shown.model.parts.findIndex(
            (placed) => placed.part === part && distance(placed.position, position) < SAME_PLACE,
          );
    if (index >= 0) {
      this.#options.state.pickedPart.value = index;
    }
  }
}
