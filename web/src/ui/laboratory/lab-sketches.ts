import { add, scale, type Vec3 } from '../../geometry/vec.ts';
import type { SketchDocument, SketchLine } from '../../model/sketch.ts';
import type { Example } from '../page.ts';

// The sketches of the laboratory: the drawing on the page and enlargements of it, grids and cubes in growing sizes, and
// the examples.

export type LabGroup = 'mine' | 'grids' | 'cubes' | 'examples';

export interface LabSketch {
  readonly id: string;
  readonly group: LabGroup;
  /** Of a grid its cells a side, of a cube its length, of a drawing how much it is enlarged; 0 for examples. */
  readonly size: number;
  readonly sketch: SketchDocument;
}

const TIMES = [1, 2, 3, 4];
const GRIDS = [1, 2, 3, 4, 5, 6, 8, 10];
const CUBES = [4, 8, 12, 16, 24, 32, 48];
/** Modules of a side of a grid's cell, as in the paper. */
const CELL = 4;

/** n by n cells as lines from side to side, like `gridSketch` of scripts/lib/families. */
export function gridSketch(n: number): SketchDocument {
  const far = n * CELL;
  const places = Array.from({ length: n + 1 }, (_, i) => i * CELL);
  const lines: readonly SketchLine[] = [
    ...places.map((y): SketchLine => ({ from: [0, y, 0], to: [far, y, 0] })),
    ...places.map((x): SketchLine => ({ from: [x, 0, 0], to: [x, far, 0] })),
  ];
  return { format: 'technic-sketch', version: 1, name: `grid_${n}`, lines };
}

/** The twelve edges of a cube, in the order of `cubeSketch` there. */
export function cubeSketch(side: number): SketchDocument {
  const base: readonly Vec3[] = [
    [0, 0, 0],
    [side, 0, 0],
    [side, side, 0],
    [0, side, 0],
  ];
  const up: Vec3 = [0, 0, side];
  const ring = (z: Vec3): SketchLine[] =>
    base.map((from, i) => ({ from: add(from, z), to: add(base[(i + 1) % 4] ?? from, z) }));
  const posts = base.map((from): SketchLine => ({ from, to: add(from, up) }));
  const lines = [...ring([0, 0, 0]), ...ring(up), ...posts];
  return { format: 'technic-sketch', version: 1, name: `cube_${side}`, lines };
}

/** Lines alone, each so many times as long: joints and boxes would mean something else. */
export function enlarged(sketch: SketchDocument, times: number): SketchDocument {
  if (times === 1) {
    return sketch;
  }
  const name = `${sketch.name ?? ''} x${times}`.trim();
  const lines = sketch.lines.map(({ from, to }) => ({
    from: scale(from, times),
    to: scale(to, times),
  }));
  return { format: 'technic-sketch', version: 1, name, lines };
}

/** All that there is to choose from; the drawing is left out where nothing is drawn. */
export function labSketches(mine: SketchDocument, examples: readonly Example[]): LabSketch[] {
  const own = mine.lines.length === 0 ? [] : TIMES;
  return [
    ...own.map(
      (size): LabSketch => ({
        id: size === 1 ? 'mine' : `mine-${size}`,
        group: 'mine',
        size,
        sketch: enlarged(mine, size),
      }),
    ),
    ...GRIDS.map(
      (size): LabSketch => ({ id: `grid-${size}`, group: 'grids', size, sketch: gridSketch(size) }),
    ),
    ...CUBES.map(
      (size): LabSketch => ({ id: `cube-${size}`, group: 'cubes', size, sketch: cubeSketch(size) }),
    ),
    ...examples.map(
      ({ file, title, sketch }): LabSketch => ({
        id: file.replace('.sketch.json', ''),
        group: 'examples',
        size: 0,
        sketch: { ...sketch, name: title },
      }),
    ),
  ];
}
