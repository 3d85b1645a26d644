import { useEffect, useState } from 'preact/hooks';
import {
  type FitHold,
  fullExaggeration,
  STRESS_RAMP,
  type StressAnswer,
  type StressResult,
} from '../../model/stress.ts';
import { Segmented } from '../controls.tsx';
import type { Page, ShownModel } from '../page.ts';
import { usePage } from '../page-context.ts';
import { formatNumber } from '../text/language.ts';
import type { CheckProps, CheckStatus, CheckView } from './check-registry.ts';
import { NumberList } from './number-list.tsx';
import { LoadForm } from './stress-load-form.tsx';
import { useStressScene } from './stress-scene.ts';
import { type StressProgress, studyOf } from './stress-study.ts';
import { stressWords as words } from './stress-words.ts';
import './stress.css';
import { inWords } from '../text/sentences.ts';

/** Below this a part breaks; above the other it is far from breaking. */
const ENOUGH = 1.5;
const MOST_SHOWN = 1000;

const FRICTIONS: readonly FitHold[] = ['held', 'free', 'locked'];

/** How far the model is from breaking, part by part, under its weight and what is put on it. */
export const STRESS_CHECK: CheckView = {
  id: 'stress',
  title: words.title,
  status: (_page: Page, shown: ShownModel) => {
    const study = studyOf(shown);
    if (shown.report === null && shown.check === null) {
      return { state: 'busy', number: '' };
    }
    study.start();
    return statusOf(study.progress.value);
  },
  component: StressCheck,
};

export function statusOf(progress: StressProgress): CheckStatus {
  if (progress.state === 'waiting') {
    return { state: 'busy', number: '' };
  }
  if (progress.state === 'failed' || !progress.answer.ok) {
    return { state: 'none', number: '' };
  }
  const { safety } = progress.answer;
  return { state: safety >= ENOUGH ? 'ok' : 'bad', number: `× ${safetyText(safety)}` };
}

function safetyText(safety: number): string {
  return safety > MOST_SHOWN ? `> ${formatNumber(MOST_SHOWN)}` : formatNumber(safety, 1);
}

function StressCheck({ shown }: CheckProps) {
  const page = usePage();
  const study = studyOf(shown);
  const [bend, setBend] = useState(0);
  useEffect(() => study.start(), [study]);
  const progress = study.progress.value;
  const { friction, loads } = study.options.value;
  const answer = progress.state === 'done' ? progress.answer : null;
  useStressScene(page, { answer, loads, bend });
  return (
    <div class="stress">
      <p class="quiet">{words.about}</p>
      <Segmented
        name="stress-friction"
        legend={words.friction}
        choices={FRICTIONS.map((value) => ({ value, label: words[value] }))}
        value={friction}
        onChange={(value) => study.setFriction(value)}
      />
      {progress.state === 'failed' ? (
        <p role="alert">
          {words.failed} {inWords(progress.message)}
        </p>
      ) : null}
      {answer ? <Answer answer={answer} bend={bend} onBend={setBend} /> : null}
      <LoadForm study={study} />
    </div>
  );
}

function Answer(props: {
  readonly answer: StressAnswer;
  readonly bend: number;
  readonly onBend: (bend: number) => void;
}) {
  const { answer, bend, onBend } = props;
  if (!answer.ok) {
    return (
      <p role="status">
        <strong>{words.moves}</strong> <span class="quiet">{inWords(answer.message)}</span>
      </p>
    );
  }
  const times = bend * fullExaggeration(answer);
  return (
    <>
      <Numbers result={answer} />
      <Legend result={answer} />
      <label class="stress-bend">
        <span>{words.shape}</span>
        <input
          type="range"
          min="0"
          max="1"
          step="0.01"
          value={bend}
          onInput={(event) => onBend(Number(event.currentTarget.value))}
        />
        <span class="quiet">
          {bend > 0 ? words.times(formatNumber(times, times < 10 ? 1 : 0)) : words.drawn}
        </span>
      </label>
      {answer.message ? <p class="quiet">{inWords(answer.message)}</p> : null}
    </>
  );
}

function Numbers({ result }: { readonly result: StressResult }) {
  const shear = Math.max(0, ...result.pins.map((pin) => pin.shear));
  const rows: readonly (readonly [string, string])[] = [
    [words.stress, `${formatNumber(result.maxStress, 3)} MPa`],
    [words.safety, safetyText(result.safety)],
    [words.sag, `${formatNumber(result.maxDisplacement, 3)} mm`],
    [words.pinShear, `${formatNumber(shear, 3)} MPa`],
    [words.weight, `${formatNumber(result.weight, 2)} N`],
  ];
  return <NumberList rows={rows} />;
}

function Legend({ result }: { readonly result: StressResult }) {
  const stops = STRESS_RAMP.map((hex) => `#${hex.toString(16).padStart(6, '0')}`).join(', ');
  return (
    <div class="stress-legend">
      <div
        class="stress-ramp"
        role="img"
        aria-label={words.legend}
        style={{ background: `linear-gradient(to right, ${stops})` }}
      />
      <span>0</span>
      <span>{formatNumber(result.maxStress, 3)} MPa</span>
    </div>
  );
}
