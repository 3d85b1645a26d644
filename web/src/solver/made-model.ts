import type { SketchDocument } from '../model/sketch.ts';
import type { SolveSettings } from '../solver/protocol.ts';

/** What the search gives for the sketch of a first visit; the build of the page makes it. */
export interface MadeModel {
  readonly sketch: SketchDocument;
  readonly settings: SolveSettings;
  readonly modelJson: string;
  readonly reportJson: string;
  readonly checkJson: string;
  readonly layoutJson: string;
}
