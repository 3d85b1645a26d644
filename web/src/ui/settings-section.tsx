import type { Preferences } from '../state/preferences.ts';
import { fillWords } from '../tools/tool-words.ts';
import { CommandButton, Section, Segmented } from './controls.tsx';
import { usePage } from './page-context.ts';
import { PresetPicture } from './preset-picture.tsx';
import { text } from './text.ts';

type Change = (part: Partial<Preferences>) => void;

const EFFORTS = { quick: 0.3, usual: 1, thorough: 4 } as const;
type EffortName = keyof typeof EFFORTS;

/** What the search is asked for: preset, bricks, effort, seed, single options. */
export function SettingsSection() {
  const { preferences } = usePage();
  const change: Change = (part) => {
    preferences.value = { ...preferences.peek(), ...part };
  };
  return (
    <Section title={text.settings.title}>
      <div class="settings">
        <OwnSettings />
        <PresetChoice change={change} />
        <BrickChoice />
        <EffortChoice change={change} />
        <SeedField change={change} />
        <AdvancedField change={change} />
      </div>
    </Section>
  );
}

/** Said where a link brought other settings than the person's own. */
function OwnSettings() {
  const { ownSettings, dropOwnSettings } = usePage();
  return ownSettings.value ? (
    <div class="field" role="note">
      <span class="quiet">{text.settings.ofSketch}</span>
      <button type="button" class="button secondary" onClick={dropOwnSettings}>
        {text.settings.useMine}
      </button>
    </div>
  ) : null;
}

function PresetChoice({ change }: { readonly change: Change }) {
  const { preset } = usePage().preferences.value;
  return (
    <fieldset class="presets">
      <legend>{text.settings.preset}</legend>
      {Object.entries(text.settings.presets).map(([value, label]) => (
        <label key={value} class="preset">
          <input
            type="radio"
            name="preset"
            checked={preset === value}
            onChange={() => change({ preset: value })}
          />
          <PresetPicture preset={value} />
          <span>{label}</span>
        </label>
      ))}
    </fieldset>
  );
}

function BrickChoice() {
  const { off, owned } = usePage().preferences.value;
  const counted = Object.keys(owned).length;
  const some = off.length + counted > 0;
  return (
    <div class="field">
      <span>{text.settings.bricks}</span>
      <CommandButton
        id="bricks"
        words={
          some
            ? fillWords(text.settings.bricksSome, { off: off.length, counted })
            : text.settings.bricksAll
        }
        class="secondary"
      />
    </div>
  );
}

function EffortChoice({ change }: { readonly change: Change }) {
  const { effort } = usePage().preferences.value;
  const names = Object.keys(EFFORTS) as EffortName[];
  const now = [...names].reverse().find((name) => EFFORTS[name] <= effort) ?? 'quick';
  return (
    <div class="field">
      <span>{text.settings.effort}</span>
      <Segmented
        name="effort"
        legend={text.settings.effort}
        choices={names.map((value) => ({ value, label: text.settings.efforts[value] }))}
        value={now}
        onChange={(name) => change({ effort: EFFORTS[name] })}
      />
    </div>
  );
}

function SeedField({ change }: { readonly change: Change }) {
  const { seed } = usePage().preferences.value;
  return (
    <div class="field">
      <label for="seed">{text.settings.seed}</label>
      <div class="seed-row">
        <input
          id="seed"
          type="number"
          min="0"
          max={2 ** 31}
          step="1"
          value={seed}
          aria-describedby="seed-help"
          onChange={(event) => {
            const typed = Math.floor(Number(event.currentTarget.value));
            change({ seed: Number.isFinite(typed) ? Math.min(Math.max(typed, 0), 2 ** 31) : 1 });
          }}
        />
        <CommandButton id="newSeed" />
      </div>
      <p class="quiet" id="seed-help">
        {text.settings.seedHelp}
      </p>
    </div>
  );
}

function AdvancedField({ change }: { readonly change: Change }) {
  const { advanced } = usePage().preferences.value;
  const badRow = advanced
    .split('\n')
    .find((row) => row.trim() !== '' && !/^\s*[^=\s]+\s*=\s*\S/.test(row));
  return (
    <details class="advanced" open={advanced !== ''}>
      <summary>{text.settings.advanced}</summary>
      <label class="field">
        <span class="visually-hidden">{text.settings.advanced}</span>
        <textarea
          rows={3}
          spellcheck={false}
          value={advanced}
          onChange={(event) => change({ advanced: event.currentTarget.value })}
        />
        <span class="quiet">
          {badRow ? fillWords(text.settings.badRow, { row: badRow }) : text.settings.advancedHelp}
        </span>
      </label>
    </details>
  );
}
