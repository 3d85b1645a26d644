export interface DrawnLine {
  readonly from: readonly number[];
  readonly to: readonly number[];
}

/** A sketch file's content. */
export interface DrawnSketch {
  readonly name: string;
  readonly lines: readonly DrawnLine[];
}

export function sketchText(sketch: DrawnSketch): string;
