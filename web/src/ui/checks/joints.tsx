import { useState } from 'preact/hooks';
import type { JointRange, MotionAnswer } from '../../model/motion.ts';
import type { PartDisplay } from '../../view/view-types.ts';
import { formatNumber } from '../text/language.ts';
import type { CheckProps, CheckStatus, CheckView } from './check-registry.ts';
import { MotionPlayer, useSceneDisplay } from './motion-player.tsx';
import { answerOf, motionStatus } from './motion-status.ts';
import { type MotionStudy, motionStudyOf } from './motion-study.ts';
import { motionWords as words } from './motion-words.ts';
import './motion.css';
import { inWords } from '../text/sentences.ts';

/** Each joint of the sketch with its range; one of them can be turned. */
export const JOINTS_CHECK: CheckView = {
  id: 'joint-ranges',
  title: words.joints,
  status: motionStatus(statusOf),
  component: JointsCheck,
};

function statusOf({ joints }: MotionAnswer): CheckStatus {
  if (joints.length === 0) {
    return { state: 'none', number: words.noJoints };
  }
  const turning = joints.filter((joint) => joint.turns).length;
  const [only] = joints;
  return {
    state: turning === joints.length ? 'ok' : 'bad',
    number: joints.length === 1 && only ? rangeText(only) : `${turning} / ${joints.length}`,
  };
}

export function rangeText(range: JointRange): string {
  if (!range.turns) {
    return words.stiff;
  }
  return range.to - range.from >= 359
    ? words.fullTurn
    : words.range(formatNumber(range.from), formatNumber(range.to));
}

function nameOf({ joint, bodies }: JointRange): string {
  const name = words.joint(String(joint + 1));
  return bodies ? words.bodies(name, String(bodies[0] + 1), String(bodies[1] + 1)) : name;
}

function JointsCheck({ shown }: CheckProps) {
  const onDisplay = useSceneDisplay();
  const answer = answerOf(shown);
  if (!answer) {
    return null;
  }
  return <JointList joints={answer.joints} study={motionStudyOf(shown)} onDisplay={onDisplay} />;
}

/** The joints with their ranges; the one that is open can be turned. */
export function JointList(props: {
  readonly joints: readonly JointRange[];
  readonly study: MotionStudy;
  readonly onDisplay: (display: PartDisplay | null) => void;
}) {
  const { joints, study, onDisplay } = props;
  const [open, setOpen] = useState(0);
  if (joints.length === 0) {
    return <p class="quiet">{words.aboutNoJoints}</p>;
  }
  return (
    <ul class="motion-list">
      {joints.map((joint) => (
        <li key={joint.index}>
          <button
            type="button"
            class="button"
            aria-pressed={open === joint.index}
            onClick={() => setOpen(joint.index)}
          >
            {nameOf(joint)}
          </button>{' '}
          <span class="quiet">{rangeText(joint)}</span>
          {joint.turns ? null : <p class="quiet">{inWords(joint.message)}</p>}
          {open === joint.index && joint.turns ? (
            <MotionPlayer
              study={study}
              mover={{ of: 'joint', index: joint.index }}
              range={joint}
              onDisplay={onDisplay}
            />
          ) : null}
        </li>
      ))}
    </ul>
  );
}
