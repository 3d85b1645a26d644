import { useCallback, useEffect, useState } from 'preact/hooks';
import { type JointRange, type MotionPath, posesAt } from '../../model/motion.ts';
import type { PartDisplay } from '../../view/view-types.ts';
import { Icon } from '../icon.tsx';
import { usePage } from '../page-context.ts';
import { formatNumber } from '../text/language.ts';
import { inWords } from '../text/sentences.ts';
import type { MotionStudy, Mover } from './motion-study.ts';
import { motionWords as words } from './motion-words.ts';

const DEGREES_PER_SECOND = 45;
/** A stop is reached within this, degrees. */
const AT_STOP = 0.3;

/** Moves the parts on screen along a motion: a slider, and a button that goes there and back. */
export function MotionPlayer(props: {
  readonly study: MotionStudy;
  readonly mover: Mover;
  readonly range?: JointRange;
  /** Draws parts as they are moved; null when the motion closes. Must stay the same function. */
  readonly onDisplay: (display: PartDisplay | null) => void;
}) {
  const { study, mover, range, onDisplay } = props;
  const { path, error } = usePath(study, mover);
  const [degrees, setDegrees] = useState(0);
  const [playing, setPlaying] = useState(false);
  usePosed(path, degrees, range, onDisplay);
  usePlaying(path, playing, setDegrees);
  if (error) {
    return (
      <p role="alert">
        {words.failed} {inWords(error)}
      </p>
    );
  }
  if (!path?.turns) {
    return path ? <p class="quiet">{inWords(path.message)}</p> : null;
  }
  const least = path.angles[0] ?? 0;
  const most = path.angles.at(-1) ?? 0;
  return (
    <div class="motion-player">
      <button
        type="button"
        class="button"
        aria-pressed={playing}
        onClick={() => setPlaying(!playing)}
      >
        <Icon name={playing ? 'stop' : 'play'} />
        <span>{playing ? words.pause : words.play}</span>
      </button>
      <label>
        <span class="visually-hidden">{words.angle}</span>
        <input
          type="range"
          min={least}
          max={most}
          step="0.5"
          value={degrees}
          onInput={(event) => {
            setPlaying(false);
            setDegrees(Number(event.currentTarget.value));
          }}
        />
        <output>{formatNumber(degrees)}°</output>
      </label>
      {stopAt(range, degrees).length > 0 ? <p class="quiet">{words.meets}</p> : null}
    </div>
  );
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

function usePath(study: MotionStudy, mover: Mover) {
  const [found, setFound] = useState<{ path: MotionPath | null; error: string }>({
    path: null,
    error: '',
  });
  const { of, index } = mover;
  useEffect(() => {
    let wanted = true;
    study.path({ of, index }).then(
      (path) => wanted && setFound({ path, error: '' }),
      (error: unknown) =>
        wanted &&
        setFound({ path: null, error: error instanceof Error ? error.message : String(error) }),
    );
    return () => {
      wanted = false;
    };
  }, [study, of, index]);
  return found;
}

/** The parts that stop a joint where it stands now. */
function stopAt(range: JointRange | undefined, degrees: number): readonly number[] {
  if (!range) {
    return [];
  }
  if (degrees <= range.from + AT_STOP) {
    return range.stoppedBy.from;
  }
  return degrees >= range.to - AT_STOP ? range.stoppedBy.to : [];
}

function usePosed(
  path: MotionPath | null,
  degrees: number,
  range: JointRange | undefined,
  onDisplay: (display: PartDisplay | null) => void,
): void {
  useEffect(() => {
    if (path?.turns) {
      onDisplay({
        poses: posesAt(path, degrees),
        highlighted: new Set(stopAt(range, degrees)),
      });
    }
  }, [onDisplay, path, degrees, range]);
  useEffect(() => () => onDisplay(null), [onDisplay]);
}

/** There and back between the ends, slower than the eye. */
function usePlaying(
  path: MotionPath | null,
  playing: boolean,
  setDegrees: (change: (before: number) => number) => void,
): void {
  useEffect(() => {
    if (!playing || !path) {
      return;
    }
    const least = path.angles[0] ?? 0;
    const most = path.angles.at(-1) ?? 0;
    let direction = 1;
    let before = performance.now();
    let frame = requestAnimationFrame(function next(now) {
      const step = (Math.min(100, now - before) / 1000) * DEGREES_PER_SECOND;
      before = now;
      setDegrees((degrees) => {
        const wanted = degrees + direction * step;
        if (wanted >= most || wanted <= least) {
          direction = wanted >= most ? -1 : 1;
        }
        return Math.min(most, Math.max(least, wanted));
      });
      frame = requestAnimationFrame(next);
    });
    return () => cancelAnimationFrame(frame);
  }, [path, playing, setDegrees]);
}
