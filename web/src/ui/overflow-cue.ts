import type { RefObject } from 'preact';
import { useEffect } from 'preact/hooks';

/** Closer to an end than this, nothing is cut off, CSS pixels. */
const SLACK = 4;

/**
 * Marks a row or column that scrolls with where it goes on (`data-more="start end"`), so that its style can show
 * that something is cut off there.
 */
export function useOverflowCue(element: RefObject<HTMLElement | null>): void {
  useEffect(() => {
    const row = element.current;
    if (!row) {
      return;
    }
    const mark = () => {
      const across = row.scrollWidth > row.clientWidth + SLACK;
      const at = across ? row.scrollLeft : row.scrollTop;
      const most = across ? row.scrollWidth - row.clientWidth : row.scrollHeight - row.clientHeight;
      const more = [at > SLACK ? 'start' : '', at < most - SLACK ? 'end' : ''];
      row.dataset['more'] = more.filter(Boolean).join(' ');
    };
    const watch = new ResizeObserver(mark);
    watch.observe(row);
    row.addEventListener('scroll', mark, { passive: true });
    mark();
    return () => {
      watch.disconnect();
      row.removeEventListener('scroll', mark);
    };
  }, [element]);
}
