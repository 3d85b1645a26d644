import type { Tool } from '../tools/tool.ts';
import type { CommandTable } from '../ui/command.ts';
import { keyOf, matchesShortcut } from '../ui/shortcut.ts';

/** What the keyboard acts on. */
export interface KeyboardTarget {
  readonly commands: CommandTable;
  readonly mac: boolean;
  tool(): Tool;
  /** Whether a sheet lies over the page and takes the keys. */
  covered(): boolean;
  /** Escape with nothing left to step back from. */
  atRest(): void;
}

/** Further keys for a command, beside the one in the table. */
const ALIASES: readonly (readonly [string, string])[] = [
  ['Mod+Y', 'redo'],
  ['Backspace', 'delete'],
];

/** Keys first go to the tool in use, then to the table of commands. */
export function listenToKeys(target: KeyboardTarget, signal: AbortSignal): void {
  window.addEventListener(
    'keydown',
    (event) => {
      if (handleKey(event, target)) {
        event.preventDefault();
      }
    },
    { signal },
  );
}

function handleKey(event: KeyboardEvent, target: KeyboardTarget): boolean {
  if (target.covered() || event.isComposing) {
    return false;
  }
  const typing = isTextField(event.target);
  if (!typing && !event.ctrlKey && !event.metaKey && !event.altKey && givenToTool(event, target)) {
    return true;
  }
  const command = target.commands.all.find(
    (each) => each.shortcut !== undefined && matchesShortcut(event, each.shortcut, target.mac),
  );
  const alias = ALIASES.find(([shortcut]) => matchesShortcut(event, shortcut, target.mac));
  const id = command?.id ?? alias?.[1];
  // In a text field the browser's own keys win, but for those that no field uses.
  const inField = typing && !['palette', 'generate', 'open', 'saveSketch'].includes(id ?? '');
  return id !== undefined && !inField && target.commands.run(id);
}

function givenToTool(event: KeyboardEvent, target: KeyboardTarget): boolean {
  const tool = target.tool();
  if (event.key === 'Escape') {
    if (!tool.escape()) {
      target.atRest();
    }
    return true;
  }
  // On a button, Enter and the arrow keys are the button's.
  const onControl = event.target instanceof HTMLElement && event.target.matches('button, summary');
  if (onControl && (event.key === 'Enter' || event.key === 'Tab' || event.key === ' ')) {
    return false;
  }
  const onCanvas = event.target instanceof HTMLCanvasElement || event.target === document.body;
  if (event.key === 'Tab' && !onCanvas) {
    return false;
  }
  return tool.key({ key: keyOf(event), shift: event.shiftKey });
}

function isTextField(target: EventTarget | null): boolean {
  return (
    target instanceof HTMLElement &&
    target.matches('input:not([type=checkbox]):not([type=radio]), textarea, select')
  );
}
