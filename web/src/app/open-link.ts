import { decodeShare, type SharedState } from '../share/codec.ts';
import { linkedPreferences } from '../share/shared-state.ts';
import { readSketchValue } from '../state/read-sketch.ts';
import { readSearchSettings, searchSettingsOf, unknownSettings } from '../state/search-settings.ts';
import { fillWords } from '../tools/tool-words.ts';
import { text } from '../ui/text.ts';
import type { PageController } from './page-controller.ts';
import { isOwnAddress, takeFragment } from './page-files.ts';

/**
 * Opens the sketch of the link in the address.
 * @param shows whether there is a sketch on the page, which may be the very one.
 * @returns whether there was one that is not on the page already.
 */
export async function openLink(controller: PageController, shows: boolean): Promise<boolean> {
  const { toaster } = controller;
  const fragment = takeFragment();
  const shared = shows && isOwnAddress() ? null : await decodeShare(fragment);
  if (!shared) {
    return false;
  }
  if (!shared.ok) {
    toaster.error(shared.message);
    return false;
  }
  return openShared(controller, shared.value, shows);
}

/** A sketch that came from a link is checked like one from a file, and its settings like those of storage. */
function openShared(controller: PageController, state: SharedState, shows: boolean): boolean {
  const { toaster } = controller;
  const sketch = readSketchValue(state.sketch);
  if (!sketch.ok) {
    toaster.error(sketch.message);
    return false;
  }
  const asked = linkedPreferences(state);
  const settings = readSearchSettings(asked);
  const { store, preferences } = controller.state;
  const now = { sketch: store.sketch.peek(), settings: searchSettingsOf(preferences.peek()) };
  if (shows && JSON.stringify(now) === JSON.stringify({ sketch: sketch.value, settings })) {
    return false;
  }
  // They are those of this sketch alone: the person's own stay as they are.
  controller.replaceSketch(sketch.value, settings);
  toaster.info(text.files.fromLink);
  const leftOut = unknownSettings({ ...asked });
  if (leftOut.length > 0) {
    toaster.info(fillWords(text.files.linkLeftOut, { list: leftOut.join(', ') }));
  }
  return true;
}
