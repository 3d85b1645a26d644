/** Where things are kept between visits: asynchronous, by key, any structured value. */
export interface KeyValueStore {
  get(key: string): Promise<unknown>;
  /** Rejects when the browser refuses, for example because the store is full. */
  set(key: string, value: unknown): Promise<void>;
  delete(key: string): Promise<void>;
}

const TABLE = 'values';

/** A store in IndexedDB; rejects where the browser has none, as in some private windows. */
export async function openBrowserStore(name: string): Promise<KeyValueStore> {
  const opening = indexedDB.open(name, 1);
  opening.onupgradeneeded = () => opening.result.createObjectStore(TABLE);
  const database = await settled(opening);
  return {
    get: (key) => settled(database.transaction(TABLE, 'readonly').objectStore(TABLE).get(key)),
    set: (key, value) => written(database, (table) => table.put(value, key)),
    delete: (key) => written(database, (table) => table.delete(key)),
  };
}

/** A store that forgets with the page: for tests, and where the browser keeps nothing. */
export function memoryStore(): KeyValueStore {
  const values = new Map<string, unknown>();
  return {
    get: async (key) => values.get(key),
    set: async (key, value) => {
      values.set(key, structuredClone(value));
    },
    delete: async (key) => {
      values.delete(key);
    },
  };
}

function settled<T>(request: IDBRequest<T>): Promise<T> {
  return new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error);
  });
}

/** Settles when a change is safe: when its transaction is complete, not when the request is. */
function written(
  database: IDBDatabase,
  change: (table: IDBObjectStore) => IDBRequest,
): Promise<void> {
  return new Promise((resolve, reject) => {
    const transaction = database.transaction(TABLE, 'readwrite', { durability: 'strict' });
    change(transaction.objectStore(TABLE));
    transaction.oncomplete = () => resolve();
    transaction.onerror = () => reject(transaction.error);
    transaction.onabort = () => reject(transaction.error);
  });
}
