import { useEffect, useState } from 'preact/hooks';
import type { Place } from '../../model/keep.ts';
import { usePage } from '../page-context.ts';
import { formatNumber } from '../text/language.ts';
import { partName } from '../text/part-names.ts';
import type { Trial } from './touch-types.ts';
import { touchWords as words } from './touch-words.ts';
import { useFits } from './use-fits.ts';

/** What also fits where a part lies, each with what it changes. */
export function SwapList(props: {
  readonly index: number;
  readonly place: Place;
  readonly onTake: (place: Place) => void;
}) {
  const page = usePage();
  const fits = useFits(props.index);
  const [trials, setTrials] = useState<readonly Trial[]>([]);
  useEffect(() => {
    const stop = new AbortController();
    setTrials([]);
    const tryAll = async () => {
      for (const place of fits?.fits ?? []) {
        const trial = await page.tryPart(props.place, place, stop.signal);
        if (stop.signal.aborted) {
          return;
        }
        setTrials((before) => [...before, trial]);
      }
    };
    tryAll().catch(() => undefined);
    return () => stop.abort();
  }, [page, fits, props.place]);
  const good = trials.filter(({ change }) => change !== null);
  const all = fits?.fits.length ?? 0;
  const done = fits !== null && trials.length === all;
  return (
    <section class="swap" aria-label={words.swapTitle} aria-busy={!done}>
      <h4>{words.swapTitle}</h4>
      <ul>
        {good.map(({ place, change }) => (
          <li key={JSON.stringify(place)}>
            <button type="button" onClick={() => props.onTake(place)}>
              <strong>{partName(place.part.part, page.catalogue)}</strong>
              <span>{changeText(change)}</span>
            </button>
          </li>
        ))}
      </ul>
      <p class="quiet" role="status">
        {done
          ? good.length > 0
            ? words.swapKeeps
            : words.swapNone
          : words.swapSearching(formatNumber(trials.length), formatNumber(all))}
      </p>
    </section>
  );
}

/** What a swap changes, as "+2 parts, −1 beams". */
function changeText(change: Trial['change']): string {
  const { bricks = 0, beams = 0, freedoms = 0 } = change ?? {};
  const said = [
    bricks === 0 ? null : words.change.bricks(signed(bricks)),
    beams === 0 ? null : words.change.beams(signed(beams)),
    freedoms === 0 ? null : words.change.stiffer(signed(freedoms)),
  ].filter((word) => word !== null);
  return said.length > 0 ? said.join(', ') : words.change.same;
}

function signed(n: number): string {
  return n > 0 ? `+${formatNumber(n)}` : `−${formatNumber(-n)}`;
}
