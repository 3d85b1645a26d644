import type { IconName } from './icon.tsx';

export type CommandGroup = 'file' | 'edit' | 'draw' | 'annotate' | 'solve' | 'view' | 'help';

/** One thing that a person can do: it drives menu, buttons, shortcuts, palette and help. */
export interface Command {
  readonly id: string;
  readonly label: string;
  readonly group: CommandGroup;
  readonly icon: IconName;
  /** Such as `Mod+Shift+Z`; `Mod` is Command on a Mac and Control elsewhere. */
  readonly shortcut?: string;
  /** Whether it can be done now; always when left out. Reads signals. */
  readonly when?: () => boolean;
  /** For what is on or off: whether it is on. Reads signals. */
  readonly checked?: () => boolean;
  readonly run: () => void;
}

/** Commands by id, in the order of the table. */
export class CommandTable {
  readonly all: readonly Command[];
  readonly #byId: ReadonlyMap<string, Command>;

  constructor(commands: readonly Command[]) {
    this.all = commands;
    this.#byId = new Map(commands.map((command) => [command.id, command]));
  }

  /** Throws on an id that is not in the table: that is a mistake of ours. */
  get(id: string): Command {
    const command = this.#byId.get(id);
    if (!command) {
      throw new RangeError(`no command ${id}`);
    }
    return command;
  }

  /** Runs a command unless it cannot be done now. @returns whether it was run. */
  run(id: string): boolean {
    const command = this.get(id);
    if (command.when && !command.when()) {
      return false;
    }
    command.run();
    return true;
  }
}
