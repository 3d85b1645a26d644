import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import createLiftarmLinkages from '@wasm/liftarm-linkages.js';
import { beforeAll, describe, expect, it } from 'vitest';
import { linkagePaths, pathText } from '../../scripts/lib/linkage-paths.mjs';
import { type DrawnPath, pathJson, readAnswers } from '../../web/src/model/linkage-answer.ts';
import { pathOfShape } from '../../web/src/model/path-shapes.ts';
import { makeTable } from '../../web/src/solver/linkages/linkage-core.ts';
import type { LinkageTable } from '../../web/src/solver/linkages/linkage-module.ts';
import { readSketchValue } from '../../web/src/state/read-sketch.ts';
import { runCommand } from './module.ts';

const WASM = resolve(import.meta.dirname, '../../build/wasm/liftarm-linkages.wasm');

describe('linkages of a path', () => {
  let table: LinkageTable;
  beforeAll(async () => {
    table = makeTable(await createLiftarmLinkages({ wasmBinary: readFileSync(WASM) }));
  });

  it('are the same by command and module, byte for byte', () => {
    const folder = mkdtempSync(join(tmpdir(), 'liftarm-linkages-'));
    const file = join(folder, 'path.json');
    for (const path of linkagePaths().filter((_, i) => i % 12 === 0)) {
      writeFileSync(file, pathText(path));
      const { stdout } = runCommand(['linkage', file, '--json']);
      expect(stdout.trim()).toBe(table.find(pathText(path)).text);
    }
    rmSync(folder, { recursive: true });
  });

  it('are sketches that the page reads, with a crank that must go round', () => {
    for (const shape of ['foot', 'line', 'ellipse'] as const) {
      const drawn: DrawnPath = { ...pathOfShape(shape), normal: 'x' };
      const { ok, text } = table.find(pathJson(drawn));
      expect(ok).toBe(true);
      const answers = readAnswers(text);
      expect(answers.length).toBe(6);
      for (const { sketch } of answers) {
        const read = readSketchValue(sketch);
        expect(read.ok && read.value.version).toBe(2);
        expect(read.ok && read.value.joints?.[0]?.range).toEqual([-180, 180]);
      }
    }
  });

  it('refuses what is no path, with the place', () => {
    expect(table.find('{"format": "technic-path", "version": 1, "points": [[0, 0, 0]]}')).toEqual({
      ok: false,
      text: 'points: 1 points; expected 2 to 5000',
    });
  });
});
