import { useState } from 'preact/hooks';
import { fillWords } from '../../tools/tool-words.ts';
import { formatNumber } from '../text/language.ts';
import { copyText } from './copy-text.ts';
import { embedHtml } from './page-link.ts';
import { MAX_QR_BYTES, QrCode, qrSvg } from './qr-code.tsx';
import { safeName, saveFile } from './save-file.ts';
import { shareWords } from './share-words.ts';

/** A text that can be copied, with its button. */
function Copyable(props: {
  readonly label: string;
  readonly button: string;
  readonly text: string;
  readonly rows: number;
}) {
  const [said, setSaid] = useState('');
  const copy = () => {
    copyText(props.text).then(
      () => setSaid(shareWords.copied),
      () => setSaid(shareWords.copyFailed),
    );
  };
  return (
    <>
      <textarea
        class="share-text"
        aria-label={props.label}
        readOnly
        rows={props.rows}
        value={props.text}
        onFocus={(event) => event.currentTarget.select()}
      />
      <div class="share-buttons">
        <button type="button" class="button primary" onClick={copy}>
          {props.button}
        </button>
        <span role="status">{said}</span>
      </div>
    </>
  );
}

/** The link as text, as QR code, and as HTML for other pages. */
export function LinkSection({ url, title }: { readonly url: string; readonly title: string }) {
  const svg = qrSvg(url);
  return (
    <>
      <section class="share-card">
        <h3>{shareWords.linkTitle}</h3>
        <p class="quiet">{shareWords.linkText}</p>
        <Copyable label={shareWords.linkField} button={shareWords.copyLink} text={url} rows={3} />
        <p class="quiet" data-testid="link-length">
          {fillWords(shareWords.length, { n: formatNumber(url.length) })}
        </p>
        {'share' in navigator ? (
          <button
            type="button"
            class="button"
            onClick={() => {
              // Closing the sheet is no failure.
              navigator.share({ title, url }).catch(() => undefined);
            }}
          >
            {shareWords.shareSheet}
          </button>
        ) : null}
      </section>
      <section class="share-card">
        <h3>{shareWords.qrTitle}</h3>
        {svg ? (
          <>
            <QrCode text={url} label={shareWords.qrLabel} />
            <button
              type="button"
              class="button"
              onClick={() =>
                saveFile(safeName(title, 'qr.svg'), new Blob([svg], { type: 'image/svg+xml' }))
              }
            >
              {shareWords.qrSave}
            </button>
          </>
        ) : (
          <p class="quiet">{fillWords(shareWords.qrTooLong, { n: MAX_QR_BYTES })}</p>
        )}
      </section>
      <section class="share-card">
        <h3>{shareWords.embedTitle}</h3>
        <p class="quiet">{shareWords.embedText}</p>
        <Copyable
          label={shareWords.embedField}
          button={shareWords.copyEmbed}
          text={embedHtml(url, title)}
          rows={4}
        />
      </section>
    </>
  );
}
