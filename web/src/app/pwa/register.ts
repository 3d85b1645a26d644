import { chooseWords } from '../../ui/text/language.ts';
import { SETTLED } from '../first-model.ts';
import '../../../styles/update.css';

const WORDS = chooseWords(
  {
    ready: 'A new version is ready. Your sketch is kept.',
    reload: 'Reload',
    later: 'Later',
  } as const,
  { ready: 'Eine neue Version ist da. Deine Skizze bleibt.', reload: 'Neu laden', later: 'Später' },
);

/** Nothing is searched for on an empty page, or by those who want it so. */
const PATIENCE_MS = 4000;
const CHECK_EVERY_MS = 60 * 60 * 1000;

/** Asks before the new version takes over; the sketch is saved with every edit, so nothing is lost. */
function offer(waiting: ServiceWorker): void {
  if (document.querySelector('.update')) {
    return;
  }
  const box = document.createElement('div');
  box.className = 'update';
  box.setAttribute('role', 'status');
  const words = document.createElement('span');
  words.textContent = WORDS.ready;
  const reload = button(WORDS.reload, 'button primary', () => waiting.postMessage('take-over'));
  const later = button(WORDS.later, 'button plain', () => box.remove());
  box.append(words, reload, later);
  document.body.append(box);
}

function button(label: string, kind: string, onClick: () => void): HTMLButtonElement {
  const element = document.createElement('button');
  element.type = 'button';
  element.className = kind;
  element.textContent = label;
  element.addEventListener('click', onClick);
  return element;
}

function watch(registration: ServiceWorkerRegistration): void {
  const look = () => {
    if (registration.waiting && navigator.serviceWorker.controller) {
      offer(registration.waiting);
    }
  };
  look();
  registration.addEventListener('updatefound', () => {
    registration.installing?.addEventListener('statechange', look);
  });
  setInterval(() => {
    registration.update().catch(() => undefined);
  }, CHECK_EVERY_MS);
}

async function register(): Promise<void> {
  const { serviceWorker } = navigator;
  const hadOne = serviceWorker.controller !== null;
  let reloading = false;
  serviceWorker.addEventListener('controllerchange', () => {
    // The first worker takes over a page that needs no reload.
    if (hadOne && !reloading) {
      reloading = true;
      location.reload();
    }
  });
  watch(await serviceWorker.register('./sw.js', { scope: './' }));
  const ready = await serviceWorker.ready;
  ready.active?.postMessage('fetch-the-rest');
}

function begin(): void {
  register().catch(() => undefined);
}

if ('serviceWorker' in navigator && import.meta.env.PROD) {
  // What is on screen comes first: keeping all files for later would take the network from the first model
  // and from the solver.
  let begun = false;
  const beginOnce = () => {
    if (!begun) {
      begun = true;
      begin();
    }
  };
  new PerformanceObserver((list) => {
    if (list.getEntriesByName(SETTLED).length > 0) {
      beginOnce();
    }
  }).observe({ type: 'mark', buffered: true });
  setTimeout(beginOnce, PATIENCE_MS);
}
