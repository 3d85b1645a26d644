import { describe, expect, it } from 'vitest';
import { SolveRun } from '../../../web/src/app/solve-run.ts';
import type { SketchDocument } from '../../../web/src/model/sketch.ts';
import type { MadeModel } from '../../../web/src/solver/made-model.ts';
import type { SolveProgress } from '../../../web/src/solver/protocol.ts';
import { text } from '../../../web/src/ui/text.ts';
import { silentClient } from '../helpers/silent-client.ts';

const SKETCH: SketchDocument = {
  format: 'technic-sketch',
  version: 1,
  lines: [{ from: [0, 0, 0], to: [4, 0, 0] }],
};
const MODEL = JSON.stringify({
  format: 'liftarm-model',
  version: 1,
  name: '',
  parts: [{ part: '32316', position: [2, 0, 0], rotation: [1, 0, 0, 0, 1, 0, 0, 0, 1] }],
});
const PROGRESS: SolveProgress = {
  done: false,
  phase: 'stageTwo',
  iterations: 10,
  fraction: 0.5,
  objective: 2,
  temperature: 1,
  beams: 1,
  gaps: 0,
  collisions: 0,
  failedConnections: 0,
  terms: {},
  improvements: 1,
};
const SECONDS = { total: 0.5, byPhase: {} };

function begin() {
  const client = silentClient();
  const run = new SolveRun(client);
  return { client, run };
}

const MADE: MadeModel = {
  sketch: SKETCH,
  settings: { seed: 1 },
  modelJson: MODEL,
  reportJson: '{"buildable":true,"beams":1}',
  checkJson: '{"buildable":true,"items":[],"problems":[]}',
  layoutJson: '{"runs":[7]}',
};

function solvedAs(modelJson: string) {
  const reportJson = '{"buildable":true,"beams":2}';
  return {
    outcome: 'solved',
    modelJson,
    reportJson,
    layoutJson: '{"runs":[8]}',
    seconds: SECONDS,
  } as const;
}

describe('a model that came with the page', () => {
  it('is shown as if it had been searched for', () => {
    const { client, run } = begin();
    run.showMade(MADE);
    expect(client.solves).toEqual([]);
    expect(run.state.value.phase).toBe('solved');
    expect(run.shown.value).toMatchObject({ source: 'search', json: MODEL, sketch: SKETCH });
    expect(run.shown.value?.check?.buildable).toBe(true);
    void run.regrow(SKETCH, { seed: 1 });
    expect(client.solves[0]?.settings).toEqual({ seed: 1, earlier: { runs: [7] } });
  });

  it('gets the time of the search that confirms it, and stays the model that it was', async () => {
    const { client, run } = begin();
    run.showMade(MADE);
    const shown = run.shown.value?.model;
    const confirmed = run.confirm(MADE);
    client.solves[0]?.watch.onProgress?.(PROGRESS, null);
    expect(run.state.value.phase).toBe('solved');
    client.solves[0]?.settle(solvedAs(MODEL));
    await confirmed;
    expect(run.shown.value?.model).toBe(shown);
    expect(run.shown.value?.report?.seconds?.total).toBe(SECONDS.total);
    expect(run.state.value).toMatchObject({ phase: 'solved', progress: { beams: 1 } });
  });

  it('is replaced by what the search finds, should that be another', async () => {
    const { client, run } = begin();
    run.showMade(MADE);
    const confirmed = run.confirm(MADE);
    const other = MODEL.replace('"name":""', '"name":"other"');
    client.solves[0]?.settle(solvedAs(other));
    await confirmed;
    expect(run.shown.value).toMatchObject({ json: other, report: { beams: 2 } });
  });

  it('is not confirmed once something else is searched for', async () => {
    const { client, run } = begin();
    run.showMade(MADE);
    const confirmed = run.confirm(MADE);
    const done = run.start(SKETCH, { seed: 2 });
    await confirmed;
    expect(run.state.value.phase).toBe('solving');
    client.solves[1]?.settle(solvedAs(MODEL));
    await done;
    expect(run.shown.value?.report?.beams).toBe(2);
    await run.confirm({ ...MADE, modelJson: 'another' });
    expect(client.solves).toHaveLength(2);
  });

  it('stays when the search for it fails', async () => {
    const { client, run } = begin();
    run.showMade(MADE);
    const confirmed = run.confirm(MADE);
    client.solves[0]?.fail(new Error('out of memory'));
    await confirmed;
    expect(run.state.value.phase).toBe('solved');
    expect(run.shown.value?.json).toBe(MODEL);
  });
});

describe('solve run', () => {
  it('shows the model as it improves, then the checked one', async () => {
    const { client, run } = begin();
    const done = run.start(SKETCH, {});
    client.solves[0]?.watch.onProgress?.(PROGRESS, MODEL);
    expect(run.shown.value?.report).toBeNull();
    client.solves[0]?.settle({
      outcome: 'solved',
      modelJson: MODEL,
      reportJson: '{"buildable":true,"beams":1}',
      layoutJson: '{"runs":[]}',
      seconds: SECONDS,
    });
    await done;
    expect(run.state.value.phase).toBe('solved');
    expect(run.shown.value).toMatchObject({ report: { beams: 1 }, check: { buildable: true } });
  });

  it('is under way until its model is checked', async () => {
    const { client, run } = begin();
    let say: (reply: typeof client.checkReply) => void = () => undefined;
    client.check = () =>
      new Promise((answer) => {
        say = answer;
      });
    const done = run.start(SKETCH, {});
    client.solves[0]?.settle({
      outcome: 'solved',
      modelJson: MODEL,
      reportJson: '{"buildable":true}',
      layoutJson: '{"runs":[]}',
      seconds: SECONDS,
    });
    await new Promise((later) => setTimeout(later, 0));
    expect(run.wishUnderWay?.sketch).toBe(SKETCH);
    say(client.checkReply);
    await done;
    expect(run.wishUnderWay).toBeNull();
  });

  it('goes on from the last layout when it is asked to, and from nothing after another sketch', async () => {
    const { client, run } = begin();
    const end = async (done: Promise<void>, layoutJson: string) => {
      client.solves.at(-1)?.settle({
        outcome: 'solved',
        modelJson: MODEL,
        reportJson: '{"buildable":true}',
        layoutJson,
        seconds: SECONDS,
      });
      await done;
    };
    const asked = () => client.solves.at(-1)?.settings;
    await end(run.regrow(SKETCH, { seed: 3 }), '{"runs":[1]}');
    expect(asked()).toEqual({ seed: 3 });
    await end(run.regrow(SKETCH, { seed: 3 }), '{"runs":[2]}');
    expect(asked()).toEqual({ seed: 3, earlier: { runs: [1] } });
    await end(run.start(SKETCH, { seed: 3 }), '{"runs":[3]}');
    expect(asked()).toEqual({ seed: 3 });
    run.clear();
    void run.regrow(SKETCH, { seed: 3 });
    expect(asked()).toEqual({ seed: 3 });
  });

  it('is cancelled while what it found is checked, and says that it was not', async () => {
    const { client, run } = begin();
    client.holdChecks = true;
    const done = run.start(SKETCH, {});
    client.solves[0]?.settle(solvedAs(MODEL));
    await Promise.resolve();
    expect(run.state.value.phase).toBe('solving');
    run.cancel();
    await done;
    expect(run.state.value).toMatchObject({
      phase: 'cancelled',
      message: text.solve.cancelledUnchecked,
    });
    expect(run.shown.value).toMatchObject({ json: MODEL, report: null, check: null });
  });

  it('gives up the check of the one before', async () => {
    const { client, run } = begin();
    client.holdChecks = true;
    const first = run.start(SKETCH, {});
    client.solves[0]?.settle(solvedAs(MODEL));
    await Promise.resolve();
    const second = run.start(SKETCH, { seed: 2 });
    await first;
    expect(run.state.value.phase).toBe('solving');
    expect(run.shown.value).toBeNull();
    client.holdChecks = false;
    client.solves[1]?.settle(solvedAs(MODEL));
    await second;
    expect(run.state.value.phase).toBe('solved');
  });

  it('keeps the last model when it is cancelled', async () => {
    const { client, run } = begin();
    const done = run.start(SKETCH, {});
    client.solves[0]?.watch.onProgress?.(PROGRESS, MODEL);
    run.cancel();
    await done;
    expect(run.state.value.phase).toBe('cancelled');
    expect(run.shown.value?.report).toEqual({ buildable: true });
  });

  it('says what the core refused', async () => {
    const { client, run } = begin();
    const done = run.start(SKETCH, {});
    client.solves[0]?.settle({ outcome: 'refused', message: 'lines[0]: no' });
    await done;
    expect(run.state.value).toMatchObject({ phase: 'refused', message: 'lines[0]: no' });
  });

  it('survives a crash of the worker', async () => {
    const { client, run } = begin();
    const done = run.start(SKETCH, {});
    client.solves[0]?.fail(new Error('out of memory'));
    await done;
    expect(run.state.value.phase).toBe('failed');
  });

  it('hears nothing more from a search that was replaced', async () => {
    const { client, run } = begin();
    const first = run.start(SKETCH, {});
    const second = run.start(SKETCH, {});
    client.solves[0]?.watch.onProgress?.(PROGRESS, MODEL);
    expect(run.shown.value).toBeNull();
    await first;
    expect(run.state.value.phase).toBe('solving');
    run.cancel();
    await second;
    expect(run.state.value.phase).toBe('cancelled');
  });

  it('takes the sketch from a model file', async () => {
    const { run } = begin();
    const sketches: SketchDocument[] = [];
    const file = JSON.stringify({ ...JSON.parse(MODEL), sketch: SKETCH });
    expect(
      await run.showFile(file, {
        model: () => undefined,
        sketch: (sketch) => sketches.push(sketch),
      }),
    ).toBeNull();
    expect(sketches).toEqual([SKETCH]);
  });

  it('refuses a model whose parts cannot be placed', async () => {
    const { run } = begin();
    const file = MODEL.replace('[2,0,0]', '[2,0]');
    expect(await run.showFile(file, { model: () => undefined, sketch: () => undefined })).toContain(
      'parts[0]',
    );
    expect(run.shown.value).toBeNull();
  });
});
