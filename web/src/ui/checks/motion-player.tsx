import { useCallback, useEffect, useMemo } from 'preact/hooks';
import type { PartDisplay } from '../../view/view-types.ts';
import { MotionBoard } from '../motion/motion-board.ts';
import { Transport } from '../motion/transport.tsx';
import { usePage } from '../page-context.ts';
import type { MotionStudy, Mover } from './motion-study.ts';

/** Moves the parts on screen along one motion. */
export function MotionPlayer(props: {
  readonly study: MotionStudy;
  readonly mover: Mover;
  /** Draws parts as they are moved; null when the motion closes. Must stay the same function. */
  readonly onDisplay: (display: PartDisplay | null) => void;
}) {
  const { study, mover, onDisplay } = props;
  const { of, index } = mover;
  const board = useMemo(() => new MotionBoard(study), [study]);
  useEffect(() => {
    void board.choose({ of, index }, null);
  }, [board, of, index]);
  return <Transport board={board} nameOf={() => ''} onDisplay={onDisplay} />;
}

/** Draws the model of the drawing as somebody wants it. */
export function useSceneDisplay(): (display: PartDisplay | null) => void {
  const page = usePage();
  return useCallback(
    (display: PartDisplay | null) => {
      page.display.value = display;
    },
    [page],
  );
}
