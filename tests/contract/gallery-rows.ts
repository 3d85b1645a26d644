import { readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { inflateRawSync } from 'node:zlib';
import type { MadeParts } from '../../web/src/solver/made-file.ts';
import type { SolverModule } from '../../web/src/solver/solver-module.ts';
import { solveWithModule } from './module.ts';

// The gallery's models for tests: those that come with the page as they were made, the others searched for.

export interface GalleryTestRow {
  readonly id: string;
  readonly file: string;
  readonly moves: boolean;
  readonly gears?: string;
  readonly made?: boolean;
}

export const GALLERY = resolve(import.meta.dirname, '../../public/gallery');

export const galleryText = (file: string): string => readFileSync(resolve(GALLERY, file), 'utf8');

export const galleryRows = (
  JSON.parse(galleryText('index.json')) as { models: readonly GalleryTestRow[] }
).models;

/** What comes with the page of a large model. */
export function madeOf({ id }: GalleryTestRow): MadeParts {
  const bytes = readFileSync(resolve(GALLERY, `made/${id}.made`));
  return JSON.parse(inflateRawSync(bytes).toString('utf8')) as MadeParts;
}

/** A row's model, without its gears. */
export function modelOf(row: GalleryTestRow, module: SolverModule): string {
  return row.made
    ? madeOf(row).modelJson
    : solveWithModule(module, galleryText(row.file), { seed: 1, preset: 'balanced' }).modelJson;
}
