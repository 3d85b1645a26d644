import type { AxisName, Mat3, Vec3 } from '../geometry/vec.ts';
import type { Catalogue } from '../model/catalogue.ts';
import type { FoundSymmetry } from '../model/found-symmetries.ts';
import type { Model } from '../model/model.ts';

/** Positions on screen are CSS pixels from the canvas' top left corner; positions in space modules. */
export interface ScreenPoint {
  readonly x: number;
  readonly y: number;
}

export interface Ray {
  readonly origin: Vec3;
  /** Unit length. */
  readonly direction: Vec3;
}

export type ThemeName = 'light' | 'dark';
export type ViewMode = 'sketch' | 'model' | 'both';
export type Projection = 'perspective' | 'orthographic';
export type StandardView = 'front' | 'back' | 'left' | 'right' | 'top' | 'bottom' | 'iso';
export type ColourScheme = 'part' | 'layer' | 'axis' | 'component' | 'piece';

/**
 * Who takes the first button or finger: `orbit` turns the camera; `tool` leaves it to the caller
 * (then the right button or two fingers turn it, the middle button or three fingers shift it).
 */
export type Navigation = 'orbit' | 'tool';

export interface SceneViewOptions {
  readonly catalogue: Catalogue;
  readonly theme?: ThemeName;
  /** Upper limit of device pixels per CSS pixel; 2 when left out. */
  readonly pixelRatioLimit?: number;
  /** No animated camera moves when true; asked of the browser when left out. */
  readonly reducedMotion?: boolean;
  /** Called after each frame drawn: place HTML labels here. The model is given if all its parts were drawn. */
  readonly onFrame?: (model: Model | null) => void;
  /** Called when the graphics context goes away and when it is back. */
  readonly onContext?: (state: 'lost' | 'restored') => void;
}

/** What of the sketch stands out. Sets hold line indices. */
export interface SketchMarks {
  readonly selected?: ReadonlySet<number>;
  readonly hovered?: number | null;
  readonly errors?: ReadonlySet<number>;
  /** Lines of a reflected or otherwise proposed group, drawn dashed. */
  readonly ghosts?: ReadonlySet<number>;
  /** Points to ring: failed junctions, blocked joints. */
  readonly errorPoints?: readonly Vec3[];
  readonly selectedJoint?: number | null;
  /** A mirror plane that is not part of the sketch yet. */
  readonly proposedSymmetry?: FoundSymmetry | null;
}

/** A plane to draw on: perpendicular to an axis, through a point that anchors its unit grid. */
export interface GuidePlane {
  readonly axis: AxisName;
  readonly through: Vec3;
}

/** Why the end of a line snaps where it does; each has its own colour and mark. */
export type SnapKind =
  | 'grid'
  | 'end'
  | 'node'
  | 'axis'
  | 'in-line'
  | 'plane'
  | 'pythagorean'
  | 'sixty';

/** The line being drawn. */
export interface LinePreview {
  readonly from: Vec3;
  /** Null before the first move of the pointer. */
  readonly to: Vec3 | null;
  readonly state: 'ok' | 'invalid';
  readonly snap?: SnapKind;
  /** Further lines that would be drawn with it: mirrored ones, sides of a box. */
  readonly more?: readonly (readonly [Vec3, Vec3])[];
  /** Other places where it could end, pale. */
  readonly ghosts?: readonly Vec3[];
  /** Dashed lines that show what the snap refers to. */
  readonly guides?: readonly (readonly [Vec3, Vec3])[];
}

export interface LinePick {
  readonly index: number;
  /** Nearest point on the line, modules. */
  readonly point: Vec3;
  /** Pixels from the pointer. */
  readonly distance: number;
}

export interface NodePick {
  readonly at: Vec3;
  readonly kind: 'inner' | 'end' | 'junction';
  readonly lines: readonly number[];
  /** Pixels from the pointer. */
  readonly distance: number;
}

export interface PartPick {
  /** Index into the model's parts. */
  readonly index: number;
  readonly point: Vec3;
  /** Modules from the eye. */
  readonly distance: number;
}

/** What of the sketch lies under the pointer; each null when nothing near enough. */
export interface Pick {
  readonly line: LinePick | null;
  readonly node: NodePick | null;
}

/** A point of space on screen. `visible` is false behind the eye. */
export interface Projected extends ScreenPoint {
  readonly visible: boolean;
}

/** A part as it is, as a pale hint of itself, or not at all. */
export type PartLook = 'solid' | 'ghost' | 'hidden';

/** Where a part stands. */
export interface PartPose {
  readonly position: Vec3;
  /** Part frame to world, row-major. */
  readonly rotation: Mat3;
}

/**
 * How parts are drawn in place of how the model has them, by their index: for motion, steps, results
 * of checks. What is left out stays as it is.
 */
export interface PartDisplay {
  /** sRGB by part; null leaves a part the colour of the scheme. */
  readonly colours?: readonly (number | null)[];
  readonly poses?: ReadonlyMap<number, PartPose>;
  readonly looks?: ReadonlyMap<number, PartLook>;
  /** Parts that stand out. */
  readonly highlighted?: ReadonlySet<number>;
}

/** What to show of the model: null shows all. */
export interface Isolation {
  /** Indices into the model's parts that stay. */
  readonly parts: ReadonlySet<number>;
  /** The others vanish or stay as a ghost. */
  readonly others: 'hidden' | 'ghost';
}

/** A cut through the model: what lies beyond the plane along the axis is not drawn. */
export interface Section {
  readonly axis: AxisName;
  readonly offset: number;
}

export interface ModelOptions {
  /** Parts drawn pale because they do not fit the sketch any more: none, some, or all. */
  readonly dimmed?: boolean | ReadonlySet<number>;
}
