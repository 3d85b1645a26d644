import type { ReadonlySignal, Signal } from '@preact/signals';
import type { AxisName, Vec3 } from '../geometry/vec.ts';
import type { JointPlace } from '../state/joint-edits.ts';
import type { SketchStore } from '../state/store.ts';
import type { JointHandle } from '../view/joint-ring.ts';
import type {
  GuidePlane,
  LinePreview,
  Navigation,
  Pick,
  Projected,
  Ray,
  ScreenPoint,
  SnapKind,
} from '../view/view-types.ts';
import type { ToolWords } from './tool-words.ts';

/** What a tool needs of the view; the scene gives it, tests give a flat stand-in. */
export interface ToolView {
  rayAt(at: ScreenPoint): Ray;
  project(point: Vec3): Projected;
  pickAt(at: ScreenPoint): Pick;
  /** From the eye into the picture, unit length. */
  viewDirection(): Vec3;
  /** CSS pixels that one module takes at what is looked at. */
  pixelsPerModule(): number;
}

/** Which plane is drawn on: chosen by the view, or fixed by its normal axis. */
export type PlaneMode = 'auto' | AxisName;

/** One press, move or release of the first button, a pen or one finger. */
export interface PointerInput extends ScreenPoint {
  readonly shift: boolean;
  readonly alt?: boolean;
  readonly kind: 'mouse' | 'pen' | 'touch';
  /** The second press of a double click. */
  readonly double?: boolean;
}

/** A key as the browser names it. */
export interface KeyInput {
  readonly key: string;
  readonly shift: boolean;
}

/** A short text at a point of space: the length of the line, and why it snaps. */
export interface OverlayLabel {
  readonly at: Vec3;
  readonly main: string;
  readonly note: string;
  readonly kind: SnapKind | 'invalid';
}

/** What a tool shows over the scene. */
export interface ToolOverlay {
  readonly plane: GuidePlane | null;
  /** Where the next point would be placed. */
  readonly cursor: Vec3 | null;
  readonly preview: LinePreview | null;
  readonly label: OverlayLabel | null;
  readonly hovered: number | null;
  /** A selection box in pixels. */
  readonly box: { readonly from: ScreenPoint; readonly to: ScreenPoint } | null;
  /** Typed digits, shown in the size field. */
  readonly typed: string;
  /** How many sizes can be typed for the next step: `6,8,4` are three. */
  readonly sizes: number;
  readonly lock: AxisName | null;
  /** What of a joint's ring is under the pointer or dragged. */
  readonly handle: JointHandle | null;
}

export const EMPTY_OVERLAY: ToolOverlay = {
  plane: null,
  cursor: null,
  preview: null,
  label: null,
  hovered: null,
  box: null,
  typed: '',
  sizes: 0,
  lock: null,
  handle: null,
};

/** What all tools work with. */
export interface ToolContext {
  readonly store: SketchStore;
  /** The joint that is being changed. */
  readonly joint: Signal<JointPlace | null>;
  readonly view: ToolView;
  readonly plane: ReadonlySignal<PlaneMode>;
  readonly nextPlane: () => void;
  /** Says something to people who do not see the picture. */
  readonly announce: (message: string) => void;
  readonly words: ToolWords;
}

export type ToolId =
  | 'select'
  | 'line'
  | 'rectangle'
  | 'box'
  | 'grid'
  | 'hexagon'
  | 'split'
  | 'joint'
  | 'keepOut'
  | 'shaft'
  | 'array'
  | 'measure';

/** One way of working with the pointer and the keyboard. One file each. */
export interface Tool {
  readonly id: ToolId;
  readonly overlay: ReadonlySignal<ToolOverlay>;
  /** One sentence: what to do next. */
  readonly hint: ReadonlySignal<string>;
  /** Who gets a press at this place: the tool, or the camera. */
  navigation(at: PointerInput): Navigation;
  pointerMove(at: PointerInput): void;
  pointerDown(at: PointerInput): void;
  pointerUp(at: PointerInput): void;
  /** The pointer is gone, or the camera has taken it: what this press has begun is dropped. */
  pointerLeave(): void;
  /** @returns true when the key was used. */
  key(input: KeyInput): boolean;
  /** Takes the place of what was typed, as a field of the page that holds it says. */
  type?(value: string): void;
  /** Steps back one thing. @returns false when there was nothing to step back from. */
  escape(): boolean;
  /** Forgets everything under way. */
  reset(): void;
}
