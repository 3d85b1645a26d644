import type { ComponentChildren, ComponentType } from 'preact';
import { useEffect, useMemo, useState } from 'preact/hooks';
import type { MotionAnswer } from '../../model/motion.ts';
import type { PartDisplay } from '../../view/view-types.ts';
import { type Driver, MotionBoard } from '../motion/motion-board.ts';
import type { MotionToolsProps } from '../motion/motion-tools.tsx';
import { Transport } from '../motion/transport.tsx';
import type { CheckProps, CheckStatus, CheckView } from './check-registry.ts';
import { useSceneDisplay } from './motion-player.tsx';
import { answerOf, motionStatus } from './motion-status.ts';
import { type MotionStudy, motionStudyOf } from './motion-study.ts';
import { motionWords as words } from './motion-words.ts';
import { isSame, type Turnable, turnablesOf } from './turnables.ts';
import './motion.css';
import { inWords } from '../text/sentences.ts';

/** Each joint of the sketch with its range, each train of shafts; one of them can be turned. */
export const JOINTS_CHECK: CheckView = {
  id: 'joint-ranges',
  title: words.joints,
  status: motionStatus(statusOf),
  component: JointsCheck,
};

function statusOf(answer: MotionAnswer): CheckStatus {
  const all = turnablesOf(answer);
  if (all.length === 0) {
    return { state: 'none', number: words.noJoints };
  }
  const turning = all.filter((each) => each.turns).length;
  const [only] = all;
  return {
    state: turning === all.length ? 'ok' : 'bad',
    number: all.length === 1 && only ? only.says : `${turning} / ${all.length}`,
  };
}

function JointsCheck({ shown }: CheckProps) {
  const onDisplay = useSceneDisplay();
  const answer = answerOf(shown);
  const rows = useMemo(() => (answer ? turnablesOf(answer, shown.sketch) : []), [answer, shown]);
  if (!answer) {
    return null;
  }
  const study = motionStudyOf(shown);
  return (
    <JointList
      joints={rows}
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

/** What turns, with its range; those that are chosen can be turned. */
export function JointList(props: {
  readonly joints: readonly Turnable[];
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
      void board.choose(chosen.mover, chosen.range);
    }
  }, [board, chosen]);
  if (joints.length === 0) {
    return <p class="quiet">{words.aboutNoJoints}</p>;
  }
  const toggle = async (joint: Turnable) => {
    const done = await board.toggle(joint.mover, joint.range);
    setNote(done === 'not together' ? words.notTogether(joint.name) : '');
  };
  return (
    <>
      <ul class="motion-list">
        {joints.map((joint, i) => (
          <JointRow
            key={`${joint.mover.of} ${joint.mover.index}`}
            joint={joint}
            open={open === i}
            onOpen={() => setOpen(i)}
          >
            {open !== i && joint.turns && chosen?.turns ? (
              <label class="motion-too">
                <input
                  type="checkbox"
                  checked={board.drives(joint.mover)}
                  onChange={() => void toggle(joint)}
                />{' '}
                {words.too}
                <span class="visually-hidden"> {joint.name}</span>
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
  readonly joint: Turnable;
  readonly open: boolean;
  readonly onOpen: () => void;
  readonly children: ComponentChildren;
}) {
  const { joint, open, onOpen, children } = props;
  return (
    <li>
      <button type="button" class="button" aria-pressed={open} onClick={onOpen}>
        {joint.name}
      </button>{' '}
      <span class="quiet">{joint.says}</span>
      {children}
      {joint.turns ? null : <p class="quiet">{inWords(joint.message)}</p>}
    </li>
  );
}

function nameIn(joints: readonly Turnable[], { mover }: Driver): string {
  return joints.find((joint) => isSame(joint.mover, mover))?.name ?? '';
}
