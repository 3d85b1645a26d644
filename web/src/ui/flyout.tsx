import type { ComponentChildren } from 'preact';
import { useEffect, useRef } from 'preact/hooks';
import { Icon, type IconName } from './icon.tsx';

/** A button that opens a small sheet above itself; a click elsewhere or Escape closes it. */
export function Flyout(props: {
  readonly icon: IconName;
  readonly label: string;
  readonly words?: string;
  readonly active?: boolean;
  readonly class?: string;
  readonly rows?: boolean;
  readonly children: ComponentChildren;
}) {
  const element = useRef<HTMLDetailsElement>(null);
  useEffect(() => {
    const close = (event: PointerEvent | KeyboardEvent) => {
      const details = element.current;
      const inside = event.target instanceof Node && details?.contains(event.target);
      if (!details?.open || (event instanceof KeyboardEvent ? event.key !== 'Escape' : inside)) {
        return;
      }
      details.open = false;
      if (event instanceof KeyboardEvent) {
        event.stopPropagation();
        details.querySelector('summary')?.focus();
      }
    };
    window.addEventListener('pointerdown', close, { capture: true });
    window.addEventListener('keydown', close, { capture: true });
    return () => {
      window.removeEventListener('pointerdown', close, { capture: true });
      window.removeEventListener('keydown', close, { capture: true });
    };
  }, []);
  return (
    <details
      ref={element}
      class={`flyout ${props.class ?? ''}`}
      data-active={props.active ? 'true' : 'false'}
    >
      <summary aria-label={props.label} title={props.label}>
        <Icon name={props.icon} />
        {props.words ? <span>{props.words}</span> : null}
      </summary>
      <div class={props.rows ? 'flyout-body rows' : 'flyout-body'}>{props.children}</div>
    </details>
  );
}
