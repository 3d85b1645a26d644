import type { ComponentType } from 'preact';
import { useEffect, useState } from 'preact/hooks';
import { fillWords } from '../../tools/tool-words.ts';
import { LessonPicture } from './lesson-picture.tsx';
import { LESSONS, type LessonId } from './lesson-table.ts';
import { lessonWords as words } from './lesson-words.ts';
import { TeacherPage } from './teacher-page.tsx';
import './lessons.css';

type Place = LessonId | 'teacher' | null;

const KEY = 'lesson';
const MINUTES = 4;

function placeInAddress(): Place {
  const name = new URLSearchParams(location.search).get(KEY);
  return name === 'teacher' ? name : (LESSONS.find((lesson) => lesson.id === name)?.id ?? null);
}

/** Keeps the lesson in the address, so that it can be linked and the back button leaves it. */
function usePlace(): readonly [Place, (place: Place) => void] {
  const [place, setPlace] = useState<Place>(placeInAddress);
  useEffect(() => {
    const back = () => setPlace(placeInAddress());
    window.addEventListener('popstate', back);
    return () => {
      window.removeEventListener('popstate', back);
      const url = new URL(location.href);
      url.searchParams.delete(KEY);
      history.replaceState(history.state, '', url.href);
    };
  }, []);
  const go = (next: Place) => {
    const url = new URL(location.href);
    if (next === null) {
      url.searchParams.delete(KEY);
    } else {
      url.searchParams.set(KEY, next);
    }
    history.pushState(history.state, '', url.href);
    setPlace(next);
  };
  return [place, go];
}

/** Lessons that run in the page, and what a teacher needs to hand them out. */
export function LessonsRoom() {
  const [place, go] = usePlace();
  const [presenting, setPresenting] = useState(false);
  useEffect(() => {
    const changed = () => setPresenting(document.fullscreenElement !== null);
    document.addEventListener('fullscreenchange', changed);
    return () => document.removeEventListener('fullscreenchange', changed);
  }, []);
  const present = () => {
    const next = !presenting;
    setPresenting(next);
    const change = next
      ? document.documentElement.requestFullscreen()
      : document.fullscreenElement
        ? document.exitFullscreen()
        : Promise.resolve();
    // Large type is worth having without the full screen, too.
    change.catch(() => undefined);
  };
  return (
    <div class={`lessons ${presenting ? 'presenting' : ''}`}>
      <nav class="lessons-bar">
        {place === null ? null : (
          <button type="button" class="button plain" onClick={() => go(null)}>
            {words.all}
          </button>
        )}
        <span class="lessons-space" />
        {presenting ? null : (
          <button type="button" class="button" onClick={() => go('teacher')}>
            {words.teacher}
          </button>
        )}
        <button
          type="button"
          class="button lessons-present"
          aria-pressed={presenting}
          onClick={present}
        >
          {presenting ? words.presentEnd : words.present}
        </button>
      </nav>
      {place === null ? <LessonList go={go} /> : null}
      {place === 'teacher' ? <TeacherPage /> : null}
      {place !== null && place !== 'teacher' ? <LessonPage key={place} id={place} go={go} /> : null}
    </div>
  );
}

function LessonList({ go }: { readonly go: (place: Place) => void }) {
  return (
    <>
      <p class="quiet">{words.intro}</p>
      <ol class="lesson-list">
        {LESSONS.map(({ id }) => (
          <li key={id}>
            <button type="button" class="lesson-card" onClick={() => go(id)}>
              <LessonPicture id={id} />
              <strong>{words.lessons[id][0]}</strong>
              <span class="quiet">{words.lessons[id][2]}</span>
              <small>{fillWords(words.minutes, { n: MINUTES })}</small>
            </button>
          </li>
        ))}
      </ol>
    </>
  );
}

function LessonPage(props: { readonly id: LessonId; readonly go: (place: Place) => void }) {
  const { id, go } = props;
  const [Body, setBody] = useState<{ readonly component: ComponentType } | null>(null);
  const index = LESSONS.findIndex((lesson) => lesson.id === id);
  const next = LESSONS[index + 1];
  useEffect(() => {
    let open = true;
    LESSONS[index]?.load().then(
      (component) => open && setBody({ component }),
      () => undefined,
    );
    return () => {
      open = false;
    };
  }, [index]);
  const [title, text, task] = words.lessons[id];
  return (
    <article class="lesson" data-lesson={id}>
      <h3>{title}</h3>
      <p>{text}</p>
      <p class="lesson-task">
        <strong>{words.task}:</strong> {task}
      </p>
      {Body ? <Body.component /> : null}
      {Body && next ? (
        <button type="button" class="button" onClick={() => go(next.id)}>
          {words.next}: {words.lessons[next.id][0]}
        </button>
      ) : null}
    </article>
  );
}
