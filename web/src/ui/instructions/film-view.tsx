import { useEffect, useRef, useState } from 'preact/hooks';
import { fillWords } from '../../tools/tool-words.ts';
import { Icon } from '../icon.tsx';
import type { Book } from './book.ts';
import { FilmFiles } from './film-files.tsx';
import { FilmStage } from './film-stage.ts';
import { instructionWords as words } from './instruction-words.ts';

const SPEEDS = [0.5, 1, 2, 4] as const;
const SIZE = { width: 960, height: 540 } as const;

/** The model builds itself: play, scrub, speed, and saving as a file. */
export function FilmView({ book }: { readonly book: Book }) {
  const host = useRef<HTMLDivElement>(null);
  const [stage, setStage] = useState<FilmStage | null>(null);
  const [second, setSecond] = useState(0);
  const [playing, setPlaying] = useState(false);
  const [speed, setSpeed] = useState<number>(1);
  const [message, setMessage] = useState('');
  useEffect(() => {
    try {
      const made = new FilmStage(book);
      made.canvas.className = 'film-canvas';
      host.current?.append(made.canvas);
      setStage(made);
      return () => {
        made.canvas.remove();
        made.dispose();
      };
    } catch (error) {
      setMessage(fillWords(words.filmFailed, { message: String(error) }));
      return undefined;
    }
  }, [book]);
  useEffect(() => {
    stage?.draw(second, SIZE.width, SIZE.height);
  }, [stage, second]);
  useEffect(() => {
    if (!playing || !stage) {
      return undefined;
    }
    let last = performance.now();
    let frame = requestAnimationFrame(function next(now) {
      setSecond((value) => {
        const moved = value + ((now - last) / 1000) * speed;
        last = now;
        if (moved >= stage.duration) {
          setPlaying(false);
        }
        return Math.min(stage.duration, moved);
      });
      frame = requestAnimationFrame(next);
    });
    return () => cancelAnimationFrame(frame);
  }, [playing, speed, stage]);
  const duration = stage?.duration ?? 1;
  const toggle = () => {
    if (!playing && second >= duration) {
      setSecond(0);
    }
    setPlaying(!playing);
  };
  return (
    <div class="film">
      <div class="film-host" ref={host} />
      <div class="film-bar">
        <button type="button" class="button primary" onClick={toggle}>
          <Icon name={playing ? 'stop' : 'play'} />
          <span>{playing ? words.pause : words.play}</span>
        </button>
        <input
          type="range"
          aria-label={words.scrub}
          min={0}
          max={duration}
          step={0.01}
          value={second}
          onInput={(event) => {
            setPlaying(false);
            setSecond(Number(event.currentTarget.value));
          }}
        />
        <label>
          {words.speed}{' '}
          <select value={speed} onChange={(event) => setSpeed(Number(event.currentTarget.value))}>
            {SPEEDS.map((value) => (
              <option key={value} value={value}>
                {value}×
              </option>
            ))}
          </select>
        </label>
      </div>
      {stage ? (
        <FilmFiles open={() => stage} speed={speed} title={book.title} pictures={true} />
      ) : null}
      {message ? <p role="alert">{message}</p> : null}
    </div>
  );
}
