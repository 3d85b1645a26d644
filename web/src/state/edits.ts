import { type AxisName, add, type Vec3 } from '../geometry/vec.ts';
import {
  type KeepOutBox,
  lineLength,
  pointKey,
  type SketchDocument,
  type SketchJoint,
  type SketchLine,
  type SketchSymmetry,
} from '../model/sketch.ts';

import { followLines } from './follow-lines.ts';
import { followKeep, renumberKeep } from './keeps.ts';
import { paintLines, renumberColours } from './paint-lines.ts';

// Every edit is a function from a sketch to a sketch; nothing here touches a store.

type Mutable<T> = { -readonly [K in keyof T]: T[K] };

/** A map of points: a shift, a turn or a mirror image. */
export type PointMap = (p: Vec3) => Vec3;

/** A map of lines: where one goes, with its hole axis. */
export interface LineMap {
  readonly point: PointMap;
  readonly axis: (axis: AxisName) => AxisName;
}

const AXES: readonly AxisName[] = ['x', 'y', 'z'];

/** Identifies the place of a line whichever way round it was drawn. */
export function lineKey(line: SketchLine): string {
  const a = pointKey(line.from);
  const b = pointKey(line.to);
  return a < b ? `${a}|${b}` : `${b}|${a}`;
}

/** The sketch with more lines at its end; lines that lie there already, and points, are left out. */
export function addLines(sketch: SketchDocument, lines: readonly SketchLine[]): SketchDocument {
  const known = new Set(sketch.lines.map(lineKey));
  const fresh: SketchLine[] = [];
  for (const line of lines) {
    const key = lineKey(line);
    if (!known.has(key) && lineLength(line) >= 0.5) {
      known.add(key);
      fresh.push(line);
    }
  }
  return fresh.length === 0 ? sketch : { ...sketch, lines: [...sketch.lines, ...fresh] };
}

/** The sketch without some lines; joints and symmetries that name lines follow. */
export function removeLines(sketch: SketchDocument, indices: ReadonlySet<number>): SketchDocument {
  if (indices.size === 0) {
    return sketch;
  }
  const renumbered = new Map<number, number>();
  const lines: SketchLine[] = [];
  sketch.lines.forEach((line, index) => {
    if (!indices.has(index)) {
      renumbered.set(index, lines.length);
      lines.push(line);
    }
  });
  const next = withReferences({ ...sketch, lines }, sketch, renumbered);
  return renumberKeep(renumberColours(next, renumbered), renumbered);
}

/** Replaces the lines at the given indices, one for one. */
export function replaceLines(
  sketch: SketchDocument,
  changed: ReadonlyMap<number, SketchLine>,
): SketchDocument {
  const lines = sketch.lines.map((line, i) => changed.get(i) ?? line);
  return followKeep(sketch.lines, { ...sketch, lines });
}

/** Moves, turns or mirrors some lines in place, with what is said about them. */
export function mapLines(
  sketch: SketchDocument,
  indices: ReadonlySet<number>,
  map: LineMap,
): SketchDocument {
  const lines = sketch.lines.map((line, i) => (indices.has(i) ? mapLine(line, map) : line));
  return followLines({ before: sketch, lines, moved: indices, point: map.point });
}

/** One line under a map. */
export function mapLine(line: SketchLine, map: LineMap): SketchLine {
  const mapped: SketchLine = { ...line, from: map.point(line.from), to: map.point(line.to) };
  return line.holeAxis ? { ...mapped, holeAxis: map.axis(line.holeAxis) } : mapped;
}

/** A shift by a vector in modules. */
export function shift(by: Vec3): LineMap {
  return { point: (p) => add(p, by), axis: (axis) => axis };
}

/** The mirror image at the plane where the coordinate along `normal` is `offset`. */
export function mirrorAt(normal: AxisName, offset: number): LineMap {
  const k = AXES.indexOf(normal);
  return {
    point: (p) => withCoordinate(p, k, 2 * offset - (p[k] ?? 0)),
    axis: (axis) => axis,
  };
}

/** A quarter turn about a line through `centre` along `axis`, right-handed. */
export function quarterTurn(axis: AxisName, centre: Vec3): LineMap {
  const k = AXES.indexOf(axis);
  const i = (k + 1) % 3;
  const j = (k + 2) % 3;
  const nameI = AXES[i] ?? 'x';
  const nameJ = AXES[j] ?? 'y';
  return {
    point: (p) => {
      const du = (p[i] ?? 0) - (centre[i] ?? 0);
      const dv = (p[j] ?? 0) - (centre[j] ?? 0);
      const turned = withCoordinate(p, i, (centre[i] ?? 0) - dv);
      return withCoordinate(turned, j, (centre[j] ?? 0) + du);
    },
    axis: (name) => (name === nameI ? nameJ : name === nameJ ? nameI : name),
  };
}

/** The line cut in two at a node of its own; null when `at` is an end or not on it. */
export function splitLine(line: SketchLine, at: Vec3): [SketchLine, SketchLine] | null {
  const first: SketchLine = { ...line, to: at };
  const second: SketchLine = { ...line, from: at };
  const a = lineLength(first);
  const b = lineLength(second);
  const whole = (value: number) => Math.abs(value - Math.round(value)) < 1e-3;
  const onLine = Math.abs(a + b - lineLength(line)) < 1e-6;
  return onLine && a > 0.5 && b > 0.5 && whole(a) && whole(b) ? [first, second] : null;
}

/** Cuts line `index` in two at `at`; the second half goes to the end of the list. */
export function splitAt(sketch: SketchDocument, index: number, at: Vec3): SketchDocument {
  const line = sketch.lines[index];
  const halves = line && splitLine(line, at);
  if (!halves) {
    return sketch;
  }
  const lines = sketch.lines.map((old, i) => (i === index ? halves[0] : old));
  const split = followKeep(sketch.lines, { ...sketch, lines: [...lines, halves[1]] });
  const colour = sketch.colours?.lines?.[index];
  return colour === undefined ? split : paintLines(split, new Set([lines.length]), colour);
}

/** Marks lines as exact (layer 0), or not. */
export function setExact(
  sketch: SketchDocument,
  indices: ReadonlySet<number>,
  exact: boolean,
): SketchDocument {
  return changeLines(sketch, indices, (line) => {
    if (exact) {
      return { ...line, exact: true };
    }
    const { exact: _dropped, ...rest } = line;
    return rest;
  });
}

/** Fixes the hole axis of lines; null leaves it to the program. */
export function setHoleAxis(
  sketch: SketchDocument,
  indices: ReadonlySet<number>,
  axis: AxisName | null,
): SketchDocument {
  return changeLines(sketch, indices, (line) => {
    const { holeAxis: _dropped, ...rest } = line;
    return axis ? { ...rest, holeAxis: axis } : rest;
  });
}

export function addKeepOut(sketch: SketchDocument, box: KeepOutBox): SketchDocument {
  return { ...sketch, keepOut: [...(sketch.keepOut ?? []), box] };
}

export function removeKeepOut(sketch: SketchDocument, index: number): SketchDocument {
  const keepOut = (sketch.keepOut ?? []).filter((_, i) => i !== index);
  return withList(sketch, 'keepOut', keepOut);
}

/** Adds a symmetry at the end of the list. */
export function addSymmetry(sketch: SketchDocument, symmetry: SketchSymmetry): SketchDocument {
  return { ...sketch, symmetries: [...(sketch.symmetries ?? []), symmetry] };
}

export function removeSymmetry(sketch: SketchDocument, index: number): SketchDocument {
  const symmetries = (sketch.symmetries ?? []).filter((_, i) => i !== index);
  return withList(sketch, 'symmetries', symmetries);
}

/** Sets the ground, or takes it away with null. */
export function setGround(sketch: SketchDocument, ground: number | null): SketchDocument {
  const { ground: _dropped, ...rest } = sketch;
  return ground === null ? rest : { ...rest, ground };
}

function changeLines(
  sketch: SketchDocument,
  indices: ReadonlySet<number>,
  change: (line: SketchLine) => SketchLine,
): SketchDocument {
  return { ...sketch, lines: sketch.lines.map((l, i) => (indices.has(i) ? change(l) : l)) };
}

function withCoordinate(p: Vec3, k: number, value: number): Vec3 {
  return [k === 0 ? value : p[0], k === 1 ? value : p[1], k === 2 ? value : p[2]];
}

function withList<K extends 'joints' | 'symmetries' | 'keepOut'>(
  sketch: SketchDocument,
  key: K,
  list: NonNullable<SketchDocument[K]>,
): SketchDocument {
  const next: Mutable<SketchDocument> = { ...sketch };
  if (list.length === 0) {
    delete next[key];
  } else {
    next[key] = list;
  }
  return next;
}

function withReferences(
  next: SketchDocument,
  old: SketchDocument,
  renumbered: ReadonlyMap<number, number>,
): SketchDocument {
  const follow = (list: readonly number[]) =>
    list.flatMap((i) => {
      const to = renumbered.get(i);
      return to === undefined ? [] : [to];
    });
  const joints = (old.joints ?? []).flatMap((joint): SketchJoint[] => {
    if (!joint.between) {
      return [joint];
    }
    const between = joint.between.map(follow).filter((group) => group.length > 0);
    // A joint needs two bodies; with one left it means nothing.
    return between.length >= 2 ? [{ ...joint, between }] : [];
  });
  const symmetries = (old.symmetries ?? []).flatMap((symmetry): SketchSymmetry[] => {
    if (symmetry.kind === 'translation') {
      const pairs = symmetry.pairs.flatMap(([a, b]): [number, number][] => {
        const na = renumbered.get(a);
        const nb = renumbered.get(b);
        return na === undefined || nb === undefined ? [] : [[na, nb]];
      });
      return pairs.length > 0 ? [{ ...symmetry, pairs }] : [];
    }
    if (!symmetry.lines) {
      return [symmetry];
    }
    const lines = follow(symmetry.lines);
    return lines.length > 0 ? [{ ...symmetry, lines }] : [];
  });
  return withList(withList(next, 'joints', joints), 'symmetries', symmetries);
}
