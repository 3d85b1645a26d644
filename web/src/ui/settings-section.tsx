import type { Preferences } from '../state/preferences.ts';
import { fillWords } from '../tools/tool-words.ts';
import { CommandButton, Section } from './controls.tsx';
import { usePage } from './page-context.ts';
import { text } from './text.ts';

/** What the search is asked for: preset, seed, single options. */
export function SettingsSection() {
  const { preferences } = usePage();
  const now = preferences.value;
  const change = (part: Partial<Preferences>) => {
    preferences.value = { ...preferences.peek(), ...part };
  };
  const badRow = now.advanced
    .split('\n')
    .find((row) => row.trim() !== '' && !/^\s*[^=\s]+\s*=\s*\S/.test(row));
  return (
    <Section title={text.settings.title}>
      <div class="settings">
        <label class="field">
          <span>{text.settings.preset}</span>
          <select
            value={now.preset}
            onChange={(event) => change({ preset: event.currentTarget.value })}
          >
            {Object.entries(text.settings.presets).map(([value, label]) => (
              <option key={value} value={value}>
                {label}
              </option>
            ))}
          </select>
        </label>
        <div class="field">
          <label for="seed">{text.settings.seed}</label>
          <div class="seed-row">
            <input
              id="seed"
              type="number"
              min="0"
              max={2 ** 31}
              step="1"
              value={now.seed}
              aria-describedby="seed-help"
              onChange={(event) => {
                const seed = Math.floor(Number(event.currentTarget.value));
                change({ seed: Number.isFinite(seed) ? Math.min(Math.max(seed, 0), 2 ** 31) : 1 });
              }}
            />
            <CommandButton id="newSeed" />
          </div>
          <p class="quiet" id="seed-help">
            {text.settings.seedHelp}
          </p>
        </div>
        <label class="field">
          <span>{text.settings.advanced}</span>
          <textarea
            rows={3}
            spellcheck={false}
            value={now.advanced}
            onChange={(event) => change({ advanced: event.currentTarget.value })}
          />
          <span class="quiet">
            {badRow ? fillWords(text.settings.badRow, { row: badRow }) : text.settings.advancedHelp}
          </span>
        </label>
      </div>
    </Section>
  );
}
