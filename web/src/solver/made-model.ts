import type { SketchDocument } from '../model/sketch.ts';
import type { SolveSettings } from './protocol.ts';

/** All that a search and a check have given for a sketch: enough to show it as if it had just been searched for. */
export interface MadeModel {
  readonly sketch: SketchDocument;
  readonly settings: SolveSettings;
  readonly modelJson: string;
  readonly reportJson: string;
  readonly checkJson: string;
  /** What edits go on from; null where it does not come along: confirming the model brings it. */
  readonly layoutJson: string | null;
}
