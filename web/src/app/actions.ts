import type { AxisName } from '../geometry/vec.ts';
import type { SketchDocument, SketchLine } from '../model/sketch.ts';
import type { ToolId } from '../tools/tool.ts';
import type { StandardView } from '../view/view-types.ts';
import type { PageState } from './page-state.ts';

export interface CameraMove {
  readonly factor: number;
  readonly right: number;
  readonly up: number;
}

/** Opening, saving and sharing. */
export interface FileActions {
  chooseFile(): void;
  saveSketch(): void;
  saveModel(): void;
  exportModel(format: 'mpd' | 'parts.csv'): void;
  savePicture(): void;
  share(): void;
}

/** What the commands are made of. The page does it; tests record it. */
export interface Actions {
  readonly state: PageState;
  /** Lines that were copied last. */
  clipboard: readonly SketchLine[];
  useTool(id: ToolId): void;
  /** Gives the keys to the drawing. */
  focusDrawing(): void;
  /** Puts an edit into the history. */
  edit(label: string, next: SketchDocument): void;
  undo(): void;
  redo(): void;
  newSketch(): void;
  readonly files: FileActions;
  generate(): void;
  cancel(): void;
  fit(): void;
  /** Cuts the model open in its middle; null closes it. */
  cutAlong(axis: AxisName | null): void;
  setView(view: StandardView): void;
  /** Nearer (factor below 1) or farther; turned to the right and upwards by radians. */
  moveCamera(move: CameraMove): void;
  announce(message: string): void;
  /** @param id a place or a room; null goes back to the drawing. */
  openRoom(id: string | null): void;
}
