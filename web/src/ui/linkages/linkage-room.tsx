import { useEffect, useRef, useState } from 'preact/hooks';
import type { AxisName } from '../../geometry/vec.ts';
import {
  type DrawnPath,
  type LinkageAnswer,
  type PathKind,
  type PlanePoint,
  pathJson,
  readAnswers,
} from '../../model/linkage-answer.ts';
import { comesBack, type PathShape, pathOfShape } from '../../model/path-shapes.ts';
import { createLinkageClient, type LinkageClient } from '../../solver/linkages/linkage-client.ts';
import { fillWords } from '../../tools/tool-words.ts';
import { Segmented } from '../controls.tsx';
import { usePage } from '../page-context.ts';
import { formatNumber } from '../text/language.ts';
import { inWords } from '../text/sentences.ts';
import { LinkagePicture } from './linkage-picture.tsx';
import { linkageWords as words } from './linkage-words.ts';
import { PathCanvas } from './path-canvas.tsx';
import './linkages.css';

const KINDS: readonly PathKind[] = ['any', 'foot', 'line'];
const PLANES: readonly AxisName[] = ['y', 'x', 'z'];
const SHAPES: readonly PathShape[] = ['foot', 'line', 'ellipse'];
const EMPTY: DrawnPath = { points: [], closed: true, kind: 'any', normal: 'y' };

interface Found {
  readonly path: DrawnPath;
  readonly answers: readonly LinkageAnswer[];
}

/** Draw a path, get machines that follow it. */
export function LinkageRoom({ close }: { readonly close: () => void }) {
  const page = usePage();
  const [path, setPath] = useState<DrawnPath>(EMPTY);
  const [said, setSaid] = useState({ text: '', bad: false });
  const [found, setFound] = useState<Found | null>(null);
  const client = useRef<LinkageClient | null>(null);
  const asked = useRef<DrawnPath>(EMPTY);
  useEffect(() => {
    const made = createLinkageClient({
      onProgress: (fraction) =>
        setSaid({
          text: fillWords(words.making, { percent: Math.round(fraction * 100) }),
          bad: false,
        }),
      onFound: (text, seconds) => {
        const answers = readAnswers(text);
        const n = answers.length;
        const filled = fillWords(words.found, { n, seconds: formatNumber(seconds, 2) });
        setFound({ path: asked.current, answers });
        setSaid({ text: n > 0 ? filled : words.none, bad: n === 0 });
      },
      onFailed: (message) =>
        setSaid({ text: fillWords(words.failed, { message: inWords(message) }), bad: true }),
    });
    client.current = made;
    return () => made.dispose();
  }, []);
  const ask = (next: DrawnPath) => {
    setPath(next);
    if (next.points.length > 1) {
      asked.current = next;
      setSaid({ text: words.looking, bad: false });
      client.current?.ask(pathJson(next));
    }
  };
  const take = (answer: LinkageAnswer) => {
    const { sketch } = answer;
    page.openExample({ file: '', title: sketch.name ?? '', description: '', sketch });
    close();
  };
  const done = (points: readonly PlanePoint[], stroke: boolean) => {
    const closed = stroke && path.kind === 'any' ? comesBack(points) : path.closed;
    ask({ ...path, points, closed });
  };
  return (
    <div class="linkages">
      <p class="quiet">{words.intro}</p>
      <PathChoices path={path} onChange={ask} />
      <PathCanvas
        points={path.points}
        closed={path.closed}
        onDraw={(points) => setPath({ ...path, points })}
        onDone={done}
      />
      <p role={said.bad ? 'alert' : 'status'} data-testid="linkage-said">
        {said.text}
      </p>
      <ol class="linkage-list">
        {found?.answers.map((answer, i) => (
          <AnswerCard
            key={`${answer.error}/${answer.links.join()}`}
            answer={answer}
            place={i + 1}
            path={found.path}
            onTake={() => take(answer)}
          />
        ))}
      </ol>
    </div>
  );
}

function PathChoices(props: {
  readonly path: DrawnPath;
  readonly onChange: (path: DrawnPath) => void;
}) {
  const { path, onChange } = props;
  return (
    <>
      <div class="linkage-row">
        <Segmented
          name="path-kind"
          legend={words.kind}
          choices={KINDS.map((value) => ({ value, label: words.kinds[value] }))}
          value={path.kind}
          onChange={(kind) => onChange({ ...path, kind, closed: kind !== 'line' })}
        />
        <Segmented
          name="path-plane"
          legend={words.plane}
          choices={PLANES.map((value) => ({ value, label: words.planes[value] }))}
          value={path.normal}
          onChange={(normal) => onChange({ ...path, normal })}
        />
        <label>
          <input
            type="checkbox"
            checked={path.closed}
            disabled={path.kind !== 'any'}
            onChange={(event) => onChange({ ...path, closed: event.currentTarget.checked })}
          />{' '}
          {words.closed}
        </label>
      </div>
      <div class="linkage-row">
        <span>{words.shapes}</span>
        {SHAPES.map((shape) => (
          <button
            key={shape}
            type="button"
            class="button"
            onClick={() => onChange({ ...path, ...pathOfShape(shape) })}
          >
            {words.shape[shape]}
          </button>
        ))}
        <button
          type="button"
          class="button plain"
          onClick={() => onChange({ ...path, points: [] })}
        >
          {words.clear}
        </button>
      </div>
    </>
  );
}

function AnswerCard(props: {
  readonly answer: LinkageAnswer;
  readonly place: number;
  readonly path: DrawnPath;
  readonly onTake: () => void;
}) {
  const { answer, place, path, onTake } = props;
  const [crank, coupler, rocker, frame] = answer.links;
  const error = formatNumber(answer.error, 2);
  const largest = formatNumber(answer.largest, 1);
  return (
    <li>
      <button
        type="button"
        class="linkage-card"
        aria-label={fillWords(words.take, { n: place, error })}
        onClick={onTake}
      >
        <LinkagePicture answer={answer} drawn={path.points} closed={path.closed} />
        <strong>{fillWords(words.error, { error, largest })}</strong>
        <span class="quiet">
          {fillWords(words.links, { crank, rocker, coupler: formatNumber(coupler, 2), frame })}
        </span>
        <span class="quiet">
          {fillWords(words.transmission, { angle: Math.floor(answer.transmission) })}
        </span>
      </button>
    </li>
  );
}
