import { language } from './language.ts';

// What the core and the readers of files say is one English sentence: the place, what is wrong, what
// would be right. They do not know the interface's language. Here such a sentence is told by its English
// form, as gettext does, and said again in the language in use.

/** English form and its translation; `{name}` stands for a value, which may be a sentence or a phrase itself. */
export type Sentences = readonly (readonly [english: string, other: string])[];

/** Says an English sentence of the core or of a reader in another language. */
export type Interpreter = (sentence: string) => string;

const VALUE = /\{(\w+)\}/g;
/** `lines[3].from: ...`: where it is wrong, then what. */
const PLACE = /^([A-Za-z[][\w.[\]-]*): (.+)$/s;
const MAX_DEPTH = 6;

interface Forms {
  readonly whole: ReadonlyMap<string, string>;
  readonly patterns: readonly { readonly pattern: RegExp; readonly other: string }[];
}

/**
 * An interpreter over a table of sentences, and one of phrases that stand in their values only. What is in
 * no table comes back as it was: better in English than not at all.
 */
export function makeInterpreter(sentences: Sentences, phrases: Sentences): Interpreter {
  const outer = formsOf(sentences);
  const inner = formsOf([...sentences, ...phrases]);

  function say(sentence: string, depth: number): string {
    const { whole, patterns } = depth === 0 ? outer : inner;
    const known = whole.get(sentence);
    if (known !== undefined || depth > MAX_DEPTH) {
      return known ?? sentence;
    }
    for (const { pattern, other } of patterns) {
      const values = pattern.exec(sentence)?.groups;
      if (values) {
        return other.replace(VALUE, (_, name: string) => say(values[name] ?? '', depth + 1));
      }
    }
    const place = PLACE.exec(sentence);
    return place ? `${place[1]}: ${say(place[2] ?? '', depth + 1)}` : sentence;
  }
  return (sentence) => say(sentence, 0);
}

function formsOf(table: Sentences): Forms {
  return {
    whole: new Map(table.filter(([english]) => !english.includes('{'))),
    patterns: table
      .filter(([english]) => english.includes('{'))
      .map(([english, other]) => ({ pattern: patternOf(english), other })),
  };
}

/** A form as a regular expression with a named group for each value, as short as they can be. */
function patternOf(english: string): RegExp {
  const source = english
    .split(VALUE)
    .map((piece, i) =>
      i % 2 === 0 ? piece.replace(/[.*+?^${}()|[\]\\]/g, '\\$&') : `(?<${piece}>.+?)`,
    )
    .join('');
  return new RegExp(`^${source}$`, 's');
}

let interpreter: Interpreter | null = null;

/** Fetches the table of the language in use. Until it is there, or where it is missing, sentences stay English. */
export async function loadSentences(): Promise<void> {
  if (language !== 'de') {
    return;
  }
  try {
    const { PHRASES_DE, SENTENCES_DE } = await import('./de/sentences.ts');
    interpreter = makeInterpreter(SENTENCES_DE, PHRASES_DE);
  } catch {
    interpreter = null;
  }
}

/** A sentence of the core or of a reader, in the language in use. */
export function inWords(sentence: string): string {
  return interpreter ? interpreter(sentence) : sentence;
}
