import { useEffect, useState } from 'preact/hooks';
import { type Brace, groupColours, type MotionAnswer } from '../../model/motion.ts';
import { addLines } from '../../state/edits.ts';
import { usePage } from '../page-context.ts';
import { formatNumber, formatPoint } from '../text/language.ts';
import type { CheckProps, CheckStatus, CheckView } from './check-registry.ts';
import { MotionPlayer, useSceneDisplay } from './motion-player.tsx';
import { answerOf, motionStatus } from './motion-status.ts';
import { type MotionStudy, motionStudyOf } from './motion-study.ts';
import { motionWords as words } from './motion-words.ts';
import './motion.css';

/** What moves that should not: free motions, rigid groups, and lines that would stiffen the model. */
export const FREEDOMS_CHECK: CheckView = {
  id: 'freedoms',
  title: words.freedoms,
  status: motionStatus(statusOf),
  component: FreedomsCheck,
};

export function statusOf({ freedoms }: MotionAnswer): CheckStatus {
  const { beyondJoints, heldBeyondJoints } = freedoms;
  return {
    state: heldBeyondJoints === 0 ? 'ok' : 'bad',
    number:
      beyondJoints === 0
        ? words.rigid
        : words.freeOnes(String(heldBeyondJoints), String(beyondJoints)),
  };
}

function FreedomsCheck({ shown }: CheckProps) {
  const answer = answerOf(shown);
  const study = motionStudyOf(shown);
  const [colours, setColours] = useState(true);
  const [open, setOpen] = useState<number | null>(null);
  if (!answer) {
    return null;
  }
  const { beyondJoints, heldBeyondJoints, spinning } = answer.freedoms;
  const about =
    beyondJoints === 0
      ? words.aboutRigid
      : heldBeyondJoints === 0
        ? words.aboutHeld
        : words.aboutLoose;
  return (
    <div class="motion-check">
      <p class="quiet">{about}</p>
      <label>
        <input
          type="checkbox"
          checked={colours && open === null}
          onChange={(event) => {
            setOpen(null);
            setColours(event.currentTarget.checked);
          }}
        />{' '}
        {words.groups}
      </label>
      {colours && open === null ? <GroupColours groups={answer.groups} /> : null}
      <Motions answer={answer} study={study} open={open} onOpen={setOpen} />
      {spinning > 0 ? <p class="quiet">{words.spinning(String(spinning))}</p> : null}
      <Braces braces={answer.braces} />
    </div>
  );
}

/** Paints while it is there. */
function GroupColours({ groups }: { readonly groups: readonly number[] }) {
  const page = usePage();
  useEffect(() => {
    page.display.value = { colours: groupColours(groups) };
    return () => {
      page.display.value = null;
    };
  }, [page, groups]);
  return null;
}

function Motions(props: {
  readonly answer: MotionAnswer;
  readonly study: MotionStudy;
  readonly open: number | null;
  readonly onOpen: (motion: number | null) => void;
}) {
  const { answer, study, open, onOpen } = props;
  const onDisplay = useSceneDisplay();
  const loose = answer.motions.flatMap((motion, index) =>
    motion.joint === null ? [{ index, parts: motion.parts.length }] : [],
  );
  return (
    <ul class="motion-list">
      {loose.map(({ index, parts }, i) => (
        <li key={index}>
          <button
            type="button"
            class="button"
            aria-pressed={open === index}
            onClick={() => onOpen(open === index ? null : index)}
          >
            {words.motion(String(i + 1))}
          </button>{' '}
          <span class="quiet">{words.motionParts(String(parts))}</span>
          {open === index ? (
            <MotionPlayer study={study} mover={{ of: 'motion', index }} onDisplay={onDisplay} />
          ) : null}
        </li>
      ))}
    </ul>
  );
}

function Braces({ braces }: { readonly braces: readonly Brace[] }) {
  const page = usePage();
  if (braces.length === 0) {
    return null;
  }
  const add = ({ from, to }: Brace) => {
    page.store.commit(words.braceStep, addLines(page.store.sketch.value, [{ from, to }]));
    page.announce(words.braceAdded);
  };
  return (
    <>
      <h4>{words.braces}</h4>
      <ul class="motion-list">
        {braces.map((brace) => (
          <li key={JSON.stringify([brace.from, brace.to])}>
            <button
              type="button"
              class="button"
              disabled={page.stale.value}
              onClick={() => add(brace)}
            >
              {words.brace(formatNumber(lengthOf(brace)))}
            </button>{' '}
            <span class="quiet">
              {formatPoint(brace.from)} – {formatPoint(brace.to)}
            </span>
          </li>
        ))}
      </ul>
    </>
  );
}

function lengthOf({ from, to }: Brace): number {
  return Math.hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
}
