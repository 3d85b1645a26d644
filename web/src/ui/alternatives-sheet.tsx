import type { ComponentType } from 'preact';
import { useEffect, useState } from 'preact/hooks';
import { Dialog } from './dialog.tsx';
import { text } from './text.ts';

type Loaded = { readonly content: ComponentType } | 'loading' | 'failed';

/** Other models of the drawing; what finds and draws them comes when it is first asked for. */
export function AlternativesSheet() {
  const [loaded, setLoaded] = useState<Loaded>('loading');
  useEffect(() => {
    let open = true;
    import('./alternatives/alternatives-view.tsx').then(
      (module) => open && setLoaded({ content: module.AlternativesView }),
      () => open && setLoaded('failed'),
    );
    return () => {
      open = false;
    };
  }, []);
  return (
    <Dialog title={text.result.alternatives} class="alternatives">
      {loaded === 'loading' ? <p class="quiet">{text.app.loading}</p> : null}
      {loaded === 'failed' ? <p role="alert">{text.rooms.failed}</p> : null}
      {typeof loaded === 'object' ? <loaded.content /> : null}
    </Dialog>
  );
}
