import { useEffect, useState } from 'preact/hooks';
import { scale, type Vec3 } from '../../geometry/vec.ts';
import { sharedState } from '../../share/shared-state.ts';
import { fillWords } from '../../tools/tool-words.ts';
import { ISO_OUT } from '../../view/drawing/drawing-camera.ts';
import { modelComing } from '../model-coming.ts';
import { modelTitle } from '../model-title.ts';
import { NeedsModel } from '../needs-model.tsx';
import { usePage } from '../page-context.ts';
import { FileList } from './file-list.tsx';
import { LinkSection } from './link-section.tsx';
import { linkTo } from './page-link.ts';
import { shareWords } from './share-words.ts';
import './share.css';
import { inWords } from '../text/sentences.ts';

/** Link, QR code, embedding, and every file that can be downloaded. */
export function ShareRoom() {
  const page = usePage();
  const sketch = page.store.sketch.value;
  const preferences = page.preferences.value;
  const [link, setLink] = useState<{ readonly url: string; readonly refusal: string }>({
    url: '',
    refusal: '',
  });
  useEffect(() => {
    let current = true;
    linkTo(sharedState(sketch, preferences), location.href)
      .then((result) => {
        if (current) {
          setLink(
            result.ok ? { url: result.value, refusal: '' } : { url: '', refusal: result.message },
          );
        }
      })
      .catch(() => undefined);
    return () => {
      current = false;
    };
  }, [sketch, preferences]);
  const solving = modelComing(page);
  // A layout that is still being improved is nothing to take away.
  const shown = solving ? null : page.shown.value;
  if (sketch.lines.length === 0 && !shown) {
    return <NeedsModel />;
  }
  const title = modelTitle(page) || 'model';
  const eye = page.view()?.viewDirection();
  const out: Vec3 = eye ? scale(eye, -1) : ISO_OUT;
  return (
    <div class="share-room">
      {link.refusal ? <p role="alert">{inWords(link.refusal)}</p> : null}
      {link.url ? <LinkSection url={link.url} title={title} /> : null}
      <FileList
        solving={solving}
        source={{
          title,
          sketch,
          model: shown ? { json: shown.json, model: shown.model } : null,
          catalogue: page.catalogue,
          out,
        }}
      />
      <section class="share-card">
        <h3>{shareWords.open}</h3>
        <p class="quiet">{fillWords(shareWords.openText, {})}</p>
        <button type="button" class="button" onClick={() => page.commands.run('open')}>
          {shareWords.open}
        </button>
      </section>
    </div>
  );
}
