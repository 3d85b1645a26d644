import type { SketchDocument } from '../model/sketch.ts';
import type { Language } from '../state/preferences.ts';
import { readSketchValue } from '../state/read-sketch.ts';
import type { Example } from '../ui/page.ts';
import { inLanguage, language } from '../ui/text/language.ts';

/** Reads JSON from beside the page; null when it is not there. */
type FetchJson = (path: string) => Promise<unknown>;

/** The examples in the order of their index. One that cannot be read is left out. */
export async function loadExamples(fetchJson: FetchJson): Promise<Example[]> {
  const index = await fetchJson('examples/index.json');
  const rows = entriesOf(index, language);
  const loaded = await Promise.all(rows.map((row) => loadExample(row, fetchJson)));
  return loaded.filter((example) => example !== null);
}

/** The first of them alone: what a first visit begins with. */
export async function loadFirstExample(
  fetchJson: FetchJson,
  wanted: Language,
): Promise<Example | null> {
  const [row] = entriesOf(await fetchJson('examples/index.json'), wanted);
  return row ? loadExample(row, fetchJson) : null;
}

/** The sketch of an example under the name that its list gives it. */
export function namedSketch(example: Example): SketchDocument {
  return { ...example.sketch, name: example.title };
}

interface IndexRow {
  readonly file: string;
  readonly title: string;
  readonly description: string;
}

async function loadExample(row: IndexRow, fetchJson: FetchJson): Promise<Example | null> {
  const sketch = readSketchValue(await fetchJson(`examples/${row.file}`));
  return sketch.ok ? { ...row, sketch: sketch.value } : null;
}

function entriesOf(index: unknown, wanted: Language): IndexRow[] {
  const list =
    typeof index === 'object' && index !== null && 'examples' in index ? index.examples : index;
  if (!Array.isArray(list)) {
    return [];
  }
  return list.flatMap((entry: unknown) => {
    const row = rowOf(entry, wanted);
    return row ? [row] : [];
  });
}

function rowOf(entry: unknown, wanted: Language): IndexRow | null {
  if (typeof entry !== 'object' || entry === null) {
    return null;
  }
  const { file, name, description } = entry as Record<string, unknown>;
  if (typeof file !== 'string' || !/^[\w-]+(\.[\w-]+)*\.json$/.test(file)) {
    return null;
  }
  return {
    file,
    title: inLanguage(name, wanted) || file,
    description: inLanguage(description, wanted),
  };
}
