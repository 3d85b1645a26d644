import { useEffect, useRef, useState } from 'preact/hooks';
import { fillWords } from '../../tools/tool-words.ts';
import { safeName, saveFile } from '../share/save-file.ts';
import {
  canWriteVideo,
  type FilmFile,
  type FilmOptions,
  type FilmSource,
  writeGif,
  writePictures,
  writeVideo,
} from './film-export.ts';
import { instructionWords as words } from './instruction-words.ts';

/** A film as a file: a video where the browser can write one, a GIF, single pictures. */
export function FilmFiles(props: {
  /** @throws Error when the browser cannot draw in 3D. */
  readonly open: () => FilmSource;
  /** Frees what open() made. */
  readonly close?: (source: FilmSource) => void;
  readonly speed: number;
  readonly title: string;
  /** Whether single pictures are of use. */
  readonly pictures: boolean;
}) {
  const [share, setShare] = useState<number | null>(null);
  const [failure, setFailure] = useState('');
  const running = useRef<AbortController | null>(null);
  useEffect(() => () => running.current?.abort(), []);
  const save = async (
    write: (source: FilmSource, options: FilmOptions) => Promise<FilmFile>,
  ): Promise<void> => {
    const stop = new AbortController();
    running.current = stop;
    setFailure('');
    setShare(0);
    let source: FilmSource | null = null;
    try {
      source = props.open();
      const options = { speed: props.speed, signal: stop.signal, onProgress: setShare };
      const file = await write(source, options);
      saveFile(safeName(props.title, file.extension), file.content);
    } catch (error) {
      if (!stop.signal.aborted) {
        setFailure(fillWords(words.filmFailed, { message: String(error) }));
      }
    } finally {
      if (source) {
        props.close?.(source);
      }
      running.current = null;
      setShare(null);
    }
  };
  const begin = (write: Parameters<typeof save>[0]) => () => {
    save(write).catch(() => undefined);
  };
  return (
    <div class="film-files">
      {share === null ? (
        <>
          {canWriteVideo() ? (
            <button type="button" class="button" onClick={begin(writeVideo)}>
              {words.saveVideo}
            </button>
          ) : null}
          <button type="button" class="button" onClick={begin(writeGif)}>
            {words.saveGif}
          </button>
          {props.pictures ? (
            <button type="button" class="button" onClick={begin(writePictures)}>
              {words.savePictures}
            </button>
          ) : null}
        </>
      ) : (
        <>
          <progress value={share} max={1} />
          <span role="status">{fillWords(words.encoding, { n: Math.round(share * 100) })}</span>
          <button type="button" class="button" onClick={() => running.current?.abort()}>
            {words.cancel}
          </button>
        </>
      )}
      {failure ? <p role="alert">{failure}</p> : null}
    </div>
  );
}
