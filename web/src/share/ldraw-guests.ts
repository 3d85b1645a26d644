import type { Vec3 } from '../geometry/vec.ts';
import { boundsOfPoints } from '../model/bounds.ts';
import type { GuestKind } from '../model/guests.ts';
import { baseNumber } from '../model/part-synonyms.ts';
import { keyOf, type LdrawFile } from './ldraw-rows.ts';
import { compose, type Turned, toModules } from './ldraw-space.ts';

/** Name and box, min before max, of parts by their number; see scripts/make-sizes.mjs. */
export type KnownSizes = Readonly<Record<string, readonly (string | number)[]>>;

/** A shape of more triangles than these is shown as its box: pictures are drawn without a graphics card too. */
const MAX_TRIANGLES = 6000;
const MAX_ROWS = 30_000;
const MAX_DEPTH = 20;
const HOME: Turned = { position: [0, 0, 0], rotation: [1, 0, 0, 0, 1, 0, 0, 0, 1] };
/** Of a part of which nothing is known. */
const UNKNOWN_BOX = { min: [-0.5, -0.5, -0.5], max: [0.5, 0.5, 0.5] } as const;

/** What can be said of a part that the catalogue does not hold: its shape by the document, its name and box by a table. */
export function guestKind(
  id: string,
  file: string,
  files: ReadonlyMap<string, LdrawFile>,
  sizes: KnownSizes,
): GuestKind {
  const found = fileOf(file, files);
  const drawing = new Drawing(files);
  const size = sizes[id] ?? sizes[baseNumber(id)];
  if (found) {
    drawing.draw(found, HOME, 0);
  }
  const drawn = drawing.shape();
  const box = drawn ? boundsOfPoints(pointsOf(drawn.faces)) : boxOf(size);
  const name = plainName(found?.title || String(size?.[0] ?? id));
  return {
    id,
    name,
    ...(box ?? UNKNOWN_BOX),
    faces: drawn?.faces ?? [],
    lines: drawn?.lines ?? [],
  };
}

function plainName(title: string): string {
  return title
    .replace(/^[~=_]+/, '')
    .replace(/\s+/g, ' ')
    .slice(0, 100);
}

function boxOf(size: readonly (string | number)[] | undefined) {
  return size ? boundsOfPoints(pointsOf(size.slice(1).map(Number))) : null;
}

function pointsOf(numbers: readonly number[]): Vec3[] {
  const points: Vec3[] = [];
  for (let i = 0; i + 2 < numbers.length; i += 3) {
    points.push([numbers[i] ?? 0, numbers[i + 1] ?? 0, numbers[i + 2] ?? 0]);
  }
  return points;
}

/** Documents that hold the shapes of parts name them with their folder, or without. */
function fileOf(name: string, files: ReadonlyMap<string, LdrawFile>): LdrawFile | undefined {
  const plain = keyOf(name.replaceAll('\\', '/'));
  return [name, plain, `parts/${plain}`, `p/${plain}`, plain.replace(/^(parts|p)\//, '')]
    .flatMap((key) => files.get(key) ?? files.get(key.replaceAll('/', '\\')) ?? [])
    .at(0);
}

/** Gathers the surfaces of a part, in modules. */
class Drawing {
  readonly #files: ReadonlyMap<string, LdrawFile>;
  readonly #faces: number[] = [];
  readonly #lines: number[] = [];
  #rows = 0;

  constructor(files: ReadonlyMap<string, LdrawFile>) {
    this.#files = files;
  }

  /** Null where the document does not hold it, or too much of it. */
  shape(): { readonly faces: number[]; readonly lines: number[] } | null {
    const whole = this.#rows <= MAX_ROWS && this.#faces.length <= 9 * MAX_TRIANGLES;
    return whole && this.#faces.length > 0 ? { faces: this.#faces, lines: this.#lines } : null;
  }

  draw(file: LdrawFile, at: Turned, depth: number): void {
    for (const line of file.drawn) {
      this.#take(line.trim().split(/\s+/).map(Number), at);
    }
    for (const row of file.rows) {
      this.#rows += 1;
      const inner = fileOf(row.file, this.#files);
      if (inner && depth < MAX_DEPTH && this.#rows <= MAX_ROWS) {
        this.draw(inner, compose(at, row), depth + 1);
      }
    }
  }

  #take(fields: readonly number[], at: Turned): void {
    this.#rows += 1;
    const points = pointsOf(fields.slice(2)).map((p) =>
      toModules(compose(at, { ...HOME, position: p }).position).map(
        (x) => Math.round(x * 1000) / 1000,
      ),
    );
    const [type] = fields;
    const [a = [], b = [], c = [], d = []] = points;
    if (this.#rows > MAX_ROWS || points.flat().some((x) => !Number.isFinite(x))) {
      return;
    }
    if (type === 2 && points.length >= 2) {
      this.#lines.push(...a, ...b);
    } else if (type === 3 && points.length >= 3) {
      this.#faces.push(...a, ...b, ...c);
    } else if (type === 4 && points.length >= 4) {
      this.#faces.push(...a, ...b, ...c, ...a, ...c, ...d);
    }
  }
}
