import type { ShownModel } from '../page.ts';
import { usePage } from '../page-context.ts';
import { settingsOf } from '../solve-settings.ts';
import { formatNumber } from '../text/language.ts';
import { inWords } from '../text/sentences.ts';
import type { CheckProps, CheckStatus, CheckView } from './check-registry.ts';
import { type ProofState, proofStudyOf } from './proof-study.ts';
import { proofWords as words } from './proof-words.ts';
import './motion.css';

/** Whether the sketch can be built of fewer beams: a bound at once, the proof on demand. */
export const PROOF_CHECK: CheckView = {
  id: 'proof',
  title: words.title,
  status: (_page, shown) => statusOf(shown, proofStudyOf(shown).now.value),
  component: ProofCheck,
};

interface Counts {
  readonly beams: number;
  /** Fewest that any layout with no more axles along lines has, as far as is known. */
  readonly least: number;
}

function countsOf({ report }: Pick<ShownModel, 'report'>, proof: ProofState): Counts | null {
  if (report?.beams === undefined || report.beamsLowerBound === undefined) {
    return null;
  }
  const proved = proof.state === 'proved' ? proof.bound - (report.axles ?? 0) : 0;
  return { beams: report.beams, least: Math.max(report.beamsLowerBound, proved) };
}

export function statusOf(shown: Pick<ShownModel, 'report'>, proof: ProofState): CheckStatus {
  const counts = countsOf(shown, proof);
  if (counts === null || proof.state === 'working') {
    return { state: counts === null ? 'none' : 'busy', number: '' };
  }
  const { beams, least } = counts;
  return beams <= least
    ? { state: 'ok', number: words.proved }
    : { state: 'none', number: words.atLeast(formatNumber(least)) };
}

function ProofCheck({ shown }: CheckProps) {
  const page = usePage();
  const study = proofStudyOf(shown);
  const proof = study.now.value;
  const counts = countsOf(shown, proof);
  if (counts === null || shown.sketch === null) {
    return <p class="quiet">{words.unknown}</p>;
  }
  const { beams, least } = counts;
  const sketchJson = JSON.stringify(shown.sketch);
  const prove = () => void study.start(sketchJson, settingsOf(page.preferences.value));
  return (
    <div class="motion-check">
      <p role="status" data-testid="proof">
        {beams <= least
          ? words.nobody(formatNumber(beams))
          : words.gap(formatNumber(beams), formatNumber(least))}
        {proof.state === 'proved' && beams > least ? ` ${words.openGap}` : ''}
      </p>
      {proof.state === 'working' ? (
        <>
          <p class="quiet">
            {proof.progress === null
              ? words.loading
              : words.working(
                  formatNumber(proof.progress.done),
                  formatNumber(proof.progress.pieces),
                  formatNumber(proof.progress.leaves),
                )}
          </p>
          <button type="button" onClick={() => study.stop()}>
            {words.stop}
          </button>
        </>
      ) : null}
      {proof.state === 'open' && beams > least ? (
        <button type="button" onClick={prove}>
          {words.prove}
        </button>
      ) : null}
      {proof.state === 'failed' ? (
        <p role="alert">
          {words.failed} {inWords(proof.message)}
        </p>
      ) : null}
      <p class="quiet">{words.about}</p>
    </div>
  );
}
