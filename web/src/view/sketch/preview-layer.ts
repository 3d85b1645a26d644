import { Group } from 'three';
import { lineNodes } from '../../model/sketch.ts';
import type { ViewTheme } from '../scene/theme.ts';
import type { LinePreview, SnapKind } from '../view-types.ts';
import { type Dot, type DotShape, Dots } from './dots.ts';
import { type Segment, ThickLines } from './thick-lines.ts';

/** Each reason to snap has its colour (the theme's) and its mark. */
const SNAP_SHAPES: Readonly<Record<SnapKind, DotShape>> = {
  grid: 'disc',
  plane: 'disc',
  end: 'square',
  node: 'disc',
  axis: 'diamond',
  'in-line': 'diamond',
  pythagorean: 'triangle',
  sixty: 'triangle',
};

/** Pixels. */
const GHOST = 8;

/** The line being drawn, its nodes, its snap mark, and the lines that the snap refers to. */
export class PreviewLayer {
  readonly group = new Group();
  readonly #line = new ThickLines({ width: 4, renderOrder: 20 });
  readonly #guides = new ThickLines({ width: 1.5, renderOrder: 19, dashed: true, opacity: 0.8 });
  readonly #dots = new Dots(21);

  constructor() {
    const parts = [this.#line, this.#guides, this.#dots];
    this.group.add(...parts.map((part) => part.object));
    for (const part of parts) {
      part.setOverlay('over');
    }
  }

  set(preview: LinePreview | null, theme: ViewTheme): void {
    const colour = preview?.state === 'invalid' ? theme.error : theme.preview;
    const snap = preview?.snap ? theme.snaps[preview.snap] : colour;
    this.#line.set(preview ? previewSegments(preview, colour) : []);
    this.#guides.set((preview?.guides ?? []).map(([from, to]) => ({ from, to, colour: snap })));
    const ghosts = (preview?.ghosts ?? []).map(
      (at): Dot => ({ at, size: GHOST, colour: theme.ghost, ring: true }),
    );
    this.#dots.set(preview ? [...ghosts, ...previewDots(preview, colour, snap)] : []);
    this.#dots.setInner(theme.backgroundTop);
  }

  setResolution(width: number, height: number, pixelRatio: number): void {
    this.#line.setResolution(width, height);
    this.#guides.setResolution(width, height);
    this.#dots.setPixelRatio(pixelRatio);
  }

  dispose(): void {
    this.#line.dispose();
    this.#guides.dispose();
    this.#dots.dispose();
  }
}

function previewSegments(preview: LinePreview, colour: number): Segment[] {
  const more = (preview.more ?? []).map(([from, to]) => ({ from, to, colour }));
  return preview.to ? [{ from: preview.from, to: preview.to, colour }, ...more] : more;
}

function previewDots(preview: LinePreview, colour: number, snap: number): Dot[] {
  const { from, to } = preview;
  const start: Dot = { at: from, size: 11, colour };
  if (!to) {
    return [start];
  }
  const shape = preview.snap ? SNAP_SHAPES[preview.snap] : 'disc';
  const inner = lineNodes({ from, to }).slice(1, -1);
  return [
    start,
    ...inner.map((at) => ({ at, size: 6, colour })),
    { at: to, size: shape === 'disc' ? 15 : 19, colour: snap, ring: true, shape },
    { at: to, size: 6, colour },
  ];
}
