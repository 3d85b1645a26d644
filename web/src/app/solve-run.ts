import { batch, type ReadonlySignal, signal } from '@preact/signals';
import type { Model } from '../model/model.ts';
import type { CheckReport, Report } from '../model/report.ts';
import type { SketchDocument } from '../model/sketch.ts';
import type { MadeModel } from '../solver/made-model.ts';
import type { SolveProgress, SolveSettings } from '../solver/protocol.ts';
import type { SolveResult, SolverClient } from '../solver/worker-client.ts';
import { readSketchValue, writeSketch } from '../state/read-sketch.ts';
import type { ChartPoint, LayoutSnapshot, ShownModel, SolveState } from '../ui/page.ts';
import { partsText } from '../ui/solve-settings.ts';
import { inWords } from '../ui/text/sentences.ts';
import { text } from '../ui/text.ts';
import { readModel } from './read-model.ts';

const MAX_CHART_POINTS = 400;
/** More than these say little: every other one is dropped, the first and the last stay. */
export const MAX_LAYOUTS = 12;
const IDLE: SolveState = { phase: 'idle', progress: null, chart: [], layouts: [], message: '' };

/** What a model is searched for. */
export interface Wish {
  readonly sketch: SketchDocument;
  /** The parts that there are (partsText). */
  readonly parts: string;
}

/** What a search has found. */
interface Found {
  readonly wish: Wish;
  readonly json: string;
  readonly report: Report;
}

/** One search at a time: started, watched, cancelled; the last good model stays. */
export class SolveRun {
  readonly #client: SolverClient;
  readonly #state = signal<SolveState>(IDLE);
  readonly #shown = signal<ShownModel | null>(null);
  /** Of the search under way, until its model is checked. */
  #running: AbortController | null = null;
  /** Of a check that nobody waits for. */
  #checking: AbortController | null = null;
  #wish: Wish | null = null;
  /** Of the model shown, or of the last search that ended, as text. */
  layout: string | null = null;
  readonly state: ReadonlySignal<SolveState> = this.#state;
  readonly shown: ReadonlySignal<ShownModel | null> = this.#shown;

  constructor(client: SolverClient) {
    this.#client = client;
  }

  /**
   * start(), but what the sketch has in common with that of the last search stays as it lies. With other parts
   * nothing does: it may be laid with what is no longer there.
   */
  regrow(sketch: SketchDocument, settings: SolveSettings): Promise<void> {
    const layout = this.#wish?.parts === partsText(settings) ? this.layout : null;
    const earlier = layout === null ? {} : { earlier: JSON.parse(layout) as unknown };
    return this.start(sketch, { ...settings, ...earlier });
  }

  /** Starts a search; one under way is given up. Never rejects. */
  async start(sketch: SketchDocument, settings: SolveSettings): Promise<void> {
    const run = this.#begin();
    const wish: Wish = { sketch, parts: partsText(settings) };
    this.#wish = wish;
    this.#state.value = { ...IDLE, phase: 'solving' };
    const onProgress = (progress: SolveProgress, json: string | null) => {
      if (this.#running === run) {
        this.#progressed(wish, progress, json);
      }
    };
    try {
      const watch = { onProgress, signal: run.signal };
      const result = await this.#client.solve(writeSketch(sketch), settings, watch);
      if (this.#running === run) {
        await this.#ended(wish, result, run);
      }
    } catch {
      if (this.#running === run) {
        this.#running = null;
        this.#end('failed', text.solve.failed);
      }
    }
  }

  /** Shows a model that was made before; confirm() searches for it again. */
  showMade(made: MadeModel): void {
    const model = readModel(made.modelJson);
    if (!model.ok) {
      return;
    }
    this.drop();
    this.layout = made.layoutJson;
    const wish = wishOf(made);
    this.#wish = wish;
    const report = JSON.parse(made.reportJson) as Report;
    const check = JSON.parse(made.checkJson) as CheckReport;
    batch(() => {
      const json = made.modelJson;
      this.#shown.value = { source: 'search', json, model: model.value, ...wish, report, check };
      this.#end('solved', '');
    });
  }

  /**
   * Searches for what showMade() shows without a word, so that its figures are this machine's, and puts the
   * model found in its place should it be another. Any other search ends it. Never rejects.
   */
  async confirm(made: MadeModel): Promise<void> {
    if (this.#running || this.#shown.peek()?.json !== made.modelJson) {
      return;
    }
    const run = this.#begin();
    let state: SolveState = { ...IDLE, phase: 'solved' };
    const onProgress = (progress: SolveProgress, json: string | null) => {
      state = { ...grown(state, progress, json), phase: 'solved' };
    };
    const watch = { onProgress, signal: run.signal };
    const result = await this.#client
      .solve(writeSketch(made.sketch), made.settings, watch)
      .catch(() => null);
    if (this.#running !== run) {
      return;
    }
    const shown = this.#shown.peek();
    if (result?.outcome !== 'solved' || shown?.json !== made.modelJson) {
      this.#running = null;
      return;
    }
    this.#state.value = state;
    const report = timedReport(result);
    if (result.modelJson === made.modelJson) {
      this.layout = result.layoutJson;
      this.#running = null;
      batch(() => {
        this.#shown.value = { ...shown, report };
        this.#addFinal(result.modelJson, report);
      });
    } else {
      this.layout = result.layoutJson;
      await this.#show({ wish: wishOf(made), json: result.modelJson, report }, run);
    }
  }

  /** What the search under way is for, or its model that is being checked; or null. */
  get wishUnderWay(): Wish | null {
    return this.#state.peek().phase === 'solving' ? this.#wish : null;
  }

  /** Ends what is under way, be it the search or the check of what it found. */
  cancel(): void {
    this.#running?.abort();
  }

  #begin(): AbortController {
    const before = [this.#running, this.#checking];
    const run = new AbortController();
    this.#running = run;
    for (const other of before) {
      other?.abort();
    }
    return run;
  }

  /**
   * Shows a model that a file held.
   * @param on told of what is in the file before it is shown: of its model, and of its sketch where it holds one.
   * @returns null, or why it cannot be shown. Rejects with the reason of the signal.
   */
  async showFile(
    json: string,
    on: {
      readonly model: (model: Model) => void;
      readonly sketch: (sketch: SketchDocument) => void;
    },
    signal?: AbortSignal,
  ): Promise<string | null> {
    const checked = await this.#client.check(json, signal);
    if (checked.outcome === 'refused') {
      return checked.message;
    }
    const model = readModel(json);
    if (!model.ok) {
      return model.message;
    }
    const check = JSON.parse(checked.text) as CheckReport;
    const report: Report = { buildable: check.buildable };
    const sketch = sketchIn(json);
    this.drop();
    this.layout = null;
    batch(() => {
      on.model(model.value);
      const of = { sketch, parts: null };
      this.#shown.value = { source: 'file', json, model: model.value, ...of, report, check };
      if (sketch) {
        on.sketch(sketch);
      }
    });
    return null;
  }

  /** Gives up a search under way without a word, as when the sketch is replaced. */
  drop(): void {
    const before = [this.#running, this.#checking];
    this.#running = null;
    for (const run of before) {
      run?.abort();
    }
    this.#state.value = IDLE;
  }

  /** Shows an earlier layout of the last search, checked like a file. */
  async showLayout(layout: LayoutSnapshot): Promise<void> {
    const model = readModel(layout.json);
    const wish = this.#wish;
    if (this.#running || !model.ok || !wish) {
      return;
    }
    const check = await this.#checkAside(layout.json);
    if (!this.#running && this.#wish === wish) {
      const { json, objective, beams, gaps, collisions, failedConnections } = layout;
      const buildable = check?.buildable ?? false;
      const report = { objective, beams, gaps, collisions, failedConnections, buildable };
      this.#shown.value = { source: 'search', json, model: model.value, ...wish, report, check };
    }
  }

  /** Takes the model from the screen. */
  clear(): void {
    this.drop();
    this.layout = null;
    this.#shown.value = null;
  }

  #progressed(wish: Wish, progress: SolveProgress, json: string | null): void {
    batch(() => {
      this.#state.value = grown(this.#state.value, progress, json);
      const model = json === null ? null : readModel(json);
      if (json !== null && model?.ok) {
        this.#shown.value = {
          source: 'search',
          json,
          model: model.value,
          ...wish,
          report: null,
          check: null,
        };
      }
    });
  }

  async #ended(wish: Wish, result: SolveResult, run: AbortController): Promise<void> {
    switch (result.outcome) {
      case 'refused':
        this.#running = null;
        this.#end('refused', inWords(result.message));
        return;
      case 'cancelled':
        this.#running = null;
        await this.#cancelled();
        return;
      case 'solved': {
        this.layout = result.layoutJson;
        await this.#show({ wish, json: result.modelJson, report: timedReport(result) }, run);
      }
    }
  }

  async #show(found: Found, run: AbortController): Promise<void> {
    const { wish, json, report } = found;
    const model = readModel(json);
    if (!model.ok) {
      this.#running = null;
      this.#end('failed', text.solve.failed);
      return;
    }
    const check = await this.#check(json, run.signal);
    // A new search may have begun while the check ran.
    if (this.#running !== run) {
      return;
    }
    this.#running = null;
    const stopped = run.signal.aborted;
    const known = stopped ? { report: null, check: null } : { report, check };
    batch(() => {
      this.#shown.value = { source: 'search', json, model: model.value, ...wish, ...known };
      this.#end(stopped ? 'cancelled' : 'solved', stopped ? text.solve.cancelledUnchecked : '');
      this.#addFinal(json, report);
    });
  }

  /** The finished model is the last of the layouts. */
  #addFinal(json: string, report: Report): void {
    const { layouts, progress } = this.#state.value;
    const others = layouts.filter((layout) => layout.json !== json);
    if (progress && others.length > 0) {
      const objective = report.objective ?? progress.objective;
      const final = { ...pointOf(progress), ...tallies(report), objective, json };
      this.#state.value = { ...this.#state.value, layouts: keptLayouts([...others, final]) };
    }
  }

  async #cancelled(): Promise<void> {
    const shown = this.#shown.value;
    this.#end('cancelled', shown ? text.solve.cancelled : text.solve.cancelledNone);
    if (shown && !shown.report) {
      const check = await this.#checkAside(shown.json);
      if (this.#shown.value === shown && this.#running === null) {
        this.#shown.value = { ...shown, report: { buildable: check?.buildable ?? false }, check };
      }
    }
  }

  /** A check that the next search ends. */
  #checkAside(json: string): Promise<CheckReport | null> {
    this.#checking?.abort();
    this.#checking = new AbortController();
    return this.#check(json, this.#checking.signal);
  }

  async #check(json: string, signal: AbortSignal): Promise<CheckReport | null> {
    try {
      const checked = await this.#client.check(json, signal);
      return checked.outcome === 'ok' ? (JSON.parse(checked.text) as CheckReport) : null;
    } catch {
      return null;
    }
  }

  #end(phase: SolveState['phase'], message: string): void {
    this.#state.value = { ...this.#state.value, phase, message };
  }
}

function wishOf({ sketch, settings }: MadeModel): Wish {
  return { sketch, parts: partsText(settings) };
}

/** The state of a search after it has told of its progress, and of a model or none. */
function grown(state: SolveState, progress: SolveProgress, json: string | null): SolveState {
  const { chart, layouts } = state;
  const point = pointOf(progress);
  const known = Number.isFinite(progress.objective);
  const kept = chart.length >= MAX_CHART_POINTS ? chart.filter((_, i) => i % 2 === 0) : chart;
  return {
    phase: 'solving',
    progress,
    chart: known ? [...kept, point] : chart,
    layouts: json === null || !known ? layouts : keptLayouts([...layouts, { ...point, json }]),
    message: '',
  };
}

/** The report with the seconds that the search took here. */
function timedReport(result: Extract<SolveResult, { outcome: 'solved' }>): Report {
  const report = JSON.parse(result.reportJson) as Report;
  const { total, byPhase } = result.seconds;
  const seconds = report.seconds ?? {
    stageOne: byPhase['stageOne'] ?? 0,
    stageTwo: byPhase['stageTwo'] ?? 0,
    total,
  };
  return { ...report, seconds };
}

function tallies(report: Report): Partial<ChartPoint> {
  const { beams, gaps, collisions, failedConnections } = report;
  const known = Object.entries({ beams, gaps, collisions, failedConnections });
  return Object.fromEntries(known.filter(([, value]) => value !== undefined));
}

function pointOf(progress: SolveProgress): ChartPoint {
  const { iterations, objective, temperature, terms } = progress;
  const { beams, gaps, collisions, failedConnections } = progress;
  return {
    iterations,
    objective,
    temperature,
    terms,
    beams,
    gaps,
    collisions,
    failedConnections,
  };
}

/** At most MAX_LAYOUTS: every other one goes, but not the first and not the last. */
export function keptLayouts(layouts: readonly LayoutSnapshot[]): readonly LayoutSnapshot[] {
  return layouts.length <= MAX_LAYOUTS
    ? layouts
    : layouts.filter((_, i) => i % 2 === 0 || i === layouts.length - 1);
}

/** The sketch that a model file was made for, or null. */
function sketchIn(json: string): SketchDocument | null {
  const value: unknown = JSON.parse(json);
  if (typeof value !== 'object' || value === null || !('sketch' in value)) {
    return null;
  }
  const sketch = readSketchValue(value.sketch);
  return sketch.ok ? sketch.value : null;
}
