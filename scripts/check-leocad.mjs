// `node scripts/check-leocad.mjs [--out DIR]`: solves every gallery model, lets LeoCAD render its LDraw
// file without a screen, and draws ours beside it. Needs leocad, xvfb, xauth and the LDraw geometry of
// ../shared/ldraw. Ends with 1 when LeoCAD complains, misses a part, or draws nothing.
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import gifenc from 'gifenc';
import { encodePng } from './lib/indexed-png.mjs';
import { loadTypeScript } from './lib/load-typescript.mjs';
import { capture, exitWith, StepError, TOP } from './lib/run.mjs';

const GALLERY = resolve(TOP, 'public/gallery');
const LDRAW = resolve(TOP, '../shared/ldraw');
const SIZE = { width: 900, height: 700, margin: 20 };
const SCREEN = '-screen 0 1280x1024x24 +extension GLX';

const { values: options } = parseArgs({
  options: {
    out: { type: 'string', default: resolve(TOP, 'build/leocad') },
    command: { type: 'string', default: resolve(TOP, 'build/native/liftarm') },
    only: { type: 'string' },
  },
});

/** What LeoCAD says and draws. */
function render(mpd, picture) {
  rmSync(picture, { force: true });
  const args = ['-a', '-s', SCREEN, 'leocad', '-l', LDRAW, '-i', picture];
  const size = ['-w', `${SIZE.width}`, '-h', `${SIZE.height}`];
  const result = spawnSync('xvfb-run', [...args, ...size, mpd], {
    encoding: 'utf8',
    timeout: 120_000,
  });
  return { code: result.status, said: `${result.stdout ?? ''}${result.stderr ?? ''}`.trim() };
}

/** Part files that the document names and the library does not have. */
function missingParts(mpd) {
  const named = new Set();
  for (const line of readFileSync(mpd, 'utf8').split('\n')) {
    const fields = line.trim().split(/\s+/);
    if (fields[0] === '1' && fields.at(-1).endsWith('.dat')) {
      named.add(fields.at(-1));
    }
  }
  return [...named].filter((file) => !existsSync(join(LDRAW, 'parts', file)));
}

function drawOurs(model, file, tools) {
  const parts = model.parts.map(tools.drawn);
  const points = parts.flatMap((part) => tools.shelf.corners(part));
  const picture = tools.drawPicture(
    parts,
    tools.cameraFor(points, tools.ISO_OUT, SIZE),
    tools.shelf,
  );
  const palette = gifenc.quantize(picture.data, 128, { format: 'rgba4444' });
  const indices = gifenc.applyPalette(picture.data, palette, 'rgba4444');
  writeFileSync(file, encodePng(picture.width, picture.height, indices, palette));
}

async function main() {
  if (!existsSync(LDRAW)) {
    throw new StepError('../shared/ldraw is not there');
  }
  const { tools } = await loadTypeScript('scripts/lib/gallery-tools.ts');
  mkdirSync(options.out, { recursive: true });
  const { models } = JSON.parse(readFileSync(resolve(GALLERY, 'index.json'), 'utf8'));
  const faults = [];
  for (const row of models.filter(({ id }) => !options.only || id === options.only)) {
    const args = ['solve', resolve(GALLERY, row.file), '-o', options.out, '--seed', '1', '--json'];
    const { code } = capture(options.command, args);
    const stem = join(options.out, row.file.split('/').at(-1).replace('.sketch.json', ''));
    const mpd = `${stem}.mpd`;
    const picture = `${stem}.leocad.png`;
    const { said } = render(mpd, picture);
    const missing = missingParts(mpd);
    const drawn = existsSync(picture) && statSync(picture).size > 5000;
    if (code !== 0 || missing.length > 0 || !drawn) {
      faults.push(`${row.id}: exit ${code}, missing ${missing.join(' ') || 'none'}, ${said}`);
    }
    drawOurs(JSON.parse(readFileSync(`${stem}.model.json`, 'utf8')), `${stem}.ours.png`, tools);
    console.log(`${row.id.padEnd(16)} ${drawn ? 'drawn' : 'NOT DRAWN'} ${said.split('\n')[0]}`);
  }
  if (faults.length > 0) {
    throw new StepError(faults.join('\n'));
  }
}

main().catch(exitWith);
