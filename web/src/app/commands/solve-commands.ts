import type { Command } from '../../ui/command.ts';
import { text } from '../../ui/text.ts';
import type { Actions } from '../actions.ts';

/** Starting and stopping the search. */
export function solveCommands(actions: Actions): Command[] {
  const { state } = actions;
  const { preferences } = state;
  return [
    {
      id: 'generate',
      label: text.commands.generate,
      group: 'solve',
      icon: 'play',
      shortcut: 'Mod+Enter',
      when: () => state.store.sketch.value.lines.length > 0,
      run: actions.generate,
    },
    {
      id: 'cancel',
      label: text.commands.cancel,
      group: 'solve',
      icon: 'stop',
      when: () => state.solve.value.phase === 'solving',
      run: actions.cancel,
    },
    {
      id: 'autoSolve',
      label: text.commands.autoSolve,
      group: 'solve',
      icon: 'play',
      checked: () => preferences.value.autoSolve,
      run: () => {
        preferences.value = { ...preferences.value, autoSolve: !preferences.value.autoSolve };
      },
    },
    {
      id: 'alternatives',
      label: text.commands.alternatives,
      group: 'solve',
      icon: 'gallery',
      when: () => state.store.sketch.value.lines.length > 0,
      run: () => {
        state.dialog.value = 'alternatives';
      },
    },
    {
      id: 'bricks',
      label: text.commands.bricks,
      group: 'solve',
      icon: 'parts',
      run: () => {
        state.dialog.value = 'bricks';
      },
    },
    {
      id: 'searchLonger',
      label: text.commands.searchLonger,
      group: 'solve',
      icon: 'play',
      when: () => state.store.sketch.value.lines.length > 0 && preferences.value.effort < 16,
      run: () => {
        const effort = Math.min(16, Math.max(1, preferences.value.effort) * 4);
        preferences.value = { ...preferences.value, effort };
        actions.generate();
      },
    },
    {
      id: 'newSeed',
      label: text.commands.newSeed,
      group: 'solve',
      icon: 'redo',
      when: () => state.store.sketch.value.lines.length > 0,
      run: () => {
        preferences.value = { ...preferences.value, seed: preferences.value.seed + 1 };
        actions.generate();
      },
    },
  ];
}
