import type { Page } from './page.ts';

/** What the model on screen is called: by its file where it came without a drawing, else by the drawing; maybe ''. */
export function modelTitle({ shown, store }: Pick<Page, 'shown' | 'store'>): string {
  const model = shown.value;
  const ofFile = model?.source === 'file' && !model.sketch;
  return (ofFile ? model.model.name : store.sketch.value.name) ?? '';
}
