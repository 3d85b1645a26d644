// The page without a network. The build puts in the list of files and a version that changes with them.
// A new version is fetched in the background and waits until the page says that it may take over.

/* global self, caches */
const VERSION = '__VERSION__';
/** Needed to draw and to generate: fetched together; without any of them the version is not installed. */
const CORE_FILES = ['__CORE_FILES__'];
/** Rooms, pictures, examples: fetched afterwards, one by one; what is missing is fetched when asked for. */
const OTHER_FILES = ['__OTHER_FILES__'];
const CACHE = `liftarm-${VERSION}`;
const PREFIX = 'liftarm-';

self.addEventListener('install', (event) => {
  // The files' names carry their content, but index.html does not: never take it from the HTTP cache.
  const fresh = (file) => new Request(file, { cache: 'no-cache' });
  event.waitUntil(caches.open(CACHE).then((cache) => cache.addAll(CORE_FILES.map(fresh))));
});

self.addEventListener('activate', (event) => {
  event.waitUntil(
    caches
      .keys()
      .then((names) =>
        Promise.all(
          names
            .filter((name) => name.startsWith(PREFIX) && name !== CACHE)
            .map((name) => caches.delete(name)),
        ),
      )
      .then(() => self.clients.claim()),
  );
});

self.addEventListener('message', (event) => {
  if (event.data === 'take-over') {
    self.skipWaiting();
  }
  if (event.data === 'fetch-the-rest') {
    event.waitUntil(fetchTheRest());
  }
});

self.addEventListener('fetch', (event) => {
  const { request } = event;
  if (request.method === 'GET' && new URL(request.url).origin === self.location.origin) {
    event.respondWith(answer(request));
  }
});

async function fetchTheRest() {
  const cache = await caches.open(CACHE);
  for (const file of OTHER_FILES) {
    if (!(await cache.match(file))) {
      await cache.add(file).catch(() => undefined);
    }
  }
}

/** Room, language and the like stand behind the question mark; the file is the same. */
async function answer(request) {
  const cache = await caches.open(CACHE);
  const url = new URL(request.url);
  const file = url.pathname.endsWith('/') ? `${url.origin}${url.pathname}index.html` : request.url;
  const kept = await cache.match(file, { ignoreSearch: true });
  if (kept) {
    return kept;
  }
  const reply = await fetch(request);
  if (reply.ok && reply.type === 'basic') {
    await cache.put(url.origin + url.pathname, reply.clone());
  }
  return reply;
}
