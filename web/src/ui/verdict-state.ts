import { shortages } from '../model/brick-set.ts';
import { countGuests } from '../model/guests.ts';
import type { WellBuiltItem } from '../model/report.ts';
import { type FirstWrong, type Lamp, type LampState, verdictOf } from '../model/verdict.ts';
import { isLoud, type SketchFault } from '../state/sketch-faults.ts';
import { fillWords } from '../tools/tool-words.ts';
import { faultSentence, placesInWords } from './fault-words.ts';
import type { Page, ResultState } from './page.ts';
import { formatNumber } from './text/language.ts';
import { inWords } from './text/sentences.ts';
import { text } from './text.ts';

/** What the card at the head of the panel says. */
export interface CardState {
  readonly tone: LampState;
  readonly title: string;
  /** One sentence. */
  readonly words: string;
  /** What is wrong first in a finished model or in the drawing; null where nothing is, or is not known. */
  readonly first: FirstWrong | null;
  readonly lamps: readonly Lamp[];
  /** It is about a finished model. */
  readonly final: boolean;
}

const LAMPS = ['buildable', 'stands', 'moves'] as const;

/** The one verdict on what is on screen: drawing, search and model together. Reads signals. */
export function cardState(page: Page): CardState {
  const { phase, message } = page.solve.value;
  const shown = page.result.value;
  if (phase === 'solving') {
    return unfinished('busy', text.verdict.solving, searchWords(page));
  }
  const fault = page.faults.value.find(isLoud);
  if (fault) {
    return faulty(page, shown, fault);
  }
  if (phase === 'refused' || phase === 'failed') {
    const title = phase === 'refused' ? text.verdict.fault : text.verdict.bad;
    return { ...unfinished('bad', title, message), lamps: allLamps('bad') };
  }
  if (!shown?.final) {
    return unfinished('none', text.result.noModel, noModelWords(page));
  }
  return page.stale.value ? stale(page) : finished(page, shown);
}

function unfinished(tone: LampState, title: string, words: string): CardState {
  const lamps = allLamps(tone === 'busy' ? 'busy' : 'none');
  return { tone, title, words, first: null, lamps, final: false };
}

function allLamps(buildable: LampState): Lamp[] {
  const rest: LampState = buildable === 'busy' ? 'busy' : 'none';
  return LAMPS.map((id) => ({ id, state: id === 'buildable' ? buildable : rest }));
}

/** Lines that look joined and are not come first; how bad that is, the model made of them says. */
function faulty(page: Page, shown: ResultState | null, fault: SketchFault): CardState {
  const judged = shown?.final && !page.stale.value ? judge(page, shown) : null;
  const refused = page.solve.value.phase === 'refused';
  const bad = refused || judged?.tone === 'bad';
  const { verdict } = text;
  return {
    tone: bad ? 'bad' : 'warn',
    title: bad ? verdict.fault : judged ? verdict.apart : verdict.look,
    words: faultSentence(fault),
    first: { kind: 'fault' },
    lamps: judged?.lamps ?? allLamps(bad ? 'bad' : 'warn'),
    final: shown?.final === true,
  };
}

function stale(page: Page): CardState {
  const coming = page.preferences.value.autoSolve && page.small.value;
  const { verdict } = text;
  const ofParts = page.staleBy.value === 'parts';
  const past = ofParts ? verdict.stalePartsText : verdict.staleText;
  return {
    tone: 'none',
    title: ofParts ? verdict.staleParts : verdict.stale,
    words: coming ? verdict.staleAuto : past,
    first: null,
    lamps: allLamps(coming ? 'busy' : 'none'),
    final: true,
  };
}

function finished(page: Page, shown: ResultState): CardState {
  const { tone, lamps, first } = judge(page, shown);
  const ofFile = shown.source === 'file' ? text.verdict.file : text.verdict.okText;
  const [title, words] = first === null ? [text.verdict.ok, ofFile] : wordsFor(first);
  const guests = guestsOn(page);
  const more = guests > 0 && tone === 'bad' ? ` ${guestWords(guests)}` : '';
  return { tone, title, words: words + more, first, lamps, final: true };
}

function judge(page: Page, shown: ResultState) {
  const { report } = shown;
  const short = shortages(shown.rows, page.preferences.value.owned);
  const sketch = page.shown.value?.sketch;
  return verdictOf({
    faults: page.faults.value.filter(isLoud).length,
    buildable: shown.buildable,
    items: shown.items,
    problems: shown.problems,
    pieces: report.pieces ?? 1,
    missing: [...short.values()].reduce((sum, n) => sum + n, 0),
    guests: guestsOn(page),
    stands: report.balanced,
    joints: sketch?.joints?.length ?? 0,
    wellBuilt: report.wellBuilt?.items,
  });
}

/** Parts of the model on screen that were not judged. */
function guestsOn(page: Page): number {
  const model = page.shown.value?.model;
  return model ? countGuests(model) : 0;
}

function guestWords(n: number): string {
  const { verdict } = text;
  return n === 1 ? verdict.guestOne : fillWords(verdict.guestsText, { n });
}

function wordsFor(first: FirstWrong): readonly [title: string, words: string] {
  const { verdict } = text;
  switch (first.kind) {
    case 'fault':
      return [verdict.fault, ''];
    case 'problem':
      return [verdict.bad, placesInWords(inWords(first.problem.message))];
    case 'item':
      return [verdict.bad, itemWords(first.item.title)];
    case 'guests':
      return [verdict.guests, guestWords(first.count)];
    case 'missing':
      return [
        verdict.missing,
        first.count === 1 ? verdict.missingOne : fillWords(verdict.missingText, { n: first.count }),
      ];
    case 'pieces':
      return [fillWords(verdict.pieces, { n: first.count }), verdict.piecesText];
    case 'falls':
      return [verdict.falls, verdict.fallsText];
    case 'wellBuilt':
      return [verdict.wellBuilt, shortfall(first.item)];
  }
}

/** What a builder would expect, and by how much the model falls short of it. */
function shortfall({ title, detail }: WellBuiltItem): string {
  const what = sentence(itemWords(title));
  return detail ? `${what} ${sentence(inWords(detail))}` : what;
}

function itemWords(title: string): string {
  return title === ''
    ? text.verdict.badText
    : fillWords(text.verdict.failedItem, { what: inWords(title) });
}

/** With a capital and a full stop: problems are said as parts of a sentence. */
function sentence(words: string): string {
  const begun = words.charAt(0).toUpperCase() + words.slice(1);
  return /[.!?…]$/.test(begun) ? begun : `${begun}.`;
}

function searchWords({ solve }: Page): string {
  const { progress } = solve.value;
  if (!progress) {
    return text.solve.starting;
  }
  const phase = text.solve.phase[progress.phase] ?? progress.phase;
  return `${phase}: ${formatNumber(progress.iterations)} ${text.solve.iterations}`;
}

function noModelWords({ preferences, small, store }: Page): string {
  const drawn = store.sketch.value.lines.length > 0;
  if (preferences.value.autoSolve && small.value) {
    return text.result.noModelAuto;
  }
  return drawn && preferences.value.autoSolve ? text.solve.autoOff : text.result.noModelText;
}
