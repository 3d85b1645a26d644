// Which steps of a model are done: kept by the browser, so that a reload loses nothing.

import { PARTS_A_STEP } from '../../model/step-size.ts';

const PREFIX = 'liftarm/ticks/';
const MAX_KEPT = 20;

/** A short key of a model's text (FNV-1a, 32 bits) and of how many parts a step asks for. */
export function modelKey(json: string, partsAStep: number): string {
  let hash = 0x811c9dc5;
  for (let i = 0; i < json.length; i++) {
    hash = Math.imul(hash ^ json.charCodeAt(i), 0x01000193);
  }
  const key = (hash >>> 0).toString(36);
  return partsAStep === PARTS_A_STEP.usual ? key : `${key}/${partsAStep}`;
}

export function readTicks(key: string, storage: Storage | null): Set<number> {
  try {
    const value: unknown = JSON.parse(storage?.getItem(PREFIX + key) ?? '[]');
    return new Set(Array.isArray(value) ? value.filter((n) => Number.isInteger(n) && n >= 0) : []);
  } catch {
    return new Set();
  }
}

export function writeTicks(key: string, ticks: ReadonlySet<number>, storage: Storage | null): void {
  try {
    const names = Object.keys(storage ?? {}).filter((name) => name.startsWith(PREFIX));
    for (const name of names.slice(0, Math.max(0, names.length - MAX_KEPT))) {
      storage?.removeItem(name);
    }
    storage?.setItem(PREFIX + key, JSON.stringify([...ticks]));
  } catch {
    // A full or forbidden storage loses the ticks, nothing else.
  }
}
