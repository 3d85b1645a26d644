import { firstModels } from 'virtual:first-model';
import { batch, computed, effect } from '@preact/signals';
import { render } from 'preact';
import catalogueFile from '../../../core/parts/catalogue.json';
import { readCatalogue } from '../model/catalogue.ts';
import type { MadeModel } from '../solver/made-model.ts';
import { createSolverPool } from '../solver/solver-pool.ts';
import type { SolverClient } from '../solver/worker-client.ts';
import { type SavedSketch, SketchStore } from '../state/store.ts';
import { fillWords } from '../tools/tool-words.ts';
import type { Page } from '../ui/page.ts';
import { isLookedAtPlace } from '../ui/places.ts';
import { findRoom } from '../ui/rooms/room-table.ts';
import { Root } from '../ui/root.tsx';
import { language } from '../ui/text/language.ts';
import { loadPartNames } from '../ui/text/part-names.ts';
import { loadSentences } from '../ui/text/sentences.ts';
import { text } from '../ui/text.ts';
import { Thumbnails } from '../view/still/thumbnails.ts';
import '../../styles/tokens.css';
import '../../styles/base.css';
import '../../styles/layout.css';
import '../../styles/spine.css';
import '../../styles/rail.css';
import '../../styles/verdict.css';
import '../../styles/menu.css';
import '../../styles/narrow.css';
import '../../styles/controls.css';
import '../../styles/scene.css';
import '../../styles/inspect.css';
import '../../styles/panel.css';
import '../../styles/dialogs.css';
import '../../styles/rooms.css';
import '../../styles/search.css';
import { settingsOf } from '../ui/solve-settings.ts';
import { solveAfterEdits } from './auto-solve.ts';
import { commandTable } from './commands.ts';
import { listenToDrops } from './drop.ts';
import { loadExamples } from './example-list.ts';
import { SETTLED } from './first-model.ts';
import { followLanguage } from './follow-language.ts';
import { keepPreferences, openLibrary, openStore } from './keeping.ts';
import { listenToKeys } from './keyboard.ts';
import { ModelTouch } from './model-touch.ts';
import { openLink } from './open-link.ts';
import { PageController } from './page-controller.ts';
import { followRoom } from './room-route.ts';
import type { SceneBridge } from './scene-bridge.ts';
import { watchSketch } from './sketch-watch.ts';
import { followTheme } from './theme.ts';

const ADDRESS_PAUSE_MS = 600;
const TURN_MS = 12_000;
/** A page in the background draws nothing: what waits for the picture waits no longer than this. */
const PICTURE_PATIENCE_MS = 3000;

async function fetchJson(path: string): Promise<unknown> {
  const reply = await fetch(path);
  return reply.ok ? reply.json() : null;
}

function pageOf(controller: PageController, client: SolverClient): Page {
  const { state, toaster, scene } = controller;
  const thumbnails = new Thumbnails(state.catalogue);
  const touch = new ModelTouch({
    state,
    client,
    run: controller.run,
    settings: () => settingsOf(state.preferences.value),
  });
  touch.start();
  return {
    ...state,
    commands: commandTable(controller),
    toasts: toaster.toasts,
    webglMissing: scene.webglMissing,
    places: touch.places,
    touchModel: ({ label, next, index, place }) => {
      if (index !== null) {
        touch.follow(index, place);
      }
      controller.edit(label, next);
      controller.regrow();
    },
    fits: (part, signal) => touch.fits(part, signal),
    tryPart: (before, after, signal) => touch.tryPart(before, after, signal),
    mac: /mac/i.test(navigator.platform),
    mountScene: (host) => scene.mount(host),
    view: () => scene.view,
    openRoom: controller.openRoom,
    announce: controller.announce,
    focusDrawing: controller.focusDrawing,
    sketches: {
      list: () => controller.shelf.list(),
      openId: () => controller.shelf.openId,
      open: controller.openKept,
      duplicate: (id) =>
        controller.shelf.duplicate(id, (name) => fillWords(text.sketches.copyName, { name })),
      remove: controller.removeKept,
    },
    useTool: controller.useTool,
    openExample: controller.openExample,
    takeModel: (made, search) => {
      const { preferences } = state;
      batch(() => {
        preferences.value = { ...preferences.peek(), ...search };
        controller.run.showMade(made);
      });
    },
    openFile: controller.files.openFile,
    focusProblem: controller.focusProblem,
    importOwned: controller.files.importOwned,
    takeLegal: controller.files.takeLegal,
    mendModel: controller.files.mendModel,
    partPicture: (id) => thumbnails.picture(id),
    toggleKind: controller.toggleKind,
    cutAlong: controller.cutAlong,
    showPlace: controller.showPlace,
    showLayout: controller.showLayout,
    mend: controller.mend,
    confirmSymmetry: controller.confirmSymmetry,
    dropSymmetry: controller.dropSymmetry,
    rename: controller.rename,
    dropOwnSettings: controller.dropOwnSettings,
    dismissToast: (id) => toaster.dismiss(id),
    typeLength: controller.typeLength,
  };
}

/** On a first visit the picture turns, to say that it is a space; anything that is done stops it. */
function turnUntilTouched(scene: SceneBridge): void {
  const stop = new AbortController();
  const end = () => {
    stop.abort();
    scene.view?.setTurntable('off');
  };
  scene.view?.setTurntable('on');
  for (const event of ['pointerdown', 'wheel', 'keydown']) {
    window.addEventListener(event, end, { signal: stop.signal, capture: true, passive: true });
  }
  setTimeout(end, TURN_MS);
}

/**
 * What to begin with: a link, else the last visit's sketch, else the first example.
 * @returns the model that came with the page, if that is shown.
 */
async function openFirst(
  controller: PageController,
  saved: SavedSketch | null,
): Promise<MadeModel | null> {
  const { state, scene, run } = controller;
  if (saved) {
    controller.begin(saved);
  }
  if ((await openLink(controller, saved !== null)) || saved) {
    return null;
  }
  turnUntilTouched(scene);
  const firstModel = firstModels[language];
  const { sketch, settings } = firstModel;
  controller.shelf.leave(sketch);
  state.came.value = sketch;
  controller.begin({ sketch, history: { past: [], future: [] } });
  // Whoever has set other things gets another model: that one is searched for.
  const preferences = state.preferences.value;
  if (!preferences.autoSolve || !same(settings, settingsOf(preferences))) {
    return null;
  }
  run.showMade(firstModel);
  return firstModel;
}

function same(a: unknown, b: unknown): boolean {
  return JSON.stringify(a) === JSON.stringify(b);
}

/** What comes after the first picture, which needs neither the solver nor the other examples. */
async function settle(
  controller: PageController,
  client: SolverClient,
  made: MadeModel | null,
): Promise<void> {
  const { state } = controller;
  const drawn = controller.modelDrawn();
  if (made && findRoom(state.room.value) === null) {
    await Promise.race([drawn, new Promise((late) => setTimeout(late, PICTURE_PATIENCE_MS))]);
  }
  client.warmUp();
  const settled = made ? controller.run.confirm(made) : drawn;
  settled.then(
    () => performance.mark(SETTLED),
    () => undefined,
  );
  watchSketch(state, client);
}

async function start(): Promise<void> {
  const store = new SketchStore();
  const preferences = keepPreferences(() => toaster.error(text.files.settingsRefused));
  const client = createSolverPool();
  if (location.hash.length > 1) {
    client.warmUp();
  }
  const catalogue = readCatalogue(catalogueFile);
  const controller = new PageController({ store, preferences, catalogue, client });
  const { state, toaster } = controller;
  followTheme(state);
  document.documentElement.lang = language;
  // Asked for before the page is drawn, so that the first picture does not wait for the answer.
  const opening = openStore((message) => controller.warn(message));
  const page = pageOf(controller, client);
  const root = document.getElementById('app');
  if (!root) {
    throw new Error('index.html has no #app');
  }
  root.replaceChildren();
  // Before anything is drawn: behind a room nothing has to be.
  followRoom(state.room);
  effect(() => {
    // On a phone, what a place beside the drawing is for stands in the sheet.
    state.panelOpen.value = isLookedAtPlace(state.room.value);
  });
  render(<Root page={page} />, root);
  listenToDrops(state.dropping, controller.files.openFile);
  listenToKeys(
    {
      commands: page.commands,
      mac: page.mac,
      tool: () => state.tool.value,
      covered: () => state.dialog.value !== null || findRoom(state.room.value) !== null,
      atRest: controller.rest,
    },
    new AbortController().signal,
  );
  let begin: () => void = () => undefined;
  const begun = new Promise<void>((resolve) => {
    begin = resolve;
  });
  followLinks(controller, begun);
  const { shelf } = controller;
  const saved = await shelf.begin(openLibrary(controller, await opening));
  await Promise.all([loadSentences(), loadPartNames()]);
  const made = await openFirst(controller, saved);
  shelf.keepEdits();
  effect(() => {
    document.documentElement.dataset['kept'] = shelf.state.value ?? '';
  });
  followLanguage(preferences, () => shelf.kept());
  solveAfterEdits(state, {
    generate: controller.regrow,
    drop: () => controller.run.drop(),
    wishUnderWay: () => controller.run.wishUnderWay,
  });
  controller.fitFirstModels();
  begin();
  keepAddress(controller);
  effect(() => {
    const name = store.sketch.value.name;
    document.title = name ? `${name} – ${text.app.name}` : text.app.name;
  });
  await settle(controller, client, made);
  state.examples.value = await loadExamples(fetchJson).catch(() => []);
}

/**
 * A link that is pasted into the address of the open page is opened as if the page were new.
 * @param begun whatever the page begins with is there: what is pasted before waits for it.
 */
function followLinks(controller: PageController, begun: Promise<void>): void {
  window.addEventListener('hashchange', () => {
    controller.toaster.clearErrors();
    begun
      .then(() => openLink(controller, true))
      .then((opened) => (opened ? null : controller.files.updateAddress()))
      .catch(() => undefined);
  });
}

/** The address holds the sketch a moment after each change. */
function keepAddress(controller: PageController): void {
  const { store, preferences } = controller.state;
  const shared = computed(() => [
    store.sketch.value,
    preferences.value.seed,
    preferences.value.preset,
  ]);
  let timer: ReturnType<typeof setTimeout> | undefined;
  effect(() => {
    shared.value;
    clearTimeout(timer);
    timer = setTimeout(() => {
      controller.files.updateAddress().catch(() => undefined);
    }, ADDRESS_PAUSE_MS);
  });
}

await start();
