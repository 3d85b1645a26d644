/**
 * Watches a canvas for the loss of its graphics context, and for its return.
 * @returns what ends it.
 */
export function watchContext(
  canvas: HTMLCanvasElement,
  report: (state: 'lost' | 'restored') => void,
): () => void {
  const stop = new AbortController();
  const { signal } = stop;
  canvas.addEventListener(
    'webglcontextlost',
    (event) => {
      // Tells the browser that we go on when it gives the context back.
      event.preventDefault();
      report('lost');
    },
    { signal },
  );
  canvas.addEventListener('webglcontextrestored', () => report('restored'), { signal });
  return () => stop.abort();
}
