import { useEffect, useMemo, useState } from 'preact/hooks';
import {
  BRIDGE_DEFAULTS,
  type BridgeContest,
  faultOfContest,
} from '../../../model/contest/bridge.ts';
import { createSolverPool, workersFor } from '../../../solver/solver-pool.ts';
import { fillWords } from '../../../tools/tool-words.ts';
import { Segmented } from '../../controls.tsx';
import { usePage } from '../../page-context.ts';
import { inWords } from '../../text/sentences.ts';
import { useOneJob } from '../one-job.ts';
import { BridgeRules } from './bridge-rules.tsx';
import { contestWords as words } from './contest-words.ts';
import { type Entry, readEntries } from './entries.ts';
import { FewestProof } from './fewest-proof.tsx';
import { GhostView } from './ghost-view.tsx';
import { type Contest, judgeEntry } from './judge.ts';
import type { Judged } from './ranking.ts';
import { RankingTable } from './ranking-table.tsx';

const KINDS = ['beams', 'bridge'] as const;
const FIRST_BRIDGE: BridgeContest = {
  ...BRIDGE_DEFAULTS,
  deck: { from: [0, 3, 6], to: [24, 3, 6] },
};

/** Links of a class, judged again and ranked. */
export function ContestView({ close }: { readonly close: () => void }) {
  const page = usePage();
  const [kind, setKind] = useState<Contest['kind']>('beams');
  const [bridge, setBridge] = useState(FIRST_BRIDGE);
  const [text, setText] = useState('');
  const { judged, count, busy, run, stop } = useJudging();
  const drawing = page.store.sketch.value;
  const entries = readEntries(text);
  const fault = kind === 'bridge' ? faultOfContest(bridge) : null;
  const missing = kind === 'beams' && drawing.lines.length === 0;
  const contest: Contest = kind === 'beams' ? { kind, drawing } : { kind, rules: bridge };
  return (
    <>
      <p class="quiet">{words.intro}</p>
      <Segmented
        name="contest-kind"
        legend={words.kind}
        choices={KINDS.map((value) => ({ value, label: words.kinds[value] }))}
        value={kind}
        onChange={setKind}
      />
      {kind === 'beams' ? (
        <FewestProof drawing={drawing} />
      ) : (
        <>
          <BridgeRules rules={bridge} onChange={setBridge} />
          <GhostView rules={bridge} close={close} />
        </>
      )}
      {fault ? <p role="alert">{fillWords(words.badDeck, { message: inWords(fault) })}</p> : null}
      <label class="contest-entries">
        <span>{words.entries}</span>
        <textarea
          rows={8}
          spellcheck={false}
          placeholder={words.example}
          value={text}
          disabled={busy}
          onInput={({ currentTarget }) => setText(currentTarget.value)}
        />
      </label>
      <div class="lab-row">
        {busy ? (
          <button type="button" class="button secondary" onClick={stop}>
            {words.stop}
          </button>
        ) : (
          <button
            type="button"
            class="button primary"
            disabled={entries.length === 0 || missing || fault !== null}
            onClick={() => run(entries, contest)}
          >
            {words.judge}
          </button>
        )}
        <p role="status" class="quiet" data-testid="contest-status">
          {statusOf({ ready: entries.length, judged: judged.length, all: count, busy })}
        </p>
      </div>
      {judged.length > 0 ? <RankingTable judged={judged} /> : null}
    </>
  );
}

function statusOf(at: {
  readonly ready: number;
  readonly judged: number;
  readonly all: number;
  readonly busy: boolean;
}): string {
  const { ready, judged: n, all, busy } = at;
  if (busy) {
    return fillWords(words.judging, { n, all });
  }
  if (all === 0) {
    return fillWords(words.ready, { n: ready });
  }
  return n < all ? fillWords(words.stopped, { n, all }) : fillWords(words.over, { n });
}

/** Some entries at a time, in workers of their own, which end with the view. */
function useJudging() {
  const { catalogue } = usePage();
  const lanes = workersFor(navigator.hardwareConcurrency + 1);
  const client = useMemo(() => createSolverPool({ workers: lanes }), [lanes]);
  const [judged, setJudged] = useState<readonly Judged[]>([]);
  const [count, setCount] = useState(0);
  const job = useOneJob();
  useEffect(() => () => client.dispose(), [client]);
  const run = (entries: readonly Entry[], contest: Contest) => {
    const { signal } = job.begin();
    const queue = [...entries.entries()];
    const found: (Judged | undefined)[] = [];
    setJudged([]);
    setCount(entries.length);
    const lane = async (): Promise<void> => {
      for (let next = queue.shift(); next && !signal.aborted; next = queue.shift()) {
        const [i, entry] = next;
        found[i] = await judgeEntry(entry, contest, { client, catalogue, signal });
        setJudged(found.filter((one) => one !== undefined));
      }
    };
    // A lane ends early only when all are stopped.
    void Promise.allSettled(Array.from({ length: lanes }, lane)).then(job.end);
  };
  return { judged, count, busy: job.busy, run, stop: job.stop };
}
