import type { ComponentChildren } from 'preact';
import { useLayoutEffect, useRef } from 'preact/hooks';
import { Icon } from './icon.tsx';
import { usePage } from './page-context.ts';
import { text } from './text.ts';

/** A sheet over the page: the browser keeps the focus in it and closes it on Escape. */
export function Dialog(props: {
  readonly title: string;
  readonly class?: string;
  readonly children: ComponentChildren;
}) {
  const { dialog } = usePage();
  const element = useRef<HTMLDialogElement>(null);
  // At once: a key that comes right after, as Escape, is the sheet's already.
  useLayoutEffect(() => {
    element.current?.showModal();
  }, []);
  const left = useRef(false);
  // At once as well, and not when the browser comes to tell: a key that comes right after is the page's, or asks for
  // the next sheet. Closed first, so that the focus goes back.
  const close = () => {
    if (!left.current) {
      left.current = true;
      element.current?.close();
      dialog.value = null;
    }
  };
  return (
    // biome-ignore lint/a11y/useKeyWithClickEvents: Escape closes it; the click is on the veil
    <dialog
      ref={element}
      class={`dialog ${props.class ?? ''}`}
      aria-label={props.title}
      onCancel={close}
      onClose={close}
      onClick={(event) => {
        if (event.target === element.current) {
          close();
        }
      }}
    >
      <div class="dialog-body">
        <header class="dialog-head">
          <h2>{props.title}</h2>
          <button type="button" class="icon-button" aria-label={text.app.close} onClick={close}>
            <Icon name="close" />
          </button>
        </header>
        {props.children}
      </div>
    </dialog>
  );
}
