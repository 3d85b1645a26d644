declare module 'virtual:first-model' {
  import type { Language } from '../state/preferences.ts';
  import type { MadeModel } from './made-model.ts';

  export const firstModels: Readonly<Record<Language, MadeModel>>;
}
