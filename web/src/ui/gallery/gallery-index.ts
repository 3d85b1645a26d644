import { type MadeParts, unpackMade } from '../../solver/made-file.ts';
import { readSketchValue } from '../../state/read-sketch.ts';
import type { Example } from '../page.ts';
import { inLanguage } from '../text/language.ts';

/** One model of the gallery, as public/gallery/index.json lists it. */
export interface GalleryRow {
  readonly id: string;
  /** Beside the index. */
  readonly file: string;
  readonly title: string;
  readonly text: string;
  readonly moves: boolean;
  readonly gears: string | null;
  /** Small enough to begin with. */
  readonly firstStep: boolean;
  /** Whether its model comes with the page: searching for it takes longer than a person likes to wait. */
  readonly made: boolean;
  /** Written by scripts/gallery.mjs. */
  readonly beams: number;
  readonly bricks: number;
  /** Grams. */
  readonly mass: number;
}

const FOLDER = 'gallery/';
const FILE = /^(\.\.\/examples\/)?[\w-]+\.(sketch|gears)\.json$/;

/** The address of a file of the gallery. */
export function galleryFile(name: string): string {
  return new URL(FOLDER + name, document.baseURI).href;
}

export function thumbnailOf(row: GalleryRow): string {
  return galleryFile(`thumbs/${row.id}.png`);
}

/** All models of the gallery. @throws Error when the list cannot be had. */
export async function loadGallery(): Promise<GalleryRow[]> {
  const value: unknown = await fetchJson(galleryFile('index.json'));
  const rows =
    typeof value === 'object' && value !== null && 'models' in value ? value.models : null;
  if (!Array.isArray(rows)) {
    throw new Error('the list of models is unreadable');
  }
  return rows.flatMap((row: unknown) => readRow(row) ?? []);
}

/** A model's sketch, ready to be opened. @throws Error when it cannot be had. */
export async function loadGallerySketch(row: GalleryRow): Promise<Example> {
  const sketch = readSketchValue(await fetchJson(galleryFile(row.file)));
  if (!sketch.ok) {
    throw new Error(sketch.message);
  }
  return { file: row.file, title: row.title, description: row.text, sketch: sketch.value };
}

/**
 * What the default search gave for a model's sketch when the gallery was made.
 * @throws Error when it cannot be had.
 */
export async function loadMade(row: GalleryRow): Promise<MadeParts> {
  const reply = await fetchFile(galleryFile(`made/${row.id}.made`));
  return unpackMade(await reply.arrayBuffer());
}

export async function fetchJson(address: string): Promise<unknown> {
  return (await fetchFile(address)).json();
}

async function fetchFile(address: string): Promise<Response> {
  const reply = await fetch(address);
  if (!reply.ok) {
    throw new Error(`${reply.status}`);
  }
  return reply;
}

function readRow(value: unknown): GalleryRow | null {
  if (typeof value !== 'object' || value === null) {
    return null;
  }
  const { id, file, title, text, moves, gears, firstStep, made, beams, bricks, mass } =
    value as Record<string, unknown>;
  if (typeof id !== 'string' || typeof file !== 'string' || !FILE.test(file)) {
    return null;
  }
  return {
    id,
    file,
    title: inLanguage(title),
    text: inLanguage(text),
    moves: moves === true,
    gears: typeof gears === 'string' && FILE.test(gears) ? gears : null,
    firstStep: firstStep === true,
    made: made === true,
    beams: Number(beams) || 0,
    bricks: Number(bricks) || 0,
    mass: Number(mass) || 0,
  };
}
