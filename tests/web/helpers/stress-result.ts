import type { StressResult } from '../../../web/src/model/stress.ts';

/** A beam of two bars and a bush: the beam sags in its middle. */
export function stressResult(): StressResult {
  return {
    ok: true,
    message: '',
    maxStress: 2,
    safety: 20,
    maxDisplacement: 0.5,
    weight: 0.04,
    tilt: 0,
    parts: [
      { stress: 2, safety: 20, utilisation: 0.05 },
      { stress: 0.5, safety: 80, utilisation: 0.0125 },
    ],
    samples: [
      [
        [0, 0, 0, 0, 0, 0, 0],
        [2, 0, 0, 1, 0, 0, -0.3],
        [4, 0, 0, 2, 0, 0, -0.5],
        [4, 0, 0, 2, 0, 0, -0.5],
        [6, 0, 0, 1, 0, 0, -0.3],
        [8, 0, 0, 0, 0, 0, 0],
      ],
      [[4, 0, 1, 0.5, 0, 0, -0.5]],
    ],
    pins: [],
    reactions: [],
  };
}
