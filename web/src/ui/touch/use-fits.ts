import { useEffect, useState } from 'preact/hooks';
import { usePage } from '../page-context.ts';
import type { Fits } from './touch-types.ts';

/** What else could lie where a part does; null until it is known. */
export function useFits(index: number): Fits | null {
  const page = usePage();
  const [fits, setFits] = useState<Fits | null>(null);
  const json = page.shown.value?.json;
  useEffect(() => {
    const stop = new AbortController();
    setFits(null);
    page.fits(index, stop.signal).then(
      (found) => {
        if (!stop.signal.aborted) {
          setFits(found);
        }
      },
      () => undefined,
    );
    return () => stop.abort();
  }, [page, index, json]);
  return fits;
}
