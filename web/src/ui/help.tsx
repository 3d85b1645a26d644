import type { CommandGroup } from './command.ts';
import { Keys } from './controls.tsx';
import { Dialog } from './dialog.tsx';
import { usePage } from './page-context.ts';
import { text } from './text.ts';

const GROUPS: readonly CommandGroup[] = [
  'draw',
  'edit',
  'annotate',
  'solve',
  'view',
  'file',
  'help',
];

/** The help sheet, made from the table of commands. */
export function Help() {
  const { commands } = usePage();
  return (
    <Dialog title={text.help.title} class="help">
      <p>{text.help.text}</p>
      <div class="help-columns">
        <WordRows title={text.help.pointer} rows={text.help.pointerRows} />
        <WordRows title={text.help.drawing} rows={text.help.drawingRows} />
        {GROUPS.map((group) => (
          <section key={group}>
            <h3>{text.groups[group]}</h3>
            <ul>
              {commands.all
                .filter((command) => command.group === group && command.shortcut)
                .map((command) => (
                  <li key={command.id}>
                    <span>{command.label}</span>
                    <Keys shortcut={command.shortcut ?? ''} />
                  </li>
                ))}
            </ul>
          </section>
        ))}
      </div>
    </Dialog>
  );
}

function WordRows(props: {
  readonly title: string;
  readonly rows: readonly (readonly [string, string])[];
}) {
  return (
    <section>
      <h3>{props.title}</h3>
      <ul>
        {props.rows.map(([keys, what]) => (
          <li key={keys}>
            <span>{what}</span>
            <kbd>{keys}</kbd>
          </li>
        ))}
      </ul>
    </section>
  );
}
