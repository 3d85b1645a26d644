import { spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { describe, expect, it } from 'vitest';
import { decodeText } from '../../web/src/share/decode-text.ts';
import { looksLikeMpd, readMpd } from '../../web/src/share/read-mpd.ts';
import { catalogue } from '../web/view/helpers/catalogue.ts';

// The page and the command read LDraw files each with a reader of its own: they say the same.

const TOP = resolve(import.meta.dirname, '../..');
const COMMAND = join(TOP, 'build/native/liftarm');
const CASES = resolve(TOP, '../shared/cases/ldraw');
const FOLDER = mkdtempSync(join(tmpdir(), 'liftarm-ldraw-'));

interface Row {
  readonly part: string;
  readonly color: number;
  readonly position: readonly number[];
  readonly rotation: readonly number[];
}

/** What was read, or why not. */
interface Read {
  readonly parts: readonly string[];
  readonly said: readonly string[];
}

const rowText = ({ part, color, position, rotation }: Row) =>
  [
    part,
    color,
    ...[...position, ...rotation].map((x) => (x + 0).toFixed(5).replace('-0.00000', '0.00000')),
  ].join(' ');

function byPage(bytes: Uint8Array<ArrayBuffer>): Read {
  const text = decodeText(bytes);
  const notes: string[] = [];
  const read = looksLikeMpd(text)
    ? readMpd(text, catalogue, { note: (sentence) => notes.push(sentence) })
    : ({ ok: false, message: 'no LDraw file' } as const);
  return read.ok
    ? { parts: (JSON.parse(read.value) as { parts: Row[] }).parts.map(rowText), said: notes }
    : { parts: [], said: [read.message] };
}

function byCommand(file: string): Read {
  const out = join(FOLDER, 'out.model.json');
  const { status, stdout, stderr } = spawnSync(COMMAND, ['import', file, '-o', out], {
    encoding: 'utf8',
  });
  if (status !== 0) {
    return { parts: [], said: [stderr.trim().replace(`liftarm: ${file}: `, '')] };
  }
  const { parts } = JSON.parse(readFileSync(out, 'utf8')) as { parts: Row[] };
  const notes = stdout.split('\n').filter((line) => line !== '');
  return { parts: parts.map(rowText), said: notes.map((note) => note.replace('NOTE: ', '')) };
}

const BEAM = '0 0 0 1 0 0 0 1 0 0 0 1 32523.dat';

/** Habits of files that are told in few words. */
const OWN: Readonly<Record<string, string>> = {
  'rows before the first file': `1 4 ${BEAM}\n0 FILE b.ldr\n1 4 ${BEAM}\n`,
  'numbers of every kind': '1 4 1e1 +2.5 -.5 1 0 0 0 1 0 0 0 1 32523.dat\n',
  'a number that is none': '1 4 0 0 Infinity 1 0 0 0 1 0 0 0 1 32523.dat\n',
  'a number beside letters': '1 4 0 0 3mm 1 0 0 0 1 0 0 0 1 32523.dat\n',
  'a mixed colour': `1 0x2FA4C1E ${BEAM}\n1 #2001020 ${BEAM}\n1 0xFFEEDD ${BEAM}\n`,
  'a print and a mould':
    '1 4 0 0 0 1 0 0 0 1 0 0 0 1 32316pr0002a.dat\n1 4 0 0 0 1 0 0 0 1 0 0 0 1 3713b.dat\n',
  'a mirrored bent beam':
    '1 4 3 4 5 1 0 0 0 -1 0 0 0 1 32348.dat\n1 4 0 0 0 0 1 0 1 0 0 0 0 1 32140.dat\n',
  'a turned submodel': `0 FILE a.ldr\n1 4 10 20 30 0 0 1 0 1 0 -1 0 0 b b.ldr\n0 FILE b  b.ldr\n1 16 5 5 5 0.6 0.8 0 -0.8 0.6 0 0 0 1 32523.dat\n`,
  'a shape of a known part': `0 FILE a.ldr\n1 4 ${BEAM}\n0 FILE 32523.dat\n1 16 0 0 0 1 0 0 0 1 0 0 0 1 s\\x.dat\n`,
  'a shape of an unknown part': `0 FILE a.ldr\n1 4 ${BEAM}\n1 4 0 0 0 1 0 0 0 1 0 0 0 1 l.dat\n0 FILE l.dat\n1 16 0 0 0 1 0 0 0 1 0 0 0 1 s\\x.dat\n`,
  'a drawn part of any name': `0 FILE a.ldr\n1 4 ${BEAM}\n1 4 0 0 0 1 0 0 0 1 0 0 0 1 l.ldr\n0 FILE l.ldr\n3 16 0 0 0 1 0 0 0 1 0\n`,
  'a submodel that draws': `0 FILE a.ldr\n1 4 0 0 0 1 0 0 0 1 0 0 0 1 l.ldr\n0 FILE l.ldr\n2 24 0 0 0 1 0 0\n1 4 ${BEAM}\n`,
  'a submodel with the ending of a part': `0 FILE a.ldr\n1 4 0 0 0 1 0 0 0 1 0 0 0 1 l.dat\n0 FILE l.dat\n1 4 ${BEAM}\n`,
  'a shape that holds itself': `0 FILE a.ldr\n1 4 ${BEAM}\n1 4 0 0 0 1 0 0 0 1 0 0 0 1 l.dat\n0 FILE l.dat\n1 16 0 0 0 1 0 0 0 1 0 0 0 1 l.dat\n`,
  'nothing but words': '0 Untitled\n0 Name: a.ldr\n',
  'an unknown part alone': '1 4 0 0 0 1 0 0 0 1 0 0 0 1 parts/3001.dat\n',
};

// Without the command there is nothing to compare with: it is built before the tests of `npm test`.
describe.runIf(existsSync(COMMAND))('page and command read alike', () => {
  it.each(existsSync(CASES) ? readdirSync(CASES).sort() : [])('%s', (name) => {
    const file = join(CASES, name);
    expect(byCommand(file)).toEqual(byPage(new Uint8Array(readFileSync(file))));
  });

  it.each(Object.entries(OWN))('%s', (_name, text) => {
    const file = join(FOLDER, 'own.ldr');
    writeFileSync(file, text);
    expect(byCommand(file)).toEqual(byPage(new TextEncoder().encode(text)));
  });
});
