declare module 'virtual:first-model' {
  import type { MadeModel } from '../solver/made-model.ts';
  import type { Language } from '../state/preferences.ts';

  export const firstModels: Readonly<Record<Language, MadeModel>>;
}
