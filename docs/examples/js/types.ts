// What a program in TypeScript sees of the package; `npm run example:js` has the compiler read it.
import { createLiftarm, InputError, type Liftarm } from 'liftarm';

export async function beamsOf(liftarm: Liftarm, sketchText: string): Promise<number | string> {
  try {
    const { report } = await liftarm.solve(sketchText, { seed: 3, preset: 'simple' });
    return report.beams ?? 0;
  } catch (error) {
    if (error instanceof InputError) {
      return error.message;
    }
    throw error;
  }
}

export const start: () => Liftarm = createLiftarm;
