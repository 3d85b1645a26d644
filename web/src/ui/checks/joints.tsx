import type { ComponentChildren, ComponentType } from 'preact';
import { useEffect, useMemo, useState } from 'preact/hooks';
import type { JointRange, MotionAnswer } from '../../model/motion.ts';
import type { PartDisplay } from '../../view/view-types.ts';
import { type Driver, MotionBoard } from '../motion/motion-board.ts';
import type { MotionToolsProps } from '../motion/motion-tools.tsx';
import { Transport } from '../motion/transport.tsx';
import { formatNumber } from '../text/language.ts';
import type { CheckProps, CheckStatus, CheckView } from './check-registry.ts';
import { useSceneDisplay } from './motion-player.tsx';
import { answerOf, motionStatus } from './motion-status.ts';
import { type MotionStudy, type Mover, motionStudyOf } from './motion-study.ts';
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
  const study = motionStudyOf(shown);
  return (
    <JointList
      joints={answer.joints}
      study={study}
      onDisplay={onDisplay}
      tools={(board, onDrive) => (
        <LateTools shown={shown} study={study} answer={answer} board={board} onDrive={onDrive} />
      )}
    />
  );
}

/** Dragging, traces, plots and films: they come when a joint is first looked at. */
function LateTools(props: MotionToolsProps) {
  const [Tools, setTools] = useState<ComponentType<MotionToolsProps> | null>(null);
  useEffect(() => {
    let open = true;
    import('../motion/motion-tools.tsx').then(
      ({ MotionTools }) => open && setTools(() => MotionTools),
      () => undefined,
    );
    return () => {
      open = false;
    };
  }, []);
  return Tools ? <Tools {...props} /> : null;
}

/** The joints with their ranges; those that are chosen can be turned. */
export function JointList(props: {
  readonly joints: readonly JointRange[];
  readonly study: MotionStudy;
  readonly onDisplay: (display: PartDisplay | null) => void;
  /** What else can be done with the motion of the model in the drawing. */
  readonly tools?: (board: MotionBoard, onDrive: (joint: number) => void) => ComponentChildren;
}) {
  const { joints, study, onDisplay, tools } = props;
  const board = useMemo(() => new MotionBoard(study), [study]);
  const [open, setOpen] = useState(0);
  const [note, setNote] = useState('');
  const chosen = joints[open];
  useEffect(() => {
    setNote('');
    if (chosen?.turns) {
      void board.choose(moverOf(chosen), chosen);
    }
  }, [board, chosen]);
  if (joints.length === 0) {
    return <p class="quiet">{words.aboutNoJoints}</p>;
  }
  const toggle = async (joint: JointRange) => {
    const done = await board.toggle(moverOf(joint), joint);
    setNote(done === 'not together' ? words.notTogether(nameOf(joint)) : '');
  };
  return (
    <>
      <ul class="motion-list">
        {joints.map((joint, i) => (
          <JointRow key={joint.index} joint={joint} open={open === i} onOpen={() => setOpen(i)}>
            {open !== i && joint.turns && chosen?.turns ? (
              <label class="motion-too">
                <input
                  type="checkbox"
                  checked={board.drives(moverOf(joint))}
                  onChange={() => void toggle(joint)}
                />{' '}
                {words.too}
                <span class="visually-hidden"> {nameOf(joint)}</span>
              </label>
            ) : null}
          </JointRow>
        ))}
      </ul>
      <p class={note ? 'quiet' : 'visually-hidden'} role="status">
        {note}
      </p>
      {chosen?.turns ? (
        <Transport
          board={board}
          nameOf={(driver) => nameIn(joints, driver)}
          onDisplay={onDisplay}
        />
      ) : null}
      {chosen?.turns ? tools?.(board, setOpen) : null}
    </>
  );
}

function JointRow(props: {
  readonly joint: JointRange;
  readonly open: boolean;
  readonly onOpen: () => void;
  readonly children: ComponentChildren;
}) {
  const { joint, open, onOpen, children } = props;
  return (
    <li>
      <button type="button" class="button" aria-pressed={open} onClick={onOpen}>
        {nameOf(joint)}
      </button>{' '}
      <span class="quiet">{rangeText(joint)}</span>
      {children}
      {joint.turns ? null : <p class="quiet">{inWords(joint.message)}</p>}
    </li>
  );
}

function moverOf({ index }: JointRange): Mover {
  return { of: 'joint', index };
}

function nameIn(joints: readonly JointRange[], { mover }: Driver): string {
  const joint = joints.find(({ index }) => index === mover.index);
  return joint ? nameOf(joint) : '';
}
