import type { ComponentChildren } from 'preact';
import { Icon } from './icon.tsx';
import type { Page } from './page.ts';
import { usePage } from './page-context.ts';
import { text } from './text.ts';

/** The three steps of the first task, in order. */
type Step = 'draw' | 'model' | 'build';
const STEPS: readonly Step[] = ['draw', 'model', 'build'];

/** How far a newcomer is: something drawn, a model made of it, its instructions seen. Reads signals. */
export function firstStep({
  store,
  result,
  stale,
}: Pick<Page, 'store' | 'result' | 'stale'>): Step {
  if (store.sketch.value.lines.length === 0) {
    return 'draw';
  }
  const made = result.value?.final === true && result.value.buildable && !stale.value;
  return made ? 'build' : 'model';
}

/** The first task in three steps, over the drawing, until it is done or waved away. */
export function FirstSteps() {
  const page = usePage();
  const { preferences, lookedAt, room } = page;
  if (!preferences.value.guide || lookedAt.value || room.value !== null) {
    return null;
  }
  const now = firstStep(page);
  const end = () => {
    preferences.value = { ...preferences.peek(), guide: false };
  };
  return (
    <section class="first-steps floating" aria-label={text.guide.title}>
      <ol>
        {STEPS.map((step) => (
          <li
            key={step}
            aria-current={step === now ? 'step' : undefined}
            class={stateOf(step, now)}
          >
            <span class="step-dot">
              {stateOf(step, now) === 'done' ? <Icon name="check" /> : STEPS.indexOf(step) + 1}
            </span>
            {text.guide[step]}
          </li>
        ))}
      </ol>
      <button type="button" class="icon-button small" aria-label={text.guide.away} onClick={end}>
        <Icon name="close" />
      </button>
      <StepWords now={now} end={end} />
    </section>
  );
}

function stateOf(step: Step, now: Step): 'done' | 'now' | 'later' {
  const ahead = STEPS.indexOf(step) - STEPS.indexOf(now);
  return ahead < 0 ? 'done' : ahead === 0 ? 'now' : 'later';
}

function StepWords({ now, end }: { readonly now: Step; readonly end: () => void }) {
  const page = usePage();
  switch (now) {
    case 'draw':
      return (
        <Words words={text.guide.drawText}>
          {page.tool.value.id === 'box' ? null : (
            <button
              type="button"
              class="button primary small"
              onClick={() => page.commands.run('tool.box')}
            >
              {text.guide.box}
            </button>
          )}
        </Words>
      );
    case 'model':
      return <Words words={text.guide.modelText} />;
    case 'build':
      return (
        <Words words={text.guide.buildText}>
          <button
            type="button"
            class="button primary small"
            onClick={() => {
              end();
              page.openRoom('instructions');
            }}
          >
            {text.guide.open}
          </button>
        </Words>
      );
  }
}

function Words(props: { readonly words: string; readonly children?: ComponentChildren }) {
  return (
    <p>
      <span>{props.words}</span>
      {props.children}
    </p>
  );
}
