import { readSketchValue } from './read-sketch.ts';
import { readSearchSettings } from './search-settings.ts';
import {
  type KeptState,
  readHistory,
  readRevision,
  writeFirst,
  writeSteps,
} from './sketch-records.ts';
import type { RecordStore } from './storage.ts';

// A browser may drop a write that is under way when its page goes. What the tab was about to write stands in
// the tab's own storage then, which takes it at once, and is written when the tab comes back.

/** In the storage of this tab. */
const KEY = 'liftarm/last-words';

/** A sketch that may not have been written, and the revision that it was made on; 0 for a new one. */
export interface LastWords {
  readonly id: string;
  readonly seen: number;
  readonly after: KeptState;
}

type TabStorage = Pick<Storage, 'getItem' | 'setItem'> | null;

export function leaveLastWords(tab: TabStorage, words: LastWords | null): void {
  try {
    tab?.setItem(KEY, words === null ? '' : JSON.stringify(words));
  } catch {
    // Full: the write that is under way is all there is.
  }
}

/** Writes what the tab left unwritten, unless somebody wrote that sketch since: then it did arrive, or is older. */
export async function writeLastWords(tab: TabStorage, store: RecordStore): Promise<void> {
  const words = readWords(tab?.getItem(KEY) ?? '');
  leaveLastWords(tab, null);
  if (words === null) {
    return;
  }
  const { id, seen, after } = words;
  await store.change(async (records) => {
    if ((await readRevision(records, id)) !== seen) {
      return;
    }
    const changed = Date.now();
    if (seen === 0) {
      writeFirst(records, { id, changed }, after);
    } else {
      const steps = [{ kind: 'settings', settings: after.settings } as const];
      await writeSteps(records, { id, changed, revision: seen }, { steps, after, anew: true });
    }
  });
}

function readWords(text: string): LastWords | null {
  try {
    const { id, seen, after } = JSON.parse(text);
    const sketch = readSketchValue(after.sketch);
    if (typeof id !== 'string' || !Number.isSafeInteger(seen) || !sketch.ok) {
      return null;
    }
    const settings = after.settings === null ? null : readSearchSettings(after.settings);
    return {
      id,
      seen,
      after: { sketch: sketch.value, history: readHistory(after.history), settings },
    };
  } catch {
    return null;
  }
}
