// The gallery's models for the scripts that draw, export and print them: solved by the module that the page
// ships, whole, with their gears. Needs build/wasm.
import { readFileSync, writeFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { deflateRawSync } from 'node:zlib';
import gifenc from 'gifenc';
import { encodePng } from './indexed-png.mjs';
import { loadCore } from './load-core.mjs';
import { loadTypeScript } from './load-typescript.mjs';
import { StepError, TOP } from './run.mjs';

export const GALLERY = resolve(TOP, 'public/gallery');

const textOf = (file) => readFileSync(resolve(GALLERY, file), 'utf8');

/** @param {string} [only] ids with commas between them; all when left out. */
export async function openGallery(only) {
  const { tools } = await loadTypeScript('scripts/lib/gallery-tools.ts');
  const core = await loadCore();
  const { models } = JSON.parse(textOf('index.json'));
  const ids = only?.split(',');
  const unknown = ids?.find((id) => !models.some((row) => row.id === id));
  if (unknown !== undefined) {
    throw new StepError(`no model '${unknown}' in the gallery`);
  }
  return {
    tools,
    all: models,
    rows: models.filter(({ id }) => !ids || ids.includes(id)),
    solve: (row) => solveWhole(row, tools, core),
    exported: (row, json, format) => {
      const { status, text } = core.exportModel(json, format);
      if (status !== 'ok') {
        throw new StepError(`${row.id}: ${text}`);
      }
      return text;
    },
  };
}

/**
 * @returns the frame's report, the text of the whole model, the parts that gears have added, and what the page
 *   needs to show the frame without a search.
 */
function solveWhole(row, tools, core) {
  const session = new core.SolverSession(textOf(row.file), JSON.stringify(tools.settings));
  try {
    while (!session.advance(5000)) {
      // The search goes on.
    }
    const reportJson = session.reportJson();
    const report = JSON.parse(reportJson);
    const frame = session.modelJson();
    const made = () => ({
      settings: tools.settings,
      modelJson: frame,
      reportJson,
      checkJson: core.checkModelJson(frame).text,
    });
    if (!row.gears) {
      return { report, json: frame, gears: [], made: row.made ? made() : null };
    }
    const train = tools.readGearTrain(JSON.parse(textOf(row.gears)), tools.catalogue);
    if (!train.ok) {
      throw new StepError(`${row.id}: ${train.message}`);
    }
    return {
      report,
      json: tools.withTrain(frame, train.value, tools.catalogue),
      gears: tools.placeTrain(train.value, 0, tools.catalogue),
      made: null,
    };
  } finally {
    session.delete();
  }
}

/** Writes what the page shows of a model without searching for it (web/src/solver/made-file.ts). */
export function writeMade(file, made) {
  writeFileSync(file, deflateRawSync(JSON.stringify(made), { level: 9 }));
}

/** Draws parts with the page's own renderer into a PNG file. */
export function drawParts(file, parts, tools, { size, colours, style }) {
  const shown = parts.map(tools.drawn);
  const points = shown.flatMap((part) => tools.shelf.corners(part));
  const camera = tools.cameraFor(points, tools.ISO_OUT, size);
  const picture = tools.drawPicture(shown, camera, tools.shelf, style);
  const palette = gifenc.quantize(picture.data, colours, { format: 'rgba4444' });
  const indices = gifenc.applyPalette(picture.data, palette, 'rgba4444');
  writeFileSync(file, encodePng(picture.width, picture.height, indices, palette));
}
