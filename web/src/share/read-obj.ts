import { bad, good, type Outcome } from '../base/outcome.ts';
import { distance, type Vec3 } from '../geometry/vec.ts';
import type { SketchDocument, SketchLine } from '../model/sketch.ts';

/** An .obj file of this many records is no sketch. */
const MAX_RECORDS = 200_000;
const MAX_LINES = 20_000;
const MAX_COORDINATE = 2000;
const MESH_RECORDS = /^(f|curv|curv2|surf)\s/;

/** What is wrong with a line of the file. */
class Refusal extends Error {}

/**
 * Reads the line segments of a Wavefront .obj file (records `v` and `l`) as modules, Z up.
 * @returns the sketch, or one sentence that names the place. Lengths are judged by the sketch reader.
 */
export function readObj(text: string, name: string): Outcome<SketchDocument> {
  try {
    const lines = readRecords(text);
    return lines.length > 0
      ? good({ format: 'technic-sketch', version: 1, name, lines })
      : bad('the file holds no line segments (records that begin with "l")');
  } catch (error) {
    if (error instanceof Refusal) {
      return bad(error.message);
    }
    throw error;
  }
}

/** Whether a text looks like an .obj file: its first record that says something is one of its own. */
export function looksLikeObj(text: string): boolean {
  const first = text
    .slice(0, 65_536)
    .split(/\r?\n/)
    .find((row) => row.trim() !== '' && !row.startsWith('#'));
  return /^(v|vn|vt|l|o|g|s|mtllib|usemtl|p)\s/.test(first?.trim() ?? '');
}

function readRecords(text: string): SketchLine[] {
  const vertices: Vec3[] = [];
  const lines: SketchLine[] = [];
  const seen = new Set<string>();
  const rows = text.split(/\r?\n/);
  if (rows.length > MAX_RECORDS) {
    throw new Refusal(`the file has ${rows.length} rows, at most ${MAX_RECORDS} are allowed`);
  }
  rows.forEach((row, i) => {
    const place = `line ${i + 1}`;
    const fields = row.trim().split(/\s+/);
    if (fields[0] === 'v') {
      vertices.push(readVertex(fields, place));
    } else if (fields[0] === 'l') {
      addLines(lines, seen, readChain(fields, vertices, place));
    } else if (MESH_RECORDS.test(row.trim())) {
      throw new Refusal(`${place}: a surface; only line segments (v and l) can be read`);
    }
  });
  return lines;
}

function readVertex(fields: readonly string[], place: string): Vec3 {
  const [x, y, z] = fields.slice(1, 4).map(Number);
  const point = [x, y, z];
  if (point.some((v) => v === undefined || !Number.isFinite(v) || Math.abs(v) > MAX_COORDINATE)) {
    throw new Refusal(`${place}: "v" should have three numbers, at most ${MAX_COORDINATE} each`);
  }
  return [clean(x ?? 0), clean(y ?? 0), clean(z ?? 0)];
}

/** Modelling programs write 2.9999998 for 3. */
function clean(value: number): number {
  const rounded = Math.round(value * 1e5) / 1e5;
  return rounded === 0 ? 0 : rounded;
}

function readChain(fields: readonly string[], vertices: readonly Vec3[], place: string): Vec3[] {
  if (fields.length < 3) {
    throw new Refusal(`${place}: "l" should name at least two vertices`);
  }
  return fields.slice(1).map((field) => {
    const number = Number.parseInt(field, 10);
    // Negative numbers count back from the last vertex.
    const vertex = vertices[number > 0 ? number - 1 : vertices.length + number];
    if (number === 0 || !vertex) {
      throw new Refusal(`${place}: there is no vertex ${field}`);
    }
    return vertex;
  });
}

function addLines(lines: SketchLine[], seen: Set<string>, chain: readonly Vec3[]): void {
  for (let i = 0; i + 1 < chain.length; i++) {
    const from = chain[i];
    const to = chain[i + 1];
    const key = [from, to].map(String).sort().join(' ');
    if (from && to && distance(from, to) > 1e-6 && !seen.has(key)) {
      seen.add(key);
      lines.push({ from, to });
    }
  }
  if (lines.length > MAX_LINES) {
    throw new Refusal(`more than ${MAX_LINES} lines, which is the limit`);
  }
}
