import { useEffect, useMemo } from 'preact/hooks';
import {
  fullExaggeration,
  type PointLoad,
  type StressAnswer,
  stressColours,
} from '../../model/stress.ts';
import { StressLoads } from '../../view/overlays/stress-loads.ts';
import { StressShape } from '../../view/overlays/stress-shape.ts';
import type { PartDisplay, PartLook } from '../../view/view-types.ts';
import type { Page } from '../page.ts';

interface StressPicture {
  readonly answer: StressAnswer | null;
  readonly loads: readonly PointLoad[];
  /** 0 (as built) to 1 (the greatest displacement is a module and a half). */
  readonly bend: number;
}

/** Colours the bricks by their stress, or shows the bent frame within their ghosts. */
export function useStressScene(page: Page, picture: StressPicture): void {
  const { answer, loads, bend } = picture;
  const bent = bend > 0;
  useEffect(() => {
    page.display.value = answer && displayOf(answer, bent);
    return () => {
      page.display.value = null;
    };
  }, [page, answer, bent]);
  const shape = useMemo(() => (answer?.ok ? new StressShape(answer) : null), [answer]);
  useEffect(() => (shape ? page.view()?.addOverlay(shape) : undefined), [page, shape]);
  useEffect(() => {
    if (shape && answer?.ok) {
      shape.setVisible(bend > 0);
      shape.setExaggeration(bend * fullExaggeration(answer));
    }
  }, [shape, answer, bend]);
  const arrows = useMemo(() => new StressLoads(), []);
  useEffect(() => page.view()?.addOverlay(arrows), [page, arrows]);
  useEffect(() => arrows.setLoads(loads), [arrows, loads]);
}

function displayOf(answer: StressAnswer, bent: boolean): PartDisplay {
  if (!answer.ok) {
    return { highlighted: new Set(answer.moving) };
  }
  const colours = stressColours(answer);
  return bent
    ? { colours, looks: new Map(colours.map((_, part): [number, PartLook] => [part, 'ghost'])) }
    : { colours };
}
