import { newId } from '../base/new-id.ts';
import { SketchLibrary } from '../state/library.ts';
import { keptPreferences, PREFERENCES_KEY } from '../state/preferences.ts';
import { memoryStore, openBrowserStore, type RecordStore } from '../state/storage.ts';
import { openTabNews } from '../state/tab-news.ts';
import { text } from '../ui/text.ts';
import type { PageController } from './page-controller.ts';
import { isForeignFrame, textStorage } from './text-storage.ts';

// What this browser keeps between visits, and where it may not.

/** @param onMissing told why nothing is kept, where that is so. */
export async function openStore(onMissing: (message: string) => void): Promise<RecordStore> {
  if (isForeignFrame()) {
    onMissing(text.files.storeFrame);
    return memoryStore();
  }
  try {
    return await openBrowserStore('liftarm');
  } catch {
    onMissing(text.files.storeNone);
    return memoryStore();
  }
}

/** @param onRefused told once when the browser does not keep them. */
export function keepPreferences(onRefused: () => void) {
  return keptPreferences({
    storage: textStorage('localStorage'),
    onOtherTab: (take) =>
      window.addEventListener('storage', ({ key, newValue }) => {
        if (key === PREFERENCES_KEY) {
          take(newValue);
        }
      }),
    onRefused,
  });
}

/** The sketches that are kept, and the other tabs that keep it too. */
export function openLibrary(controller: PageController, store: RecordStore): SketchLibrary {
  const { shelf } = controller;
  return new SketchLibrary({
    store,
    tab: textStorage('sessionStorage'),
    news: openTabNews('liftarm'),
    newId,
    onFailure: () => controller.warn(text.files.storeFull),
    onEvent: (event) => shelf.noteEvent(event),
    onState: () => shelf.noteState(),
  });
}
