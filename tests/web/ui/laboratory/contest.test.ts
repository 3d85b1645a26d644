import { describe, expect, it } from 'vitest';
import type { SketchDocument } from '../../../../web/src/model/sketch.ts';
import { encodeShare } from '../../../../web/src/share/codec.ts';
import { type Entry, readEntries } from '../../../../web/src/ui/laboratory/contest/entries.ts';
import { type Contest, judgeEntry } from '../../../../web/src/ui/laboratory/contest/judge.ts';
import { type Judged, ranked } from '../../../../web/src/ui/laboratory/contest/ranking.ts';
import { isSameDrawing } from '../../../../web/src/ui/laboratory/contest/same-drawing.ts';
import { cubeSketch, gridSketch } from '../../../../web/src/ui/laboratory/lab-sketches.ts';
import { silentClient } from '../../helpers/silent-client.ts';
import { catalogue } from '../../view/helpers/catalogue.ts';

describe('entries', () => {
  it('are a line each, with name, link and score in their order', () => {
    const link = 'https://a.example/b/?lang=de#s2.AbC-_x.1f';
    expect(readEntries(`Anna ${link} 24\r\n\n"Ben";${link};12,5\n${link}\nCem\n`)).toEqual([
      { name: 'Anna', fragment: 's2.AbC-_x.1f', claimed: 24 },
      { name: 'Ben', fragment: 's2.AbC-_x.1f', claimed: 12.5 },
      { name: '3', fragment: 's2.AbC-_x.1f', claimed: null },
      { name: 'Cem', fragment: null, claimed: null },
    ]);
  });
});

describe('the ranking', () => {
  const entry = (name: string, claimed: number | null = null): Entry => ({
    name,
    fragment: 's',
    claimed,
  });
  const judged = (name: string, score: number | null, claimed: number | null = null): Judged => ({
    entry: entry(name, claimed),
    score,
    fault: score === null ? 'notBuildable' : null,
    detail: '',
  });

  it('has the least score first, equal ones in one place, those without a score last', () => {
    const rows = ranked([judged('a', null), judged('b', 8), judged('c', 6), judged('d', 8)]);
    expect(rows.map(({ entry: { name }, place }) => `${name} ${place}`)).toEqual([
      'c 1',
      'b 2',
      'd 2',
      'a null',
    ]);
  });

  it('shows a wrong claim, also of what has no score', () => {
    const rows = ranked([judged('a', 8, 8), judged('b', 9, 7), judged('c', null, 5)]);
    expect(rows.map(({ wrongClaim }) => wrongClaim)).toEqual([false, true, true]);
  });
});

describe('the same drawing', () => {
  it('may be split, ordered and turned otherwise', () => {
    const whole = gridSketch(1);
    const lines = whole.lines.flatMap(({ from, to }) => {
      const [x = 0, y = 0, z = 0] = from.map((a, i) => (a + (to[i] ?? 0)) / 2);
      return [
        { from: to, to: [x, y, z] as const },
        { from, to: [x, y, z] as const },
      ];
    });
    expect(isSameDrawing(whole, { ...whole, lines: lines.reverse() })).toBe(true);
  });

  it('is none with a line more, less or elsewhere', () => {
    const cube = cubeSketch(4);
    expect(isSameDrawing(cube, { ...cube, lines: cube.lines.slice(1) })).toBe(false);
    expect(isSameDrawing({ ...cube, lines: cube.lines.slice(1) }, cube)).toBe(false);
    expect(isSameDrawing(cube, cubeSketch(5))).toBe(false);
  });
});

describe('the judge', () => {
  const drawing = gridSketch(1);
  const beams: Contest = { kind: 'beams', drawing };

  async function entryOf(sketch: SketchDocument): Promise<Entry> {
    const fragment = await encodeShare({ sketch, preset: 'simple', seed: 3 });
    return { name: 'x', fragment: fragment.ok ? fragment.value : null, claimed: null };
  }

  function judgeWith(client = silentClient(), signal = new AbortController().signal) {
    return { client, catalogue, signal };
  }

  async function settle(client: ReturnType<typeof silentClient>, beamsFound: number) {
    await expect.poll(() => client.solves.length).toBe(1);
    client.solves[0]?.settle({
      outcome: 'solved',
      modelJson: '{"name":"","parts":[]}',
      reportJson: JSON.stringify({ beams: beamsFound, axles: 1 }),
      layoutJson: '{}',
      seconds: { total: 1, byPhase: {} },
    });
  }

  it('makes the model with the settings of the link and counts its beams', async () => {
    const client = silentClient();
    const verdict = judgeEntry(await entryOf(drawing), beams, judgeWith(client));
    await settle(client, 4);
    expect(await verdict).toMatchObject({ score: 5, fault: null });
    expect(client.solves[0]?.settings).toMatchObject({ seed: 3, preset: 'simple' });
  });

  it('gives no score to what cannot be built', async () => {
    const client = silentClient();
    client.checkReply = { outcome: 'ok', text: '{"buildable":false,"items":[],"problems":[]}' };
    const verdict = judgeEntry(await entryOf(drawing), beams, judgeWith(client));
    await settle(client, 4);
    expect(await verdict).toMatchObject({ score: null, fault: 'notBuildable' });
  });

  it('tells another drawing and a broken link without a search', async () => {
    const judge = judgeWith();
    expect(await judgeEntry(await entryOf(cubeSketch(4)), beams, judge)).toMatchObject({
      fault: 'otherDrawing',
    });
    const whole = await entryOf(drawing);
    const broken = { ...whole, fragment: `${whole.fragment?.slice(0, -1)}` };
    expect(await judgeEntry(broken, beams, judge)).toMatchObject({ fault: 'broken' });
    const none = { ...whole, fragment: null };
    expect(await judgeEntry(none, beams, judge)).toMatchObject({ fault: 'broken' });
  });

  it('asks the stress model for each place of the truck, and names where a bridge folds', async () => {
    const client = silentClient();
    const rules = {
      deck: { from: [0, 0, 0], to: [4, 0, 0] },
      truck: { axles: [0], forces: [5], track: 0 },
      step: 2,
      safety: 1,
      prices: {},
      pricePerGram: 1,
    } as const;
    const bridge: Contest = { kind: 'bridge', rules };
    const verdict = judgeEntry(await entryOf(drawing), bridge, judgeWith(client));
    await settle(client, 4);
    expect(await verdict).toMatchObject({ score: null, fault: 'folds', detail: '0' });
  });

  it('says what went wrong, and stops when it is told to', async () => {
    const client = silentClient();
    const verdict = judgeEntry(await entryOf(drawing), beams, judgeWith(client));
    await expect.poll(() => client.solves.length).toBe(1);
    client.solves[0]?.fail(new Error('no memory'));
    expect(await verdict).toMatchObject({ fault: 'failed', detail: 'no memory' });
    const stop = new AbortController();
    stop.abort(new Error('stopped'));
    const stopped = judgeEntry(
      await entryOf(drawing),
      beams,
      judgeWith(silentClient(), stop.signal),
    );
    await expect(stopped).rejects.toThrow('stopped');
  });
});
