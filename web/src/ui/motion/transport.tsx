import { effect } from '@preact/signals';
import { useEffect } from 'preact/hooks';
import { spanOf } from '../../model/motion-span.ts';
import type { PartDisplay } from '../../view/view-types.ts';
import { motionWords as words } from '../checks/motion-words.ts';
import { Icon } from '../icon.tsx';
import { formatNumber } from '../text/language.ts';
import { inWords } from '../text/sentences.ts';
import { type Driver, type MotionBoard, SPEEDS } from './motion-board.ts';

/** Whoever wants little motion sees single poses, so many degrees and so much time apart. */
const CALM = { degrees: 10, ms: 500, perSecond: 45 } as const;
/** A tab that slept does not leap. */
const LONGEST_MS = 100;

/** What plays a motion: play and pause, round or there and back, speed, and a slider for each driver. */
export function Transport(props: {
  readonly board: MotionBoard;
  /** The name of what a driver turns, where there are several. */
  readonly nameOf: (driver: Driver) => string;
  /** Draws parts as they are moved; null when the motion closes. Must stay the same function. */
  readonly onDisplay: (display: PartDisplay | null) => void;
}) {
  const { board, nameOf, onDisplay } = props;
  useDisplay(board, onDisplay);
  usePlaying(board);
  const drivers = board.drivers.value;
  const failure = board.failure.value;
  if (failure) {
    return (
      <p role="alert">
        {words.failed} {inWords(failure)}
      </p>
    );
  }
  if (drivers.length === 0) {
    return board.message.value ? <p class="quiet">{inWords(board.message.value)}</p> : null;
  }
  return (
    <div class="motion-player">
      {drivers.map((driver) => (
        <AngleSlider
          key={`${driver.mover.of} ${driver.mover.index}`}
          board={board}
          driver={driver}
          label={drivers.length > 1 ? words.angleOf(nameOf(driver)) : words.angle}
        />
      ))}
      <PlayButtons board={board} />
      {board.stops.value.length > 0 ? <p class="quiet">{words.meets}</p> : null}
    </div>
  );
}

function AngleSlider(props: {
  readonly board: MotionBoard;
  readonly driver: Driver;
  readonly label: string;
}) {
  const { board, driver, label } = props;
  const { from, to } = spanOf(driver.path);
  return (
    <label>
      <span class="visually-hidden">{label}</span>
      <input
        type="range"
        min={from}
        max={to}
        step="0.5"
        value={driver.degrees}
        onInput={(event) => board.put(driver.mover, Number(event.currentTarget.value))}
      />
      <output>{formatNumber(driver.degrees)}°</output>
    </label>
  );
}

function PlayButtons({ board }: { readonly board: MotionBoard }) {
  const playing = board.playing.value;
  const loops = board.mode.value === 'loop';
  return (
    <div class="motion-buttons">
      <button
        type="button"
        class="button"
        aria-pressed={playing}
        onClick={() => {
          board.playing.value = !playing;
        }}
      >
        <Icon name={playing ? 'stop' : 'play'} />
        <span>{playing ? words.pause : words.play}</span>
      </button>
      <button
        type="button"
        class="button"
        aria-pressed={loops}
        title={words.aboutLoop}
        onClick={() => {
          board.mode.value = loops ? 'swing' : 'loop';
        }}
      >
        {words.loop}
      </button>
      <label class="motion-speed">
        <span>{words.speed}</span>
        <select
          value={board.speed.value}
          onChange={(event) => {
            board.speed.value = Number(event.currentTarget.value);
          }}
        >
          {SPEEDS.map((speed) => (
            <option key={speed} value={speed}>
              {speed}×
            </option>
          ))}
        </select>
      </label>
    </div>
  );
}

function useDisplay(board: MotionBoard, onDisplay: (display: PartDisplay | null) => void): void {
  useEffect(() => {
    const stop = effect(() => {
      const highlighted = new Set(board.stops.value);
      const moves = board.drivers.value.length > 0;
      onDisplay(moves ? { poses: board.poses.value, highlighted } : null);
    });
    return () => {
      stop();
      onDisplay(null);
    };
  }, [board, onDisplay]);
}

function usePlaying(board: MotionBoard): void {
  const playing = board.playing.value;
  useEffect(() => {
    if (!playing) {
      return undefined;
    }
    const calm = matchMedia('(prefers-reduced-motion: reduce)').matches;
    let before = performance.now();
    let frame = requestAnimationFrame(function next(now) {
      if (!calm) {
        board.advance(Math.min(LONGEST_MS, now - before) / 1000);
        before = now;
      } else if (now - before >= CALM.ms) {
        board.advance(CALM.degrees / CALM.perSecond / board.speed.value);
        before = now;
      }
      frame = requestAnimationFrame(next);
    });
    return () => cancelAnimationFrame(frame);
  }, [board, playing]);
}
