import { useState } from 'preact/hooks';
import { SET_PARTS } from '../model/brick-set.ts';
import type { OddRow } from '../model/parts-list.ts';
import { fillWords } from '../tools/tool-words.ts';
import type { OwnedList } from './page.ts';
import { usePage } from './page-context.ts';
import { partName } from './text/part-names.ts';
import { text } from './text.ts';

const SHOWN_ODD = 20;

/** What was understood of a list of parts and what was not, before anything is taken from it. */
export function OwnedPreview({ read }: { readonly read: OwnedList }) {
  const { ownedList, preferences, catalogue, announce } = usePage();
  const [complete, setComplete] = useState(false);
  const { counts, rows, odd } = read.list;
  const taken = SET_PARTS.flatMap((id): [string, number][] => {
    const count = counts.get(id);
    return count === undefined ? (complete ? [[id, 0]] : []) : [[id, count]];
  });
  const n = taken.filter(([, count]) => count > 0).length;
  const close = () => {
    ownedList.value = null;
  };
  const take = () => {
    const before = complete ? {} : preferences.peek().owned;
    preferences.value = {
      ...preferences.peek(),
      owned: { ...before, ...Object.fromEntries(taken) },
    };
    announce(fillWords(text.bricks.imported, { n, name: read.name }));
    close();
  };
  return (
    <div class="owned-preview">
      <h3>{fillWords(text.bricks.read, { name: read.name })}</h3>
      <p role="status">
        {odd.length === rows
          ? text.bricks.readNone
          : fillWords(text.bricks.readRows, { n: rows - odd.length, all: rows })}
      </p>
      <OddRows odd={odd} />
      {counts.size > 0 ? (
        <table class="parts">
          <thead class="visually-hidden">
            <tr>
              <th scope="col">{text.result.count}</th>
              <th scope="col">{text.result.part}</th>
            </tr>
          </thead>
          <tbody>
            {[...counts].map(([id, count]) => (
              <tr key={id}>
                <td class="count">{count}×</td>
                <td>
                  {partName(id, catalogue)} <span class="quiet">{id}</span>{' '}
                  {SET_PARTS.includes(id) ? null : (
                    <span class="quiet">({text.bricks.unused})</span>
                  )}
                </td>
              </tr>
            ))}
          </tbody>
        </table>
      ) : null}
      <label class="check-row">
        <input
          type="checkbox"
          checked={complete}
          onChange={(event) => setComplete(event.currentTarget.checked)}
        />
        <span>{text.bricks.complete}</span>
      </label>
      <div class="dialog-bar">
        <button type="button" class="button primary" disabled={n === 0} onClick={take}>
          {text.bricks.take}
        </button>
        <button type="button" class="button secondary" onClick={close}>
          {text.bricks.back}
        </button>
      </div>
    </div>
  );
}

function OddRows({ odd }: { readonly odd: readonly OddRow[] }) {
  const more = odd.length - SHOWN_ODD;
  return odd.length === 0 ? null : (
    <details open={true}>
      <summary>{text.bricks.readOdd}</summary>
      <ul>
        {odd.slice(0, SHOWN_ODD).map(({ row, text: said, why }) => (
          <li key={row}>
            {fillWords(text.bricks.readRow, { n: row, text: said })}{' '}
            <span class="quiet">
              ({why === 'part' ? text.bricks.whyPart : text.bricks.whyCount})
            </span>
          </li>
        ))}
        {more > 0 ? <li>{fillWords(text.bricks.readMore, { n: more })}</li> : null}
      </ul>
    </details>
  );
}
