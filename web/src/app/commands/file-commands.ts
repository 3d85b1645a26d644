import type { Command } from '../../ui/command.ts';
import { text } from '../../ui/text.ts';
import type { Actions } from '../actions.ts';

/** Opening, saving and sharing. */
export function fileCommands(actions: Actions): Command[] {
  return [...openCommands(actions), ...saveCommands(actions)];
}

function openCommands(actions: Actions): Command[] {
  const row = { group: 'file', icon: 'open' } as const;
  const { state } = actions;
  return [
    { ...row, id: 'new', label: text.commands.new, icon: 'new', run: actions.newSketch },
    {
      ...row,
      id: 'open',
      label: text.commands.open,
      shortcut: 'Mod+O',
      run: actions.files.chooseFile,
    },
    {
      ...row,
      id: 'sketches',
      label: text.commands.sketches,
      icon: 'sketches',
      shortcut: 'Shift+S',
      run: () => {
        state.dialog.value = 'sketches';
      },
    },
    {
      ...row,
      id: 'examples',
      label: text.commands.examples,
      icon: 'gallery',
      shortcut: 'Shift+E',
      run: () => {
        state.dialog.value = 'examples';
      },
    },
    {
      ...row,
      id: 'share',
      label: text.commands.share,
      icon: 'share',
      when: () => state.store.sketch.value.lines.length > 0,
      run: actions.files.share,
    },
  ];
}

function saveCommands(actions: Actions): Command[] {
  const { state } = actions;
  const model = () => state.shown.value !== null;
  const row = { group: 'file', icon: 'download' } as const;
  return [
    {
      ...row,
      id: 'saveSketch',
      label: text.commands.saveSketch,
      shortcut: 'Mod+S',
      when: () => state.store.sketch.value.lines.length > 0,
      run: actions.files.saveSketch,
    },
    {
      ...row,
      id: 'saveMpd',
      label: text.commands.saveMpd,
      when: model,
      run: () => actions.files.exportModel('mpd'),
    },
    {
      ...row,
      id: 'saveModel',
      label: text.commands.saveModel,
      when: model,
      run: actions.files.saveModel,
    },
    {
      ...row,
      id: 'saveParts',
      label: text.commands.saveParts,
      icon: 'parts',
      when: model,
      run: () => actions.files.exportModel('parts.csv'),
    },
    {
      ...row,
      id: 'savePicture',
      label: text.commands.savePicture,
      icon: 'camera',
      run: actions.files.savePicture,
    },
  ];
}
