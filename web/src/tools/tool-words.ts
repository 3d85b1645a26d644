import type { BeamKind } from '../model/beam-for.ts';
import type { SnapKind } from '../view/view-types.ts';
import type { ToolId } from './tool.ts';

/** The words that tools say; the page's text table fits it. */
export interface ToolWords {
  readonly hints: Readonly<Record<ToolId, string>> & {
    readonly lineNext: string;
    readonly rectangleNext: string;
    readonly boxNext: string;
    readonly boxHeight: string;
    readonly gridNext: string;
    readonly hexagonNext: string;
    readonly keepOutNext: string;
    readonly shaftNext: string;
    readonly keepOutHeight: string;
    readonly arrayNext: string;
    readonly arrayNone: string;
    readonly measureNext: string;
  };
  readonly snap: Readonly<Record<SnapKind, string>>;
  readonly draw: {
    readonly cursorAt: string;
    readonly lineDrawn: string;
    readonly shaftDrawn: string;
    readonly noWholeLength: string;
    readonly measured: string;
    readonly follow: string;
    /** What a line becomes, by how many beams that takes. */
    readonly becomes: Readonly<Record<BeamKind, string>>;
  };
  readonly joint: {
    readonly axis: string;
    readonly range: string;
    readonly noRange: string;
    readonly degrees: string;
    readonly needsTwo: string;
  };
  readonly edits: {
    readonly draw: string;
    readonly move: string;
    readonly split: string;
    readonly joint: string;
    readonly keepOut: string;
    readonly shaft: string;
    readonly array: string;
  };
}

/** Puts values into the places `{name}` of a sentence. */
export function fillWords(
  sentence: string,
  values: Readonly<Record<string, string | number>>,
): string {
  return sentence.replace(/\{(\w+)\}/g, (whole, key: string) => String(values[key] ?? whole));
}
