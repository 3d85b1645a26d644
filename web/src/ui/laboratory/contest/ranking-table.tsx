import Papa from 'papaparse';
import { fillWords } from '../../../tools/tool-words.ts';
import { pageFolder } from '../../share/page-link.ts';
import { saveFile } from '../../share/save-file.ts';
import { formatNumber } from '../../text/language.ts';
import { inWords } from '../../text/sentences.ts';
import { contestWords as words } from './contest-words.ts';
import { type Judged, type Ranked, ranked } from './ranking.ts';

/** Best first; what is wrong stands out. */
export function RankingTable({ judged }: { readonly judged: readonly Judged[] }) {
  const rows = ranked(judged);
  const save = () => {
    const cells = rows.map(({ place, entry, score, ...row }) => ({
      place: place ?? '',
      name: entry.name,
      score: score ?? '',
      claimed: entry.claimed ?? '',
      note: noteOf({ place, entry, score, ...row }),
    }));
    saveFile('ranking.csv', new Blob([`${Papa.unparse(cells)}\n`], { type: 'text/csv' }));
  };
  return (
    <section>
      <h3>{words.ranking}</h3>
      {/* biome-ignore lint/a11y/noNoninteractiveTabindex: what scrolls must be reached by the keys */}
      <section class="compare-scroll" tabIndex={0} aria-label={words.ranking}>
        <table class="compare ranking">
          <thead>
            <tr>
              {[words.place, words.name, words.score, words.claimed, words.note].map((title) => (
                <th key={title} scope="col">
                  {title}
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {rows.map((row, i) => (
              <tr key={i} data-wrong={row.wrongClaim || undefined}>
                <td>{row.place ?? '–'}</td>
                <th scope="row">
                  <EntryName row={row} />
                </th>
                <td>{row.score === null ? '–' : shown(row.score)}</td>
                <td>{row.entry.claimed === null ? '–' : shown(row.entry.claimed)}</td>
                <td class={row.wrongClaim || row.fault ? 'short' : ''}>{noteOf(row)}</td>
              </tr>
            ))}
          </tbody>
        </table>
      </section>
      <div class="lab-row">
        <button type="button" class="button" onClick={save}>
          {words.saveCsv}
        </button>
      </div>
    </section>
  );
}

function EntryName({ row: { entry, fault } }: { readonly row: Ranked }) {
  const { name, fragment } = entry;
  return fragment === null || fault === 'broken' ? (
    <span>{name}</span>
  ) : (
    <a
      href={`${pageFolder(location.href)}#${fragment}`}
      target="_blank"
      rel="noopener"
      aria-label={fillWords(words.open, { name })}
    >
      {name}
    </a>
  );
}

function noteOf({ entry, score, fault, detail, wrongClaim }: Ranked): string {
  const why = fault ? fillWords(words.faults[fault], { detail: inWords(detail) }) : '';
  if (!wrongClaim) {
    return why;
  }
  const claimed = shown(entry.claimed ?? 0);
  const wrong =
    score === null
      ? fillWords(words.wrongNone, { claimed })
      : fillWords(words.wrong, { claimed, score: shown(score) });
  return [why, wrong].filter((text) => text !== '').join('. ');
}

function shown(value: number): string {
  return formatNumber(value, Number.isInteger(value) ? 0 : 2);
}
