import { useEffect, useMemo } from 'preact/hooks';
import type { SketchDocument } from '../../../model/sketch.ts';
import { writeSketch } from '../../../state/read-sketch.ts';
import { fillWords } from '../../../tools/tool-words.ts';
import { ProofStudy } from '../../checks/proof-study.ts';
import { usePage } from '../../page-context.ts';
import { settingsOf } from '../../solve-settings.ts';
import { inWords } from '../../text/sentences.ts';
import { laboratoryWords } from '../laboratory-words.ts';
import { contestWords as words } from './contest-words.ts';

/** The puzzle, and how few beams anybody could do it with: a proof, on demand. */
export function FewestProof({ drawing }: { readonly drawing: SketchDocument }) {
  const page = usePage();
  // Another drawing needs another proof.
  const study = useMemo(() => new ProofStudy(), [drawing]);
  useEffect(() => () => study.stop(), [study]);
  const now = study.now.value;
  if (drawing.lines.length === 0) {
    return <p class="short">{words.beamsNeeds}</p>;
  }
  const prove = () => void study.start(writeSketch(drawing), settingsOf(page.preferences.peek()));
  const working = now.state === 'working';
  return (
    <>
      <p class="quiet">{words.beamsText}</p>
      <div class="lab-row">
        <button type="button" class="button" onClick={working ? () => study.stop() : prove}>
          {working ? words.stop : words.prove}
        </button>
        <p role="status">
          {working ? words.proving : null}
          {now.state === 'proved' ? fillWords(words.proved, { n: now.bound }) : null}
          {now.state === 'failed'
            ? fillWords(laboratoryWords.failed, { message: inWords(now.message) })
            : null}
        </p>
      </div>
    </>
  );
}
