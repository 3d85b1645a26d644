// `npm run gallery:leocad [-- --only ID,ID]`: lets LeoCAD render the LDraw file of every gallery model
// without a screen, draws ours from the same side, and lays both beside each other on sheets in build/leocad/.
// Ends with 1 when LeoCAD complains, misses a part, draws nothing, or draws another outline than we do.
// Needs leocad, xvfb, xauth, build/wasm, Chromium, and the LDraw geometry of ../shared/ldraw.
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, rmSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { drawParts, openGallery } from './lib/gallery.mjs';
import { drawSheet, launchBrowser, outlineOverlap } from './lib/picture-sheet.mjs';
import { exitWith, StepError, TOP } from './lib/run.mjs';

const LDRAW = resolve(TOP, '../shared/ldraw');
const PICTURE = { size: { width: 900, height: 700, margin: 20 }, colours: 128 };
const SCREEN = '-screen 0 1280x1024x24 +extension GLX';
/** Share of the two outlines' common area: edges are drawn differently, parts are not. */
const LEAST_OVERLAP = 0.96;
const MODELS_ON_A_SHEET = 4;

const { values: options } = parseArgs({
  options: {
    out: { type: 'string', default: resolve(TOP, 'build/leocad') },
    only: { type: 'string' },
  },
});

/** Degrees above the ground and around the model, for a direction from the model towards the eye. */
function cameraAngles([x, y, z]) {
  const degrees = (radians) => `${(radians * 180) / Math.PI}`;
  return [degrees(Math.atan2(z, Math.hypot(x, y))), degrees(Math.atan2(x, -y))];
}

/** What LeoCAD says while it draws. */
function render(mpd, picture, out) {
  rmSync(picture, { force: true });
  const { width, height } = PICTURE.size;
  const result = spawnSync(
    'xvfb-run',
    [
      ...['-a', '-s', SCREEN, 'leocad', '-l', LDRAW, '-i', picture, '-w', `${width}`],
      ...['-h', `${height}`, '--orthographic', '--camera-angles', ...cameraAngles(out), mpd],
    ],
    { encoding: 'utf8', timeout: 120_000 },
  );
  if (result.error) {
    throw new StepError('xvfb-run is missing (Debian: leocad, xvfb, xauth, libgl1-mesa-dri)');
  }
  return `${result.stdout}${result.stderr}`.trim();
}

/** Part files that the document names and the library does not have. */
function missingParts(mpd) {
  const named = mpd.split('\n').map((line) => line.trim().split(/\s+/));
  const files = named.filter(([kind]) => kind === '1').map((fields) => fields.at(-1));
  return [...new Set(files)].filter(
    (file) => file.endsWith('.dat') && !existsSync(join(LDRAW, 'parts', file)),
  );
}

async function main() {
  if (!existsSync(LDRAW)) {
    throw new StepError('../shared/ldraw is not there');
  }
  const { tools, rows, solve, exported } = await openGallery(options.only);
  mkdirSync(options.out, { recursive: true });
  const browser = await launchBrowser();
  const page = await browser.newPage({ viewport: { width: 1320, height: 100 } });
  const faults = [];
  const pictures = [];
  try {
    for (const row of rows) {
      const { json } = solve(row);
      const mpd = exported(row, json, 'mpd');
      const [file, theirs, ours] = ['mpd', 'leocad.png', 'ours.png'].map((ending) =>
        join(options.out, `${row.id}.${ending}`),
      );
      writeFileSync(file, mpd);
      const said = render(file, theirs, tools.ISO_OUT);
      const missing = missingParts(mpd);
      drawParts(ours, JSON.parse(json).parts, tools, PICTURE);
      const overlap = existsSync(theirs) ? await outlineOverlap(page, ours, theirs) : 0;
      console.log(`${row.id.padEnd(16)} ${(100 * overlap).toFixed(1)} % of the outline`);
      if (missing.length > 0 || overlap < LEAST_OVERLAP || !/^.*Saved '/.test(said)) {
        faults.push(`${row.id}: missing ${missing.join(' ') || 'none'}, ${overlap}, ${said}`);
      }
      pictures.push({ file: ours, title: `${row.id}, ours` });
      pictures.push(...(overlap > 0 ? [{ file: theirs, title: `${row.id}, LeoCAD` }] : []));
    }
    for (let i = 0; i < pictures.length; i += 2 * MODELS_ON_A_SHEET) {
      const sheet = join(options.out, `sheet-${1 + i / (2 * MODELS_ON_A_SHEET)}.png`);
      await drawSheet(page, pictures.slice(i, i + 2 * MODELS_ON_A_SHEET), sheet, 310);
    }
  } finally {
    await browser.close();
  }
  if (faults.length > 0) {
    throw new StepError(faults.join('\n'));
  }
}

main().catch(exitWith);
