import { readdirSync, readFileSync } from 'node:fs';
import { expect, it } from 'vitest';
import { decodeShare, encodeShare } from '../../../web/src/share/codec.ts';
import { readSketchValue } from '../../../web/src/state/read-sketch.ts';
import { mutate, random, withSum } from '../helpers/mutate-link.ts';

const FIXTURES = new URL('./fixtures/', import.meta.url);
const LINKS = readdirSync(FIXTURES).map((name) =>
  readFileSync(new URL(name, FIXTURES), 'utf8').trim(),
);
const COUNT = 10_000;

it(`${COUNT} mutated links give a sentence, nothing, or a sketch that the page accepts or refuses`, async () => {
  const next = random(1);
  let refused = 0;
  for (let i = 0; i < COUNT; i++) {
    const read = await decodeShare(mutate(LINKS[i % LINKS.length] ?? '', next));
    if (read?.ok) {
      // What comes through is a plain document: its reader gives a value or a sentence.
      expect(typeof readSketchValue(read.value.sketch).ok).toBe('boolean');
    } else if (read) {
      refused += 1;
      expect(read.message).toMatch(/link/);
    }
  }
  expect(refused).toBeGreaterThan(COUNT / 2);
});

it('text in a link that unpacks to other things than a sketch is refused', async () => {
  for (const value of [
    'null',
    '[]',
    '{"__proto__":{"x":1}}',
    '[1,2,3,4,5,6,7,8,9]',
    '"<script>"',
  ]) {
    const stream = new Blob([value]).stream().pipeThrough(new CompressionStream('deflate-raw'));
    const bytes = Buffer.from(await new Response(stream).arrayBuffer());
    for (const version of [1, 2]) {
      const read = await decodeShare(withSum(`s${version}.${bytes.toString('base64url')}.x`));
      expect(read?.ok).toBe(false);
    }
  }
});

it('the airplane fits a link of 1,500 characters', async () => {
  const file = new URL('../../../public/examples/airplane.sketch.json', import.meta.url);
  const sketch = readSketchValue(JSON.parse(readFileSync(file, 'utf8')));
  const link =
    sketch.ok && (await encodeShare({ sketch: sketch.value, preset: 'simple', seed: 1 }));
  expect(link !== false && link.ok ? link.value.length : 9999).toBeLessThanOrEqual(1500);
});
