import type { MotionAnswer } from '../../model/motion.ts';
import type { Page, ShownModel } from '../page.ts';
import type { CheckStatus } from './check-registry.ts';
import { motionStudyOf } from './motion-study.ts';

/** Starts the study once the search has ended, and says what `judge` says of its answer. */
export function motionStatus(judge: (answer: MotionAnswer) => CheckStatus) {
  return (_page: Page, shown: ShownModel): CheckStatus => {
    if (shown.report === null && shown.check === null) {
      return { state: 'busy', number: '' };
    }
    const study = motionStudyOf(shown);
    study.start();
    const progress = study.progress.value;
    if (progress.state === 'waiting') {
      return { state: 'busy', number: '' };
    }
    return progress.state === 'done' ? judge(progress.answer) : { state: 'none', number: '' };
  };
}

/** The answer once it is there. */
export function answerOf(shown: ShownModel): MotionAnswer | null {
  const progress = motionStudyOf(shown).progress.value;
  return progress.state === 'done' ? progress.answer : null;
}
