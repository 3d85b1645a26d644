import type { Catalogue } from '../model/catalogue.ts';
import { guestPart } from '../model/guests.ts';
import { findMend } from '../model/mends.ts';
import type { Model } from '../model/model.ts';
import type { CheckReport } from '../model/report.ts';
import type { SolverClient } from '../solver/worker-client.ts';
import { fillWords } from '../tools/tool-words.ts';
import { partName } from '../ui/text/part-names.ts';
import { text } from '../ui/text.ts';
import type { SolveRun } from './solve-run.ts';
import type { Toaster } from './toasts.ts';

interface MendContext {
  readonly run: SolveRun;
  readonly client: SolverClient;
  readonly catalogue: Catalogue;
  readonly toaster: Toaster;
}

/** Mends of the model that a file held: one part for another, taken at once and taken back by a click. */
export class FileMend {
  readonly #context: MendContext;
  #looking = false;
  #dismiss: () => void = () => undefined;

  constructor(context: MendContext) {
    this.#context = context;
  }

  /** What is to be done when a file's model comes on screen: its unknown parts are known from then on. */
  welcome({ guests }: Model): void {
    this.#context.catalogue.welcome((guests?.kinds ?? []).map(guestPart));
  }

  /** Looks for a mend of the model on screen. Never rejects. */
  readonly mend = async (): Promise<void> => {
    const { run, toaster, catalogue } = this.#context;
    const shown = run.shown.peek();
    if (this.#looking || shown?.source !== 'file' || !shown.check) {
      return;
    }
    this.#looking = true;
    this.#dismiss();
    const stop = new AbortController();
    const done = toaster.busy(text.mends.looking, {
      label: text.commands.cancel,
      run: () => stop.abort(),
    });
    try {
      const { json, model, check } = shown;
      const ask = (file: string) => this.#problems(file, stop.signal);
      const mend = await findMend({ json, model, problems: check.problems, catalogue, ask });
      if (run.shown.peek() !== shown) {
        return;
      }
      if (!mend) {
        toaster.info(text.mends.none);
        return;
      }
      await this.#show(mend.json);
      const words = {
        before: partName(mend.before, catalogue),
        after: partName(mend.after, catalogue),
        n: mend.left,
      };
      const undo = () => {
        this.#dismiss();
        this.#show(json).catch(() => undefined);
      };
      const said = mend.left === 0 ? text.mends.done : text.mends.part;
      this.#dismiss = toaster.busy(fillWords(said, words), {
        label: text.commands.undo,
        run: undo,
      });
    } catch {
      // Given up, or the solver went: the model stays as it is.
    } finally {
      this.#looking = false;
      done();
    }
  };

  async #problems(json: string, signal: AbortSignal): Promise<CheckReport['problems'] | null> {
    const checked = await this.#context.client.check(json, signal);
    return checked.outcome === 'ok' ? (JSON.parse(checked.text) as CheckReport).problems : null;
  }

  async #show(json: string): Promise<void> {
    // Its drawing, where it has one, is on the page already.
    const on = { model: (model: Model) => this.welcome(model), sketch: () => undefined };
    await this.#context.run.showFile(json, on);
  }
}
