import { Group } from 'three';
import { type SketchDocument, type SketchNode, sketchNodes } from '../../model/sketch.ts';
import type { ViewTheme } from '../scene/theme.ts';
import type { SketchMarks } from '../view-types.ts';
import { type Dot, Dots } from './dots.ts';
import { SketchGlyphs } from './glyphs.ts';
import { type Segment, ThickLines } from './thick-lines.ts';

/** Widths and diameters on screen, CSS pixels. */
const SIZE = { line: 2.5, strong: 4.5, node: 6.5, end: 9, junction: 11, mark: 18 } as const;

/** The sketch: lines, nodes, joints, boxes and symmetry planes. */
export class SketchLayer {
  readonly group = new Group();
  readonly #lines = new ThickLines({ width: SIZE.line, renderOrder: 10 });
  readonly #ghosts = new ThickLines({ width: 2, renderOrder: 10, dashed: true });
  readonly #strong = new ThickLines({ width: SIZE.strong, renderOrder: 11 });
  readonly #dots = new Dots(12);
  readonly #glyphs = new SketchGlyphs();
  #sketch: SketchDocument | null = null;
  /** All that lines and dots were made from. */
  #shown: readonly unknown[] = [];
  #nodes: readonly SketchNode[] = [];

  constructor() {
    const parts = [this.#lines, this.#ghosts, this.#strong, this.#dots];
    this.group.add(...parts.map((part) => part.object), this.#glyphs.group);
  }

  get sketch(): SketchDocument | null {
    return this.#sketch;
  }

  /** Nodes of the present sketch, for picking. */
  get nodes(): readonly SketchNode[] {
    return this.#nodes;
  }

  set(sketch: SketchDocument | null, marks: SketchMarks, theme: ViewTheme): void {
    this.#glyphs.set(sketch, marks, theme);
    const { hovered, selected, errors, errorPoints } = marks;
    const shown = [sketch, theme, hovered, selected, errors, errorPoints, marks.ghosts];
    if (shown.every((value, i) => value === this.#shown[i])) {
      return;
    }
    this.#shown = shown;
    if (sketch !== this.#sketch) {
      this.#sketch = sketch;
      this.#nodes = sketch ? sketchNodes(sketch.lines) : [];
    }
    const lines = sketch?.lines ?? [];
    const plain: Segment[] = [];
    const strong: Segment[] = [];
    const ghosts: Segment[] = [];
    lines.forEach(({ from, to }, index) => {
      const style = lineStyle(index, marks, theme);
      const bucket = { plain, strong, ghosts }[style.bucket];
      bucket.push({ from, to, colour: style.colour });
    });
    this.#lines.set(plain);
    this.#strong.set(strong);
    this.#ghosts.set(ghosts);
    this.#dots.set([...nodeDots(this.#nodes, marks, theme), ...errorDots(marks, theme)]);
    this.#dots.setInner(theme.backgroundTop);
  }

  setResolution(width: number, height: number, pixelRatio: number): void {
    for (const lines of [this.#lines, this.#ghosts, this.#strong]) {
      lines.setResolution(width, height);
    }
    this.#dots.setPixelRatio(pixelRatio);
  }

  /** Over the bricks, or within them. */
  setOverlay(overlay: 'over' | 'within'): void {
    for (const part of [this.#lines, this.#ghosts, this.#strong, this.#dots]) {
      part.setOverlay(overlay);
    }
  }

  dispose(): void {
    for (const part of [this.#lines, this.#ghosts, this.#strong, this.#dots, this.#glyphs]) {
      part.dispose();
    }
  }
}

interface LineStyle {
  readonly bucket: 'plain' | 'strong' | 'ghosts';
  readonly colour: number;
}

function lineStyle(index: number, marks: SketchMarks, theme: ViewTheme): LineStyle {
  if (marks.hovered === index) {
    return { bucket: 'strong', colour: theme.hovered };
  }
  if (marks.selected?.has(index)) {
    return { bucket: 'strong', colour: theme.selected };
  }
  if (marks.errors?.has(index)) {
    return { bucket: 'strong', colour: theme.error };
  }
  if (marks.ghosts?.has(index)) {
    return { bucket: 'ghosts', colour: theme.ghost };
  }
  return { bucket: 'plain', colour: theme.line };
}

function nodeDots(nodes: readonly SketchNode[], marks: SketchMarks, theme: ViewTheme): Dot[] {
  return nodes.map((node) => {
    const strong = node.lines.some(
      (line) => marks.selected?.has(line) || marks.hovered === line || marks.errors?.has(line),
    );
    const first = node.lines[0] ?? -1;
    const accent = lineStyle(first, marks, theme).colour;
    const colour = node.kind === 'inner' ? theme.node : theme.end;
    return {
      at: node.at,
      size: SIZE[node.kind === 'inner' ? 'node' : node.kind] + (strong ? 2 : 0),
      colour: strong && node.kind !== 'junction' ? accent : colour,
      ring: node.kind === 'junction',
    };
  });
}

function errorDots(marks: SketchMarks, theme: ViewTheme): Dot[] {
  return (marks.errorPoints ?? []).map((at) => ({
    at,
    size: SIZE.mark,
    colour: theme.error,
    ring: true,
  }));
}
