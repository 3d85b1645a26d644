import { useRef } from 'preact/hooks';
import { Keys } from './controls.tsx';
import { Icon } from './icon.tsx';
import { useOverflowCue } from './overflow-cue.ts';
import { usePage } from './page-context.ts';
import { text } from './text.ts';

type Tile = keyof typeof text.toolShort;

/** The commands of the rail, in groups. */
const GROUPS: readonly (readonly Tile[])[] = [
  ['select', 'line', 'rectangle', 'box', 'grid', 'hexagon'],
  ['joint', 'keepOut'],
  ['split', 'array', 'measure'],
  ['delete'],
];

/** The tools by their names, one of them in use, and delete. */
export function ToolRail() {
  const rail = useRef<HTMLDivElement>(null);
  useOverflowCue(rail);
  return (
    <section class="rail-frame" aria-label={text.app.tools}>
      <div
        ref={rail}
        class="tool-rail"
        role="toolbar"
        aria-label={text.app.tools}
        aria-orientation="vertical"
      >
        {GROUPS.map((group) => (
          <div class="rail-group" key={group[0]}>
            {group.map((tile) => (
              <RailTool key={tile} tile={tile} />
            ))}
          </div>
        ))}
      </div>
    </section>
  );
}

function RailTool({ tile }: { readonly tile: Tile }) {
  const { commands } = usePage();
  const command = commands.get(tile === 'delete' ? tile : `tool.${tile}`);
  return (
    <button
      type="button"
      class="rail-tool"
      aria-label={command.label}
      title={command.label}
      aria-pressed={command.checked?.()}
      disabled={command.when ? !command.when() : false}
      onClick={command.run}
    >
      <Icon name={command.icon} />
      <span>{text.toolShort[tile]}</span>
      {command.shortcut?.length === 1 ? <Keys shortcut={command.shortcut} /> : null}
    </button>
  );
}
