import { type Command, CommandTable } from '../ui/command.ts';
import type { Actions } from './actions.ts';
import { annotateCommands } from './commands/annotate-commands.ts';
import { drawCommands } from './commands/draw-commands.ts';
import { editCommands } from './commands/edit-commands.ts';
import { fileCommands } from './commands/file-commands.ts';
import { inspectCommands } from './commands/inspect-commands.ts';
import { roomCommands } from './commands/room-commands.ts';
import { solveCommands } from './commands/solve-commands.ts';
import { viewCommands } from './commands/view-commands.ts';

/** The one table of everything that a person can do. */
export function commandTable(actions: Actions): CommandTable {
  const commands: Command[] = [
    ...drawCommands(actions),
    ...editCommands(actions),
    ...annotateCommands(actions),
    ...solveCommands(actions),
    ...viewCommands(actions),
    ...inspectCommands(actions),
    ...fileCommands(actions),
    ...roomCommands(actions),
  ];
  return new CommandTable(commands);
}
