import { signal } from '@preact/signals';
import { describe, expect, it } from 'vitest';
import type { SketchDocument } from '../../../web/src/model/sketch.ts';
import { PREFERENCE_DEFAULTS } from '../../../web/src/state/preferences.ts';
import { SketchStore } from '../../../web/src/state/store.ts';
import { modelComing } from '../../../web/src/ui/model-coming.ts';
import type { ShownModel, SolvePhase } from '../../../web/src/ui/page.ts';

const SKETCH: SketchDocument = {
  format: 'technic-sketch',
  version: 1,
  lines: [{ from: [0, 0, 0], to: [4, 0, 0] }],
};
const SHOWN: ShownModel = {
  source: 'search',
  json: '{}',
  model: { name: '', parts: [] },
  sketch: SKETCH,
  parts: '[]',
  report: {},
  check: null,
};

function coming(
  phase: SolvePhase,
  changed: { shown?: boolean; autoSolve?: boolean; small?: boolean; drawn?: boolean } = {},
): boolean {
  const { shown = false, autoSolve = true, small = true, drawn = true } = changed;
  const store = new SketchStore();
  if (drawn) {
    store.restore({ sketch: SKETCH, history: { past: [], future: [] } });
  }
  return modelComing({
    solve: signal({ phase, progress: null, chart: [], layouts: [], message: '' }),
    shown: signal(shown ? SHOWN : null),
    preferences: signal({ ...PREFERENCE_DEFAULTS, autoSolve }),
    small: signal(small),
    store,
  });
}

describe('a model is coming', () => {
  it('while it is searched for, also in place of another', () => {
    expect(coming('solving')).toBe(true);
    expect(coming('solving', { shown: true, autoSolve: false })).toBe(true);
  });

  it('before the search has begun by itself', () => {
    expect(coming('idle')).toBe(true);
  });

  it('not when nobody has asked for one', () => {
    expect(coming('idle', { autoSolve: false })).toBe(false);
    expect(coming('idle', { small: false })).toBe(false);
    expect(coming('idle', { drawn: false })).toBe(false);
  });

  it('not when it is there, or was not found', () => {
    expect(coming('solved', { shown: true })).toBe(false);
    expect(coming('idle', { shown: true })).toBe(false);
    expect(coming('refused')).toBe(false);
    expect(coming('cancelled')).toBe(false);
  });
});
