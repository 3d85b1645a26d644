/** The name of a record. Lists sort by their entries, and before them come plain texts. */
export type Key = string | readonly (string | number)[];

/** What is kept, as one transaction sees it. */
export interface Reading {
  get(key: Key): Promise<unknown>;
  /** All records whose key begins with this one, in the order of their keys. */
  under(prefix: Key): Promise<readonly KeptRecord[]>;
}

export interface KeptRecord {
  readonly key: Key;
  readonly value: unknown;
}

/** What a transaction may also do. Nothing of it is there before all of it is. */
export interface Writing extends Reading {
  put(key: Key, value: unknown): void;
  delete(key: Key): void;
  deleteUnder(prefix: Key): void;
}

/**
 * Where things are kept between visits: any structured value. All tabs of a browser share one store; no change of
 * another tab comes between what one transaction reads and what it writes. (Web Locks would give the same, but only in
 * a secure context, which a page served in one's own network is not.)
 */
export interface RecordStore {
  /** `work` may wait for its reads alone. */
  read<T>(work: (records: Reading) => Promise<T>): Promise<T>;
  /** All or nothing; settles when it is safe. Rejects when the browser refuses, as when the store is full. */
  change<T>(work: (records: Writing) => Promise<T>): Promise<T>;
}

const TABLE = 'values';

/** A store in IndexedDB; rejects where the browser has none, as in some private windows. */
export async function openBrowserStore(name: string): Promise<RecordStore> {
  let database: IDBDatabase | null = null;
  const open = async (): Promise<IDBDatabase> => {
    if (database === null) {
      database = await openDatabase(name);
      // The browser closes it when the person deletes what sites have stored.
      database.onclose = () => {
        database = null;
      };
    }
    return database;
  };
  await open();
  return {
    read: async (work) => transact(await open(), 'readonly', work),
    change: async (work) => transact(await open(), 'readwrite', work),
  };
}

function openDatabase(name: string): Promise<IDBDatabase> {
  const opening = indexedDB.open(name, 1);
  opening.onupgradeneeded = () => opening.result.createObjectStore(TABLE);
  return settled(opening);
}

/** Settles when a change is safe: when its transaction is complete, not when the requests are. */
async function transact<T>(
  database: IDBDatabase,
  mode: 'readonly' | 'readwrite',
  work: (records: Writing) => Promise<T>,
): Promise<T> {
  const transaction = database.transaction(TABLE, mode, { durability: 'strict' });
  const ended = new Promise<void>((resolve, reject) => {
    transaction.oncomplete = () => resolve();
    transaction.onabort = () => reject(transaction.error ?? new Error('given up'));
  });
  // Whoever waits for it is told; it may end before anybody does.
  ended.catch(() => undefined);
  try {
    const result = await work(recordsOf(transaction.objectStore(TABLE)));
    await ended;
    return result;
  } catch (error) {
    try {
      transaction.abort();
    } catch {
      // It has ended already.
    }
    throw transaction.error ?? error;
  }
}

function recordsOf(table: IDBObjectStore): Writing {
  return {
    get: (key) => settled(table.get(keyOf(key))),
    under: async (prefix) => {
      const range = rangeOf(prefix);
      const [keys, values] = await Promise.all([
        settled(table.getAllKeys(range)),
        settled(table.getAll(range)),
      ]);
      return keys.map((key, i) => ({ key: key as Key, value: values[i] as unknown }));
    },
    put: (key, value) => void table.put(value, keyOf(key)),
    delete: (key) => void table.delete(keyOf(key)),
    deleteUnder: (prefix) => void table.delete(rangeOf(prefix)),
  };
}

function keyOf(key: Key): IDBValidKey {
  return typeof key === 'string' ? key : [...key];
}

function rangeOf(prefix: Key): IDBKeyRange {
  return typeof prefix === 'string'
    ? IDBKeyRange.bound(prefix, `${prefix}\uffff`)
    : // A list sorts after every text and number.
      IDBKeyRange.bound([...prefix], [...prefix, []]);
}

function settled<T>(request: IDBRequest<T>): Promise<T> {
  return new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error);
  });
}

/** A store that forgets with the page: for tests, and where the browser keeps nothing. */
export function memoryStore(): RecordStore {
  let values: ReadonlyMap<string, KeptRecord> = new Map();
  let last: Promise<unknown> = Promise.resolve();
  const inTurn = <T>(work: () => Promise<T>): Promise<T> => {
    const turn = last.then(work, work);
    last = turn.catch(() => undefined);
    return turn;
  };
  const transaction = async <T>(work: (records: Writing) => Promise<T>): Promise<T> => {
    const draft = new Map(values);
    const result = await work(draftRecords(draft));
    values = draft;
    return result;
  };
  return {
    read: (work) => inTurn(() => transaction(work)),
    change: (work) => inTurn(() => transaction(work)),
  };
}

function draftRecords(draft: Map<string, KeptRecord>): Writing {
  const under = (prefix: Key): KeptRecord[] =>
    [...draft.values()]
      .filter(({ key }) => isUnder(key, prefix))
      .sort((a, b) => compareKeys(a.key, b.key));
  return {
    get: async (key) => structuredClone(draft.get(JSON.stringify(key))?.value),
    under: async (prefix) => structuredClone(under(prefix)),
    put: (key, value) => draft.set(JSON.stringify(key), { key, value: structuredClone(value) }),
    delete: (key) => draft.delete(JSON.stringify(key)),
    deleteUnder: (prefix) => {
      for (const { key } of under(prefix)) {
        draft.delete(JSON.stringify(key));
      }
    },
  };
}

function isUnder(key: Key, prefix: Key): boolean {
  if (typeof key === 'string' || typeof prefix === 'string') {
    return typeof key === 'string' && typeof prefix === 'string' && key.startsWith(prefix);
  }
  return prefix.every((part, i) => key[i] === part);
}

/** Of two keys under one prefix. */
function compareKeys(a: Key, b: Key): number {
  const k = [...a].findIndex((part, i) => part !== b[i]);
  const [left, right] = [a[k], b[k]];
  if (left === undefined || right === undefined) {
    return a.length - b.length;
  }
  return left < right ? -1 : 1;
}
