import type { Vec3 } from '../../geometry/vec.ts';
import type { Catalogue } from '../../model/catalogue.ts';
import { withGuestsAsParts } from '../../model/guests.ts';
import type { Model } from '../../model/model.ts';
import type { SketchDocument } from '../../model/sketch.ts';
import type { ExportFormat } from '../../solver/protocol.ts';
import { writeSketch } from '../../state/read-sketch.ts';
import { cameraFor, ISO_OUT } from '../../view/drawing/drawing-camera.ts';
import { drawn, MeshShelf } from '../../view/drawing/drawn-part.ts';
import { writeLineArt } from '../../view/drawing/line-art.ts';
import { drawPicture } from '../../view/drawing/picture.ts';
import { writeStl } from '../../view/export/stl.ts';
import { pictureBlob } from './picture-blob.ts';
import { roomSolver } from './room-solver.ts';
import type { shareWords } from './share-words.ts';

export type FileKind = keyof typeof shareWords.files;
export type FileGroup = keyof typeof shareWords.groups;

/** What a file is made from. */
export interface FileSource {
  readonly title: string;
  readonly sketch: SketchDocument;
  /** The model file's text and content; null before there is a model. */
  readonly model: { readonly json: string; readonly model: Model } | null;
  readonly catalogue: Catalogue;
  /** From the model towards the eye, for pictures. */
  readonly out: Vec3;
}

interface FileRow {
  readonly kind: FileKind;
  readonly group: FileGroup;
}

/** All files, in the order in which they are offered. */
export const FILE_ROWS: readonly FileRow[] = [
  { kind: 'mpd', group: 'building' },
  { kind: 'parts.csv', group: 'buying' },
  { kind: 'wanted.xml', group: 'buying' },
  { kind: 'spreadsheet.csv', group: 'buying' },
  { kind: 'glb', group: 'shapes' },
  { kind: 'stl', group: 'shapes' },
  { kind: 'png', group: 'shapes' },
  { kind: 'svg', group: 'shapes' },
  { kind: 'inp', group: 'stress' },
  { kind: 'apdl', group: 'stress' },
  { kind: 'sketch.json', group: 'own' },
  { kind: 'model.json', group: 'own' },
];

/** What only counts and places parts has those that are not known too. */
const WITH_GUESTS: readonly FileKind[] = ['mpd', 'parts.csv', 'wanted.xml', 'spreadsheet.csv'];
const PICTURE = { width: 2000, height: 1500, margin: 40 } as const;
const CORE_TYPES: Readonly<Partial<Record<FileKind, string>>> = {
  mpd: 'application/x-ldraw',
  'parts.csv': 'text/csv',
  'wanted.xml': 'application/xml',
  'spreadsheet.csv': 'text/csv',
  inp: 'text/plain',
  apdl: 'text/plain',
};

/** Makes a file. @throws Error with one sentence when it cannot be made. */
export async function makeFile(kind: FileKind, source: FileSource): Promise<Blob> {
  if (kind === 'sketch.json') {
    return new Blob([writeSketch(source.sketch)], { type: 'application/json' });
  }
  if (!source.model) {
    throw new Error('there is no model yet');
  }
  const { json, model } = source.model;
  const type = CORE_TYPES[kind];
  if (type !== undefined) {
    const placed = WITH_GUESTS.includes(kind) ? withGuestsAsParts(json) : json;
    const reply = await roomSolver().exportModel(placed, kind as ExportFormat);
    if (reply.outcome === 'refused') {
      throw new Error(reply.message);
    }
    return new Blob([reply.text], { type });
  }
  return kind === 'model.json'
    ? new Blob([json], { type: 'application/json' })
    : makeShape(kind, model, source);
}

async function makeShape(kind: FileKind, model: Model, source: FileSource): Promise<Blob> {
  const shelf = new MeshShelf(source.catalogue);
  const out = source.out ?? ISO_OUT;
  const parts = model.parts.map(drawn);
  if (kind === 'glb') {
    const { writeGlb } = await import('../../view/export/glb.ts');
    return new Blob([await writeGlb(model, shelf)], { type: 'model/gltf-binary' });
  }
  if (kind === 'stl') {
    return new Blob([writeStl(model, shelf)], { type: 'model/stl' });
  }
  if (kind === 'svg') {
    return new Blob([writeLineArt(parts, out, shelf, source.title)], { type: 'image/svg+xml' });
  }
  const points = parts.flatMap((part) => shelf.corners(part));
  return pictureBlob(drawPicture(parts, cameraFor(points, out, PICTURE), shelf));
}
