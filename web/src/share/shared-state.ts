import type { SketchDocument } from '../model/sketch.ts';
import type { SharedSettings, SharedState } from './codec.ts';

/** What the page's preferences give to a link. */
export interface LinkedPreferences extends SharedSettings {
  readonly preset: string;
  readonly seed: number;
}

/** The settings that a link without any was made with. */
export const USUAL_SETTINGS: SharedSettings = Object.freeze({
  effort: 1,
  off: [],
  owned: {},
  advanced: '',
});

/** What a link to a sketch holds. */
export function sharedState(sketch: SketchDocument, preferences: LinkedPreferences): SharedState {
  const { preset, seed, effort, off, owned, advanced } = preferences;
  return { sketch, preset, seed, settings: { effort, off, owned, advanced } };
}

/** What a link gives to the page's preferences. */
export function linkedPreferences(state: Omit<SharedState, 'sketch'>): LinkedPreferences {
  return { ...USUAL_SETTINGS, ...state.settings, preset: state.preset, seed: state.seed };
}
