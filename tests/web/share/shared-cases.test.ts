import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { describe, expect, it } from 'vitest';
import { parseFile } from '../../../web/src/app/reading/parse-file.ts';
import { readPartsList } from '../../../web/src/model/parts-list.ts';
import { decodeText } from '../../../web/src/share/decode-text.ts';
import { catalogue } from '../view/helpers/catalogue.ts';

// Files of the kinds that people have trouble with (cases/README.md beside the project), all of them read as the page does.

const CASES = resolve(import.meta.dirname, '../../../../shared/cases');
const there = existsSync(CASES);
const files = (folder: string) => (there ? readdirSync(join(CASES, folder)).sort() : []);
const textOf = (folder: string, file: string) =>
  decodeText(new Uint8Array(readFileSync(join(CASES, folder, file))));

it('the cases are there where all tests must run', () => {
  expect(there || process.env['CI'] !== 'true').toBe(true);
});

/** What is refused, and with which words; everything else gives so many parts. */
const REFUSED: Readonly<Record<string, RegExp>> = {
  'bomb.mpd': /which is the limit/,
  'l08_self_reference.mpd': /holds itself/,
  'l08b_loop.mpd': /holds itself/,
  'l36_short_row.ldr': /^line 2: /,
};
const PARTS: Readonly<Record<string, number>> = {
  'l13b_mirrored_beam.ldr': 1,
  'l26c_missing.ldr': 5,
  'l26d_overlap.ldr': 5,
  'l26e_pin_in_axlehole.ldr': 3,
  'l35_scaled.ldr': 1,
};
/** Rows of hidden and ghost parts are comments to others. */
const ORDINARY = 4;
const NOTED: Readonly<Record<string, RegExp>> = {
  'l09_duplicate_sub.mpd': /more than once/,
  'l10_one_brick.ldr': /3001 \(1\), 58120 \(1\), 56908 \(1\)/,
  'l38_only_submodel_external.ldr': /another file is left out: wheelset\.ldr/,
};

describe('LDraw files', () => {
  it.each(files('ldraw'))('%s', (file) => {
    const read = parseFile(textOf('ldraw', file), catalogue.parts);
    const refused = REFUSED[file];
    if (refused) {
      expect(read.ok ? '' : read.message).toMatch(refused);
      return;
    }
    expect(read.ok ? '' : read.message).toBe('');
    const value = read.ok && read.value.kind === 'model' ? read.value : null;
    const { parts } = JSON.parse(value?.json ?? '{}') as { parts: unknown[] };
    expect(parts).toHaveLength(PARTS[file] ?? ORDINARY);
    const noted = NOTED[file];
    expect(value?.notes.length).toBe(noted ? 1 : 0);
    expect(value?.notes.join()).toMatch(noted ?? /^$/);
  });
});

/** Lines and notes of .obj files; what is not named has no note and is read or refused by its lengths. */
const OBJ: Readonly<Record<string, { lines: number; note?: RegExp }>> = {
  'o05_cr_only.obj': { lines: 2 },
  'o06_backslash.obj': { lines: 4 },
  'o08_mm.obj': { lines: 4, note: /millimetres/ },
  'o09_mm_large.obj': { lines: 2, note: /millimetres/ },
  'o10_metres.obj': { lines: 3, note: /metres/ },
  'o18_curve.obj': { lines: 2 },
  'o19_y_up.obj': { lines: 8, note: /Y is up/ },
  'o20_fwd_index.obj': { lines: 1 },
  'o25_upper.obj': { lines: 1 },
};
const OBJ_REFUSED: Readonly<Record<string, RegExp>> = {
  'o14_decimal_comma.obj': /decimal comma/,
  'o24_nonint.obj': /7\.5.*whole number/,
  'o29_oblique.obj': /plane/,
};

describe('.obj files', () => {
  it.each(files('obj'))('%s', (file) => {
    const read = parseFile(textOf('obj', file), catalogue.parts);
    const value = read.ok && read.value.kind === 'sketch' ? read.value : null;
    const message = !read.ok ? read.message : value?.read.ok === false ? value.read.message : '';
    expect(message).toMatch(OBJ_REFUSED[file] ?? /^$/);
    const wanted = OBJ[file];
    if (wanted) {
      expect(value?.read.ok && value.read.value.lines).toHaveLength(wanted.lines);
    }
    if (value) {
      expect(value.notes.join()).toMatch(wanted?.note ?? /^$/);
    }
  });
});

/** Counts of beams of 7 and 5 and of pins in most of the lists; null where the list has none of a kind. */
const LISTS: Readonly<Record<string, Readonly<Record<string, number>>>> = {
  'd01_rebrickable.csv': { 32524: 4, 32316: 6, 2780: 60 },
  'd02_bom_reordered.csv': { 32524: 4, 32316: 6, 2780: 60 },
  'd03_studio.txt': { 32524: 4, 32316: 6, 2780: 60 },
  'd05_leocad.csv': { 32524: 4, 32316: 6, 2780: 60 },
  'd06_quoted_comma.csv': { 32524: 4, 32316: 6, 2780: 60 },
  'd07_semicolon.csv': { 32524: 4, 32316: 6 },
  'd08_german.csv': { 32524: 4, 32316: 6 },
  'd09_bricklink.xml': { 32524: 4, 2780: 60 },
  'd10_bricklink_store.xml': { 32316: 6 },
  'd11_moulds.csv': {
    32278: 3,
    32525: 2,
    40490: 5,
    41239: 1,
    3713: 16,
    2780: 75,
    32524: 3,
    32316: 2,
    6558: 30,
    '32123b': 6,
  },
  'd12_spare_rows.csv': { 2780: 61 },
  'd13_pickabrick.csv': {},
  'd14_numbers.csv': { 32524: 4, 32316: 6, 2780: 1200, 43857: 12, 32525: 12 },
  'd15_sepline.csv': { 32524: 4, 32316: 6 },
  'd17_plain.txt': { 32524: 8, 32316: 6, 2780: 60, 43857: 4 },
  'd18_utf16.txt': { 32524: 4 },
  'd19_own_sheet.csv': { 32524: 4, 2780: 60 },
  'd20_brickstore.tsv': { 32524: 4, 2780: 60 },
  'd21_cr_only.csv': { 32524: 4, 32316: 6 },
  'd23_mixed.csv': { 32524: 4, 32316: 6 },
  'd25_number_first.csv': { 32524: 4, 32316: 6 },
};
/** Rows that are not understood. */
const ODD: Readonly<Record<string, number>> = {
  // The number of a beam that no source of ours names.
  'd11_moulds.csv': 1,
  'd13_pickabrick.csv': 3,
  'd14_numbers.csv': 1,
};

describe('lists of owned parts', () => {
  const known = new Set(catalogue.parts.map(({ id }) => id));
  it.each(files('parts'))('%s', (file) => {
    const read = readPartsList(textOf('parts', file), known);
    expect(read.ok ? Object.fromEntries(read.value.counts) : read.message).toEqual(LISTS[file]);
    expect(read.ok && read.value.odd.length).toBe(ODD[file] ?? 0);
  });
});
