import { useState } from 'preact/hooks';
import { fillWords } from '../../tools/tool-words.ts';
import { inWords } from '../text/sentences.ts';
import { text } from '../text.ts';
import {
  FILE_ROWS,
  type FileGroup,
  type FileKind,
  type FileSource,
  makeFile,
} from './file-kinds.ts';
import { safeName, saveFile } from './save-file.ts';
import { shareWords } from './share-words.ts';

const GROUPS: readonly FileGroup[] = ['building', 'buying', 'shapes', 'stress', 'own'];

/** Every file that the sketch or its model can be written as. */
export function FileList(props: { readonly source: FileSource; readonly solving: boolean }) {
  const { source, solving } = props;
  const [said, setSaid] = useState<{ readonly text: string; readonly bad: boolean }>({
    text: '',
    bad: false,
  });
  const [busy, setBusy] = useState<FileKind | null>(null);
  const write = async (kind: FileKind): Promise<void> => {
    const name = safeName(source.title, kind);
    setBusy(kind);
    try {
      saveFile(name, await makeFile(kind, source));
      setSaid({ text: fillWords(shareWords.written, { name }), bad: false });
    } catch (error) {
      const message = error instanceof Error ? error.message : String(error);
      setSaid({ text: fillWords(shareWords.failed, { message: inWords(message) }), bad: true });
    } finally {
      setBusy(null);
    }
  };
  return (
    <section class="share-card share-files">
      <h3>{shareWords.filesTitle}</h3>
      {source.model ? null : (
        <p class="quiet" role="status">
          {solving ? text.rooms.solving : shareWords.needsModel}
        </p>
      )}
      {GROUPS.map((group) => (
        <div key={group}>
          <h4>{shareWords.groups[group]}</h4>
          <ul class="file-list">
            {FILE_ROWS.filter((row) => row.group === group).map(({ kind }) => (
              <FileItem
                key={kind}
                kind={kind}
                busy={busy === kind}
                disabled={busy !== null || (!source.model && kind !== 'sketch.json')}
                onWrite={() => {
                  write(kind).catch(() => undefined);
                }}
              />
            ))}
          </ul>
        </div>
      ))}
      <p role={said.bad ? 'alert' : 'status'} class="share-said">
        {said.text}
      </p>
    </section>
  );
}

function FileItem(props: {
  readonly kind: FileKind;
  readonly busy: boolean;
  readonly disabled: boolean;
  readonly onWrite: () => void;
}) {
  const [name, note] = shareWords.files[props.kind];
  return (
    <li>
      <button
        type="button"
        class="file-button"
        disabled={props.disabled}
        aria-busy={props.busy}
        onClick={props.onWrite}
      >
        <strong>{name}</strong>
        <span class="quiet">{note}</span>
      </button>
    </li>
  );
}
