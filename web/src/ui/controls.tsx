import type { ComponentChildren } from 'preact';
import { Icon, type IconName } from './icon.tsx';
import { usePage } from './page-context.ts';
import { shortcutKeys } from './shortcut.ts';

interface IconButtonProps {
  readonly icon: IconName;
  readonly label: string;
  readonly onClick: () => void;
  readonly pressed?: boolean;
  readonly disabled?: boolean;
  readonly shortcut?: string | undefined;
  readonly class?: string;
}

/** A square button with an icon; its name is shown on hover and said by screen readers. */
export function IconButton(props: IconButtonProps) {
  const { mac } = usePage();
  const keys = props.shortcut ? ` (${shortcutKeys(props.shortcut, mac).join('+')})` : '';
  return (
    <button
      type="button"
      class={`icon-button ${props.class ?? ''}`}
      aria-label={props.label}
      title={props.label + keys}
      aria-pressed={props.pressed}
      disabled={props.disabled}
      onClick={props.onClick}
    >
      <Icon name={props.icon} />
    </button>
  );
}

/** A button for one command: its icon, or its icon and words. */
export function CommandButton(props: {
  readonly id: string;
  readonly words?: string;
  /** The words are too short to be its name: the command's own is said. */
  readonly named?: boolean;
  readonly class?: string;
}) {
  const { commands, mac } = usePage();
  const command = commands.get(props.id);
  const disabled = command.when ? !command.when() : false;
  const pressed = command.checked?.();
  const keys = command.shortcut ? ` (${shortcutKeys(command.shortcut, mac).join('+')})` : '';
  return (
    <button
      type="button"
      class={`${props.words ? 'button' : 'icon-button'} ${props.class ?? ''}`}
      aria-label={props.words && !props.named ? undefined : command.label}
      title={command.label + keys}
      aria-pressed={pressed}
      disabled={disabled}
      onClick={command.run}
    >
      <Icon name={command.icon} />
      {props.words ? <span>{props.words}</span> : null}
    </button>
  );
}

export interface Choice<T extends string> {
  readonly value: T;
  readonly label: string;
}

/** A few choices side by side, one of them taken: radio buttons that look like one control. */
export function Segmented<T extends string>(props: {
  readonly name: string;
  readonly legend: string;
  readonly choices: readonly Choice<T>[];
  readonly value: T;
  readonly onChange: (value: T) => void;
}) {
  return (
    <fieldset class="segmented">
      <legend class="visually-hidden">{props.legend}</legend>
      {props.choices.map((choice) => (
        <label key={choice.value}>
          <input
            type="radio"
            name={props.name}
            checked={choice.value === props.value}
            onChange={() => props.onChange(choice.value)}
          />
          <span>{choice.label}</span>
        </label>
      ))}
    </fieldset>
  );
}

/** The keys of a shortcut. */
export function Keys({ shortcut }: { readonly shortcut: string }) {
  const { mac } = usePage();
  return (
    <span class="keys">
      {shortcutKeys(shortcut, mac).map((key) => (
        <kbd key={key}>{key}</kbd>
      ))}
    </span>
  );
}

/** A part of the panel that can be folded. */
export function Section(props: {
  readonly title: string;
  readonly note?: string;
  readonly open?: boolean;
  readonly children: ComponentChildren;
}) {
  return (
    <details class="section" open={props.open}>
      <summary>
        <Icon name="chevron" />
        <h3>{props.title}</h3>
        {props.note ? <span class="quiet">{props.note}</span> : null}
      </summary>
      <div class="section-body">{props.children}</div>
    </details>
  );
}
