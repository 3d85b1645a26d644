import { useState } from 'preact/hooks';
import { Icon, type IconName } from '../icon.tsx';
import type { ResultState, ShownModel } from '../page.ts';
import { usePage } from '../page-context.ts';
import { inWords } from '../text/sentences.ts';
import { text } from '../text.ts';
import { CHECK_VIEWS, type CheckStatus, type CheckView } from './check-registry.ts';

const ICONS: Readonly<Record<CheckStatus['state'], IconName>> = {
  ok: 'check',
  bad: 'alert',
  none: 'info',
  busy: 'rotate',
};

/** What the contract asks of a model, and the further checks that are registered. */
export function ChecksSection({ result }: { readonly result: ResultState }) {
  const page = usePage();
  const shown = page.shown.value;
  if (result.items.length + CHECK_VIEWS.length === 0) {
    return null;
  }
  const good = result.items.filter((item) => item.ok).length;
  return (
    <section class="checks-section">
      <header>
        <h3>{text.result.checks}</h3>
        <span class="quiet">{`${good} / ${result.items.length}`}</span>
      </header>
      <ul class="checks">
        {result.items.map((item) => (
          <li key={item.id} class={item.ok ? 'ok' : 'bad'}>
            <Icon name={item.ok ? 'check' : 'alert'} />
            <div>
              {inWords(item.title)}
              {item.detail ? <p class="quiet">{inWords(item.detail)}</p> : null}
            </div>
          </li>
        ))}
        {shown
          ? CHECK_VIEWS.map((view) => <CheckRow key={view.id} view={view} shown={shown} />)
          : null}
      </ul>
    </section>
  );
}

/** One further check: a tick, a number, and what it opens to. */
export function CheckRow({
  view,
  shown,
}: {
  readonly view: CheckView;
  readonly shown: ShownModel;
}) {
  const page = usePage();
  const [open, setOpen] = useState(false);
  const { state, number } = view.status(page, shown);
  return (
    <li class={`check-view ${state}`}>
      <details
        open={open}
        onToggle={(event) => {
          setOpen(event.currentTarget.open);
        }}
      >
        <summary>
          <Icon name={ICONS[state]} />
          <span>{view.title}</span>
          <span class="quiet">{number}</span>
        </summary>
        {open ? <view.component shown={shown} /> : null}
      </details>
    </li>
  );
}
