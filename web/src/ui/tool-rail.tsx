import { CommandButton } from './controls.tsx';
import { usePage } from './page-context.ts';
import { text } from './text.ts';

/** The commands of the rail, in groups. */
const GROUPS: readonly (readonly string[])[] = [
  ['tool.select', 'tool.line', 'tool.rectangle', 'tool.box', 'tool.grid', 'tool.hexagon'],
  ['tool.split', 'tool.array', 'tool.measure'],
  ['tool.joint', 'tool.keepOut'],
];

/** The tools, one of them in use, and delete. */
export function ToolRail() {
  const { commands } = usePage();
  return (
    <div class="tool-rail" role="toolbar" aria-label={text.app.tools} aria-orientation="vertical">
      {GROUPS.map((group, i) => (
        <div class="rail-group" key={commands.get(group[0] ?? '').id} data-group={i}>
          {group.map((id) => (
            <CommandButton key={id} id={id} />
          ))}
        </div>
      ))}
      <div class="rail-group">
        <CommandButton id="delete" />
      </div>
    </div>
  );
}
