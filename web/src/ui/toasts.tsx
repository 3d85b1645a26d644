import { Icon } from './icon.tsx';
import { usePage } from './page-context.ts';
import { inWords } from './text/sentences.ts';
import { text } from './text.ts';

/** Short messages; those about something that went wrong stay until they are closed. */
export function Toasts() {
  const page = usePage();
  return (
    <div class="toasts">
      {page.toasts.value.map((toast) => (
        <div
          key={toast.id}
          class={`toast ${toast.kind}`}
          role={toast.kind === 'error' ? 'alert' : 'status'}
        >
          <Icon name={toast.kind === 'error' ? 'alert' : 'info'} />
          <p>{inWords(toast.message)}</p>
          {toast.action ? (
            <button type="button" class="button secondary" onClick={toast.action.run}>
              {toast.action.label}
            </button>
          ) : null}
          <button
            type="button"
            class="icon-button small"
            aria-label={text.app.close}
            onClick={() => page.dismissToast(toast.id)}
          >
            <Icon name="close" />
          </button>
        </div>
      ))}
    </div>
  );
}
