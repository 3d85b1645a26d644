import { withGuestsAsParts } from '../model/guests.ts';
import type { Model } from '../model/model.ts';
import { readPartsList } from '../model/parts-list.ts';
import type { SketchDocument } from '../model/sketch.ts';
import { encodeShare } from '../share/codec.ts';
import { decodeText } from '../share/decode-text.ts';
import { sharedState } from '../share/shared-state.ts';
import type { SolverClient } from '../solver/worker-client.ts';
import type { LegalOffer } from '../state/legal-offer.ts';
import { writeSketch } from '../state/read-sketch.ts';
import type { ToolId } from '../tools/tool.ts';
import { fillWords } from '../tools/tool-words.ts';
import { modelTitle } from '../ui/model-title.ts';
import { copyText } from '../ui/share/copy-text.ts';
import { saveFile } from '../ui/share/save-file.ts';
import { inWords } from '../ui/text/sentences.ts';
import { text } from '../ui/text.ts';
import { fileName } from './download.ts';
import { FileMend } from './file-mend.ts';
import { readOpenedFile } from './files.ts';
import type { PageState } from './page-state.ts';
import { readInWorker } from './reading/file-reader.ts';
import type { SceneBridge } from './scene-bridge.ts';
import type { SolveRun } from './solve-run.ts';
import { textStorage } from './text-storage.ts';
import type { Toaster } from './toasts.ts';

/** Marks an address that this page has written: after a reload the saved sketch is newer than it. */
const OWN_ADDRESS = { liftarm: 'own' } as const;

/** In the storage of this tab: the fragment that it has written last. A reload may lose the mark. */
const OWN_FRAGMENT = 'liftarm/own-fragment';

/** Whether the address came from this page, and not from a link that was opened. */
export function isOwnAddress(): boolean {
  const state: unknown = history.state;
  const marked =
    typeof state === 'object' && state !== null && 'liftarm' in state && state.liftarm === 'own';
  return marked || textStorage('sessionStorage')?.getItem(OWN_FRAGMENT) === location.hash;
}

/** The fragment that was read or written last: any other is a link that was pasted and is still to be read. */
let seenFragment: string | null = null;

/** The address's fragment, to be read now. */
export function takeFragment(): string {
  seenFragment = location.hash;
  return seenFragment.slice(1);
}

/** Writes the page's own address, but never over a link that nobody has read yet. */
function writeAddress(hash: string): void {
  if (location.hash !== seenFragment && !isOwnAddress()) {
    return;
  }
  seenFragment = hash;
  history.replaceState(OWN_ADDRESS, '', hash === '' ? location.pathname + location.search : hash);
  try {
    textStorage('sessionStorage')?.setItem(OWN_FRAGMENT, hash);
  } catch {
    // Full: the mark is enough, nearly always.
  }
}

/** What is read in less is not spoken of. */
const READING_SHOWN_MS = 400;
/** What is no part of a sketch's name. */
const SKETCH_NAME = /(\.sketch)?\.(json|obj)$/i;
const PICTURE = { width: 1600, height: 1200 } as const;

/** What opening and saving need of the page. */
interface FileContext {
  readonly state: PageState;
  readonly scene: SceneBridge;
  readonly toaster: Toaster;
  readonly run: SolveRun;
  readonly client: SolverClient;
  readonly replaceSketch: (sketch: SketchDocument) => void;
  readonly edit: (label: string, next: SketchDocument) => void;
  readonly useTool: (id: ToolId) => void;
  readonly fit: () => void;
}

/** Opening and saving files, and the sketch in the address. */
export class PageFiles {
  readonly #context: FileContext;
  readonly #mends: FileMend;
  /** Of the file that is being read, or was last. */
  #reading = new AbortController();

  constructor(context: FileContext) {
    this.#context = context;
    const { run, client, toaster, state } = context;
    this.#mends = new FileMend({ run, client, toaster, catalogue: state.catalogue });
  }

  /** Looks for a part that fits where one does not, in the model of a file. */
  readonly mendModel = (): void => {
    this.#mends.mend().catch(() => undefined);
  };

  readonly chooseFile = (): void =>
    chooseOne('.json,application/json,.mpd,.ldr,.io,.obj', this.openFile);

  /** Reads a list of owned parts that a person chooses. */
  readonly importOwned = (): void => {
    chooseOne('.csv,.txt,.tsv,.xml,.bsx,text/csv,text/plain,text/xml', (file) => {
      file.arrayBuffer().then(
        (bytes) => this.#showOwned(file.name, decodeText(new Uint8Array(bytes))),
        () => this.#refuse(file.name, text.files.unreadable),
      );
    });
  };

  /** Nothing is taken before a person has seen what was understood of it (owned-preview.tsx). */
  #showOwned(name: string, content: string): void {
    const { catalogue, ownedList } = this.#context.state;
    const known = new Set(catalogue.parts.map(({ id }) => id));
    const list = readPartsList(content, known);
    if (!list.ok) {
      this.#refuse(name, list.message);
      return;
    }
    ownedList.value = { name, list: list.value };
  }

  /** Reads a file; another one that is still being read is given up. */
  readonly openFile = (file: File): void => {
    const { toaster } = this.#context;
    toaster.clearErrors();
    this.#reading.abort();
    const reading = new AbortController();
    this.#reading = reading;
    let done: () => void = () => undefined;
    const timer = setTimeout(() => {
      const label = text.commands.cancel;
      const run = () => reading.abort();
      done = toaster.busy(fillWords(text.files.reading, { name: file.name }), { label, run });
    }, READING_SHOWN_MS);
    this.#open(file, reading.signal)
      .catch(() => (reading.signal.aborted ? null : this.#refuse(file.name, text.files.unreadable)))
      .finally(() => {
        clearTimeout(timer);
        done();
      });
  };

  async #open(file: File, signal: AbortSignal): Promise<void> {
    const { client } = this.#context;
    const { catalogue } = this.#context.state;
    const opened = await readOpenedFile(file, { client, catalogue, read: readInWorker }, signal);
    if (!opened.ok) {
      this.#refuse(file.name, opened.message);
      return;
    }
    if (opened.value.kind === 'offer') {
      this.#offer(file.name, opened.value);
      return;
    }
    for (const note of opened.value.notes) {
      this.#context.toaster.error(
        fillWords(text.files.refused, { name: file.name, message: inWords(note) }),
      );
    }
    if (opened.value.kind === 'sketch') {
      const { sketch } = opened.value;
      const name = sketch.name || file.name.replace(SKETCH_NAME, '');
      this.#context.replaceSketch({ ...sketch, name });
      this.#context.toaster.info(fillWords(text.files.opened, { name }));
      return;
    }
    const on = {
      model: (model: Model) => this.#mends.welcome(model),
      sketch: (sketch: SketchDocument) => this.#context.edit(text.edits.open, sketch),
    };
    const refusal = await this.#context.run.showFile(opened.value.json, on, signal);
    if (refusal !== null) {
      this.#refuse(file.name, refusal);
      return;
    }
    this.#context.useTool('select');
    if (!this.#context.state.shown.value?.sketch) {
      // The sketch on the page has nothing to do with this model.
      const { preferences } = this.#context.state;
      preferences.value = { ...preferences.value, show: 'model' };
    }
    this.#context.fit();
    this.#context.toaster.info(fillWords(text.files.openedModel, { name: file.name }));
  }

  /** Says why a drawing is refused, and shows the nearest that would not be when it is asked for. */
  #offer(name: string, { message, legal }: { message: string; legal: LegalOffer }): void {
    const { state, toaster } = this.#context;
    const named = legal.sketch.name || name.replace(SKETCH_NAME, '');
    toaster.error(fillWords(text.files.refused, { name, message: inWords(message) }), {
      label: text.legal.show,
      run: () => {
        state.legalOffer.value = { ...legal, sketch: { ...legal.sketch, name: named } };
        state.dialog.value = 'legal';
      },
    });
  }

  readonly takeLegal = (): void => {
    const { state, toaster } = this.#context;
    const offer = state.legalOffer.value;
    if (offer) {
      toaster.clearErrors();
      state.dialog.value = null;
      this.#context.replaceSketch(offer.sketch);
    }
  };

  #refuse(name: string, message: string): void {
    this.#context.toaster.error(fillWords(text.files.refused, { name, message: inWords(message) }));
  }

  readonly saveSketch = (): void => {
    const sketch = this.#context.state.store.sketch.value;
    this.#save('sketch.json', writeSketch(sketch), 'application/json');
  };

  readonly saveModel = (): void => {
    const shown = this.#context.state.shown.value;
    if (shown) {
      this.#save('model.json', shown.json, 'application/json');
    }
  };

  readonly exportModel = (format: 'mpd' | 'parts.csv'): void => {
    const shown = this.#context.state.shown.value;
    if (!shown) {
      return;
    }
    const failed = (message: string) =>
      this.#context.toaster.error(
        fillWords(text.files.exportFailed, { message: inWords(message) }),
      );
    this.#context.client.exportModel(withGuestsAsParts(shown.json), format).then(
      (result) => {
        if (result.outcome === 'ok') {
          this.#save(format, result.text, format === 'mpd' ? 'application/x-ldraw' : 'text/csv');
        } else {
          failed(result.message);
        }
      },
      (error: unknown) => failed(error instanceof Error ? error.message : ''),
    );
  };

  readonly savePicture = (): void => {
    this.#context.scene.view
      ?.renderToPng(PICTURE.width, PICTURE.height)
      .then((picture) => saveFile(fileName(this.#title(), 'png'), picture))
      .catch((error: unknown) => this.#context.toaster.error(String(error)));
  };

  #save(extension: string, content: string, type: string): void {
    saveFile(fileName(this.#title(), extension), new Blob([content], { type }));
  }

  /** Puts the sketch into the address. @returns the refusal, or null. */
  async updateAddress(): Promise<string | null> {
    const sketch = this.#context.state.store.sketch.value;
    if (sketch.lines.length === 0) {
      writeAddress('');
      return null;
    }
    const fragment = await encodeShare(sharedState(sketch, this.#context.state.preferences.value));
    if (!fragment.ok) {
      writeAddress('');
      return fragment.message;
    }
    writeAddress(`#${fragment.value}`);
    return null;
  }

  readonly share = (): void => {
    this.updateAddress()
      .then(async (refusal) => {
        if (refusal !== null) {
          this.#context.toaster.error(refusal);
          return;
        }
        await copyText(location.href);
        this.#context.toaster.info(text.files.copied);
      })
      .catch(() => this.#context.toaster.error(text.files.copyFailed));
  };

  #title(): string {
    return modelTitle(this.#context.state);
  }
}

/** Lets a person choose one file. */
function chooseOne(accept: string, take: (file: File) => void): void {
  const input = document.createElement('input');
  input.type = 'file';
  input.accept = accept;
  // In the document: a browser may forget an element that nothing holds while its dialog is open.
  input.hidden = true;
  input.oncancel = () => input.remove();
  input.onchange = () => {
    const file = input.files?.[0];
    input.remove();
    if (file) {
      take(file);
    }
  };
  document.body.append(input);
  input.click();
}
