import { useState } from 'preact/hooks';
import type { BridgeContest } from '../../../model/contest/bridge.ts';
import { faultOfGhost, type GhostTruss, ghostSketch } from '../../../solver/truss/ghost-truss.ts';
import { findTruss } from '../../../solver/truss/truss-client.ts';
import { fillWords } from '../../../tools/tool-words.ts';
import { usePage } from '../../page-context.ts';
import { formatNumber } from '../../text/language.ts';
import { inWords } from '../../text/sentences.ts';
import { useOneJob } from '../one-job.ts';
import { contestWords as words } from './contest-words.ts';

interface Found {
  readonly rules: BridgeContest;
  readonly truss: GhostTruss;
}

/** The lightest truss for the deck, to be beaten: a picture on demand, and a drawing to begin with. */
export function GhostView(props: { readonly rules: BridgeContest; readonly close: () => void }) {
  const { rules, close } = props;
  const page = usePage();
  const { found, said, busy, find, stop } = useGhost();
  // Other rules have another ghost.
  const shown = found?.rules === rules ? found.truss : null;
  const take = (truss: GhostTruss) => {
    const sketch = ghostSketch(rules, truss, words.ghostName);
    page.openExample({ file: '', title: words.ghostName, description: '', sketch });
    close();
  };
  return (
    <>
      <div class="lab-row">
        <button
          type="button"
          class="button"
          disabled={faultOfGhost(rules) !== null}
          onClick={busy ? stop : () => find(rules)}
        >
          {busy ? words.stop : words.ghost}
        </button>
        {shown ? (
          <button type="button" class="button" onClick={() => take(shown)}>
            {words.ghostTake}
          </button>
        ) : null}
        <p role={said.bad ? 'alert' : 'status'} class="quiet">
          {said.text}
        </p>
      </div>
      {shown ? <GhostPicture truss={shown} /> : null}
    </>
  );
}

function useGhost() {
  const [found, setFound] = useState<Found | null>(null);
  const [said, setSaid] = useState({ text: '', bad: false });
  const job = useOneJob();
  const find = (rules: BridgeContest) => {
    const { signal } = job.begin();
    setSaid({ text: words.ghostBusy, bad: false });
    findTruss(rules, signal)
      .then((truss) => {
        setFound(truss ? { rules, truss } : null);
        setSaid({ text: '', bad: false });
      })
      .catch((error: unknown) => {
        const message = inWords(error instanceof Error ? error.message : String(error));
        setSaid({ text: fillWords(words.badDeck, { message }), bad: true });
      })
      .finally(job.end);
  };
  return { found, said, busy: job.busy, find, stop: job.stop };
}

/** One side of it: the stronger a member must be, the thicker it is drawn. */
function GhostPicture({ truss: { members, volume } }: { readonly truss: GhostTruss }) {
  const places = members.flatMap(({ from, to }) => [from, to]);
  const xs = places.map(([x]) => x);
  const zs = places.map(([, z]) => z);
  const [left, top] = [Math.min(...xs) - 1, Math.max(...zs) + 1];
  const size = [Math.max(...xs) + 1 - left, top - Math.min(...zs) + 1];
  const most = Math.max(...members.map(({ strength }) => strength));
  const text = fillWords(words.ghostFound, { volume: formatNumber(volume) });
  return (
    <figure class="curves">
      <svg viewBox={`0 0 ${size.join(' ')}`} role="img" aria-label={text} class="ghost-truss">
        {members.map(({ from, to, strength }) => (
          <path
            key={`${from.join()} ${to.join()}`}
            d={`M${from[0] - left} ${top - from[1]}L${to[0] - left} ${top - to[1]}`}
            stroke-width={0.1 + (0.4 * strength) / most}
          />
        ))}
      </svg>
      <figcaption>{text}</figcaption>
    </figure>
  );
}
