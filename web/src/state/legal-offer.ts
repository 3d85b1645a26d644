import { nearestLegal, type Segment } from '../geometry/nearest-legal.ts';
import { distance, type Vec3 } from '../geometry/vec.ts';
import type { SketchDocument } from '../model/sketch.ts';
import { readSketchValue } from './read-sketch.ts';

/** What a drawing that cannot be taken as it is would be as the nearest that can. */
export interface LegalOffer {
  readonly sketch: SketchDocument;
  /** Lines as they were drawn, one for each of the sketch. */
  readonly drawn: readonly Segment[];
  /** Lines that change, by index: their lengths before and after, and how far an end moves; modules. */
  readonly changes: readonly {
    readonly line: number;
    readonly before: number;
    readonly after: number;
    readonly moved: number;
  }[];
}

/** More lines than this are not moved together. */
const MOST_LINES = 600;
/** These name places that would have to move along. */
const TIED = ['joints', 'shafts', 'symmetries', 'keep'];
const MOVED = 1e-6;

/** @param json the text of a sketch that was refused. @returns null where nothing legal is near, or it is no sketch. */
export function legalOffer(json: string): LegalOffer | null {
  const value = parsed(json);
  const drawn = value ? segmentsOf(value['lines']) : null;
  if (!value || !drawn || TIED.some((key) => key in value)) {
    return null;
  }
  const found = nearestLegal(drawn);
  const rows = value['lines'] as object[];
  const lines = found?.lines.map((line, i) => ({ ...rows[i], ...line }));
  const read = lines ? readSketchValue({ ...value, lines }) : null;
  if (!found || !read?.ok) {
    return null;
  }
  const changes = found.lines.flatMap((to, line) => {
    const from = drawn[line];
    const moved = found.moved[line] ?? 0;
    return from && moved > MOVED
      ? [
          {
            line,
            before: distance(from.from, from.to),
            after: distance(to.from, to.to),
            moved,
          },
        ]
      : [];
  });
  return { sketch: read.value, drawn, changes };
}

function parsed(json: string): Record<string, unknown> | null {
  try {
    const value: unknown = JSON.parse(json);
    return typeof value === 'object' && value !== null ? (value as Record<string, unknown>) : null;
  } catch {
    return null;
  }
}

function segmentsOf(value: unknown): Segment[] | null {
  if (!Array.isArray(value) || value.length === 0 || value.length > MOST_LINES) {
    return null;
  }
  const lines = value.map((row: unknown) => {
    const { from, to } = (typeof row === 'object' && row !== null ? row : {}) as {
      from?: unknown;
      to?: unknown;
    };
    return isPoint(from) && isPoint(to) ? { from, to } : null;
  });
  return lines.every((line) => line !== null) ? lines : null;
}

function isPoint(value: unknown): value is Vec3 {
  return Array.isArray(value) && value.length === 3 && value.every(Number.isFinite);
}
