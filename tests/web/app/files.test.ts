import { describe, expect, it } from 'vitest';
import { fileName } from '../../../web/src/app/download.ts';
import { loadExamples } from '../../../web/src/app/example-list.ts';
import { MAX_FILE_BYTES, readOpenedFile } from '../../../web/src/app/files.ts';
import { parseFile } from '../../../web/src/app/reading/parse-file.ts';
import {
  type SolveResult,
  type SolverClient,
  SolverError,
} from '../../../web/src/solver/worker-client.ts';
import { silentClient } from '../helpers/silent-client.ts';
import { catalogue } from '../view/helpers/catalogue.ts';

const SKETCH = '{"format":"technic-sketch","version":1,"lines":[{"from":[0,0,0],"to":[4,0,0]}]}';

function client(answer: SolveResult | Error) {
  return {
    ...silentClient(),
    solve: async () => {
      if (answer instanceof Error) {
        throw answer;
      }
      return answer;
    },
  };
}

const open = (chosen: Parameters<typeof readOpenedFile>[0], core: SolverClient) =>
  readOpenedFile(
    chosen,
    { client: core, catalogue, read: async ({ content, parts }) => parseFile(content, parts) },
    new AbortController().signal,
  );

const file = (text: string, size = text.length) => ({
  size,
  arrayBuffer: async () => new TextEncoder().encode(text).buffer,
});

describe('opened files', () => {
  it('takes a sketch that the core accepts', async () => {
    const read = await open(file(SKETCH), client({ outcome: 'cancelled', modelJson: null }));
    expect(read).toMatchObject({ ok: true, value: { kind: 'sketch' } });
  });

  it('says what the core says', async () => {
    const read = await open(
      file(SKETCH),
      client({ outcome: 'refused', message: 'lines[0]: the words of the core' }),
    );
    expect(read).toEqual({ ok: false, message: 'lines[0]: the words of the core' });
  });

  it('reads a sketch without the core when that cannot run', async () => {
    const read = await open(file(SKETCH), client(new SolverError('no memory')));
    expect(read.ok).toBe(true);
  });

  it('knows a model by its first words', async () => {
    const read = await open(
      file('{"format":"liftarm-model","version":1,"parts":[]}'),
      silentClient(),
    );
    expect(read).toMatchObject({ ok: true, value: { kind: 'model' } });
  });

  it('takes the line segments of an .obj file for a sketch', async () => {
    const read = await open(
      file('# made elsewhere\nv 0 0 0\nv 4 0 0\nl 1 2\n'),
      client({ outcome: 'cancelled', modelJson: null }),
    );
    expect(read).toMatchObject({ ok: true, value: { kind: 'sketch' } });
  });

  it('takes an .mpd file for a model', async () => {
    const read = await open(
      file('0 FILE a.ldr\n1 71 0 0 0 1 0 0 0 1 0 0 0 1 32316.dat\n'),
      silentClient(),
    );
    expect(read).toMatchObject({ ok: true, value: { kind: 'model' } });
  });

  it('gives up at once when it is cancelled', async () => {
    const stop = new AbortController();
    const never = new Promise<never>((_, reject) => {
      stop.signal.addEventListener('abort', () => reject(stop.signal.reason));
    });
    const help = { client: silentClient(), catalogue, read: () => never };
    const reading = readOpenedFile(file(SKETCH), help, stop.signal);
    stop.abort();
    await expect(reading).rejects.toBe(stop.signal.reason);
  });

  it.each([
    ['nothing', file(' \n'), 'empty'],
    ['too much', file('', MAX_FILE_BYTES + 1), 'larger'],
    [
      'what cannot be read',
      { size: 3, arrayBuffer: async () => Promise.reject(new Error('gone')) },
      'could not be read',
    ],
  ])('refuses %s', async (_name, opened, message) => {
    const read = await open(opened, silentClient());
    expect(read.ok ? '' : read.message).toContain(message);
  });
});

describe('file names', () => {
  it.each([
    ['Truss bridge', 'truss-bridge.mpd'],
    ['  ../../etc/passwd ', 'etc-passwd.mpd'],
    ['🙂', 'sketch.mpd'],
    ['', 'sketch.mpd'],
  ])('of %j', (title, name) => {
    expect(fileName(title, 'mpd')).toBe(name);
  });
});

describe('examples', () => {
  it('are all that can be read, in the order of the index', async () => {
    const files: Record<string, unknown> = {
      'examples/index.json': [
        { file: 'a.sketch.json', name: 'A' },
        { file: '../secret.json', name: 'B' },
        { file: 'broken.sketch.json', name: 'C' },
      ],
      'examples/a.sketch.json': JSON.parse(SKETCH),
      'examples/broken.sketch.json': { lines: 7 },
    };
    const examples = await loadExamples(async (path) => files[path] ?? null);
    expect(examples.map(({ title }) => title)).toEqual(['A']);
  });

  it('are none when the index is missing', async () => {
    expect(await loadExamples(async () => null)).toEqual([]);
  });
});
