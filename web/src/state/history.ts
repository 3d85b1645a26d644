import type { SketchDelta } from './delta.ts';

/** One step of the history: what changed, and a word for it. */
export interface HistoryEntry {
  readonly label: string;
  readonly delta: SketchDelta;
}

/** What can be undone (last is newest) and what can be redone (last is next). Without limit. */
export interface History {
  readonly past: readonly HistoryEntry[];
  readonly future: readonly HistoryEntry[];
}

export const EMPTY_HISTORY: History = { past: [], future: [] };

/** A new step; what could be redone is gone. */
export function pushEntry(history: History, entry: HistoryEntry): History {
  return { past: [...history.past, entry], future: [] };
}

/** The history after one undo, and the entry to be undone; null at the beginning. */
export function stepBack(history: History): { history: History; entry: HistoryEntry } | null {
  const entry = history.past.at(-1);
  if (!entry) {
    return null;
  }
  return {
    entry,
    history: { past: history.past.slice(0, -1), future: [...history.future, entry] },
  };
}

/** The history after one redo, and the entry to be done again; null at the end. */
export function stepForward(history: History): { history: History; entry: HistoryEntry } | null {
  const entry = history.future.at(-1);
  if (!entry) {
    return null;
  }
  return {
    entry,
    history: { past: [...history.past, entry], future: history.future.slice(0, -1) },
  };
}
