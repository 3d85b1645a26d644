// Two tabs of one browser at work at once, one of them killed at a random moment; and what must be true after it.
import type { BrowserContext, Page } from '@playwright/test';
import { readHeads, readKept } from '../../web/src/state/sketch-records.ts';
import { type KeptRecord, memoryStore } from '../../web/src/state/storage.ts';
import { withoutDrawing } from './test.ts';

const LINES = [
  { from: [0, 0, 0], to: [4, 0, 0] },
  { from: [4, 0, 0], to: [4, 3, 0] },
];
const OPERATIONS = 6;
/** A tab is killed within so many milliseconds, about the time that its operations take. */
const KILL_WITHIN = 900;

export interface StormResult {
  readonly rounds: number;
  readonly kills: number;
  readonly edits: number;
  /** Those that a tab has said are kept. */
  readonly safe: number;
  readonly sketches: number;
}

/** Whole numbers from 0, seeded, so that a storm can be had again as far as the machine allows. */
export function dice(seed: number): (sides: number) => number {
  let state = seed;
  return (sides) => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return (state >>> 8) % sides;
  };
}

export class Storm {
  readonly #context: BrowserContext;
  readonly #roll: (sides: number) => number;
  /** Names that a tab has said are kept: the marks of edits. */
  readonly #safe = new Set<string>();
  readonly #errors: string[] = [];
  #tabs: Page[] = [];
  #names = 0;
  #kills = 0;
  #edits = 0;

  constructor(context: BrowserContext, seed: number) {
    this.#context = context;
    this.#roll = dice(seed);
  }

  async run(rounds: number): Promise<StormResult> {
    await this.#context.addInitScript(withoutDrawing);
    await this.#context.addInitScript(() => {
      localStorage.setItem('liftarm/preferences', JSON.stringify({ autoSolve: false }));
    });
    this.#tabs = await Promise.all([this.#open(), this.#open()]);
    let heads = 0;
    for (let round = 1; round <= rounds; round++) {
      await this.#round();
      heads = await this.#check(round);
    }
    return {
      rounds,
      kills: this.#kills,
      edits: this.#edits,
      safe: this.#safe.size,
      sketches: heads,
    };
  }

  async #open(): Promise<Page> {
    const page = await this.#context.newPage();
    page.on('pageerror', (error) => this.#errors.push(error.stack ?? error.message));
    await page.goto('./');
    await page.waitForFunction(() => document.documentElement.dataset['kept'] === 'kept');
    return page;
  }

  async #round(): Promise<void> {
    const victim = this.#roll(3);
    const delay = this.#roll(KILL_WITHIN);
    const work = this.#tabs.map((page, i) => {
      const done = this.#work(page, i);
      return i === victim ? done.catch(() => undefined) : done;
    });
    if (victim < this.#tabs.length) {
      await new Promise((resolve) => setTimeout(resolve, delay));
      await this.#kill(victim);
    }
    await Promise.all(work);
    if (victim < this.#tabs.length) {
      this.#tabs[victim] = await this.#open();
    }
  }

  /** As if its process had died: nothing of the page runs any more. */
  async #kill(i: number): Promise<void> {
    const page = this.#tabs[i];
    if (!page) {
      return;
    }
    this.#kills += 1;
    const crashed = page.waitForEvent('crash');
    const client = await this.#context.newCDPSession(page);
    client.send('Page.crash').catch(() => undefined);
    await crashed;
    await page.close();
  }

  async #work(page: Page, i: number): Promise<void> {
    const waiting: string[] = [];
    for (let n = 0; n < OPERATIONS; n++) {
      const name = `mark-${this.#names++}-of-tab-${i}`;
      await this.#operation(page);
      // What another tab does at this moment may come first; then there is no such edit.
      if (await page.evaluate(renameNow, name)) {
        this.#edits += 1;
        waiting.push(name);
      }
      if (this.#roll(2) === 0 || n === OPERATIONS - 1) {
        await page.waitForFunction(() => document.documentElement.dataset['kept'] === 'kept');
        for (const known of waiting) {
          this.#safe.add(known);
        }
      }
    }
  }

  async #operation(page: Page): Promise<void> {
    switch (this.#roll(6)) {
      case 0:
        // Another sketch, in the library beside the others.
        await page.evaluate(dropSketch, { name: `dropped-${this.#names++}`, lines: LINES });
        return;
      case 1:
        await page.keyboard.press('Control+a');
        await page.keyboard.press('ArrowRight');
        return;
      case 2:
        await page.keyboard.press('Control+a');
        await page.keyboard.press('Control+c');
        await page.keyboard.press('Control+v');
        return;
      default:
    }
  }

  /** @returns how many sketches are kept. */
  async #check(round: number): Promise<number> {
    const [page] = this.#tabs;
    if (!page) {
      throw new Error('no tab');
    }
    const records = (await page.evaluate(allRecords)) as KeptRecord[];
    const text = JSON.stringify(records);
    const lost = [...this.#safe].filter((name) => !text.includes(`"${name}"`));
    const store = memoryStore();
    await store.change(async (writing) => {
      for (const { key, value } of records) {
        writing.put(key, value);
      }
    });
    const heads = await store.read(readHeads);
    const kept = await Promise.all(
      heads.map(({ id }) => store.read((reading) => readKept(reading, id))),
    );
    const damaged = kept.filter((one) => !one?.whole).length;
    if (lost.length > 0 || damaged > 0 || this.#errors.length > 0) {
      const list = [...lost, ...this.#errors].join('\n');
      throw new Error(`round ${round}: ${damaged} damaged, lost or thrown:\n${list}`);
    }
    return heads.length;
  }
}

/** Runs in the page: a name is typed and taken. @returns whether it is the sketch's then. */
function renameNow(name: string): boolean {
  const field = document.querySelector<HTMLInputElement>('input[aria-label="Name of the sketch"]');
  if (field) {
    field.value = name;
    field.dispatchEvent(new Event('change', { bubbles: true }));
  }
  return document.title.startsWith(name);
}

/** Runs in the page: a file is dropped on it. */
function dropSketch({ name, lines }: { name: string; lines: unknown }): void {
  const sketch = { format: 'technic-sketch', version: 1, name, lines };
  const transfer = new DataTransfer();
  transfer.items.add(new File([JSON.stringify(sketch)], 'a.json', { type: 'application/json' }));
  document
    .querySelector('.stage')
    ?.dispatchEvent(new DragEvent('drop', { dataTransfer: transfer, bubbles: true }));
}

/** Runs in the page: all that the browser keeps for it. */
async function allRecords(): Promise<unknown[]> {
  const done = <T>(request: IDBRequest<T>) =>
    new Promise<T>((resolve, reject) => {
      request.onsuccess = () => resolve(request.result);
      request.onerror = () => reject(request.error);
    });
  const database = await done(indexedDB.open('liftarm'));
  const table = database.transaction('values').objectStore('values');
  const [keys, values] = await Promise.all([done(table.getAllKeys()), done(table.getAll())]);
  database.close();
  return keys.map((key, i) => ({ key, value: values[i] as unknown }));
}
