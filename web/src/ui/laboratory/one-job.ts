import { useEffect, useRef, useState } from 'preact/hooks';

/** One long job of a view at a time: it can be stopped, and ends with the view. */
export function useOneJob() {
  const [busy, setBusy] = useState(false);
  const open = useRef<AbortController | null>(null);
  useEffect(() => () => open.current?.abort(), []);
  return {
    busy,
    /** Says that a job begins. @returns what stops it. */
    begin: (): AbortController => {
      open.current = new AbortController();
      setBusy(true);
      return open.current;
    },
    end: () => setBusy(false),
    stop: () => open.current?.abort(),
  };
}
