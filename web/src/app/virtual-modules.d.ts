declare module 'virtual:first-model' {
  import type { MadeModel } from './made-model.ts';

  export const firstModel: MadeModel;
}
