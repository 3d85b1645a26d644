import catalogueFile from '../../../../core/parts/catalogue.json';
import { readCatalogue } from '../../model/catalogue.ts';
import type { SharedState } from '../../share/codec.ts';
import { decodeShare } from '../../share/codec.ts';
import { linkedPreferences } from '../../share/shared-state.ts';
import { createSolverClient } from '../../solver/client.ts';
import { readSketchValue, writeSketch } from '../../state/read-sketch.ts';
import { readSearchSettings, USUAL_SEARCH } from '../../state/search-settings.ts';
import { settingsOf } from '../../ui/solve-settings.ts';
import { chooseWords } from '../../ui/text/language.ts';
import { inWords, loadSentences } from '../../ui/text/sentences.ts';
import { SceneView } from '../../view/scene-view.ts';
import { readModel } from '../read-model.ts';

const WORDS = chooseWords(
  {
    none: 'This frame has no link to a sketch.',
    solving: 'Working it out…',
    open: 'Open in Liftarm',
    label: '3D model; drag to turn it',
    failed: 'The model could not be worked out. The sketch is shown.',
    notBuildable: 'Not buildable yet.',
    noWebgl: 'This browser cannot draw in 3D.',
  } as const,
  {
    none: 'Dieser Rahmen hat keinen Link zu einer Skizze.',
    solving: 'Wird berechnet…',
    open: 'In Liftarm öffnen',
    label: '3D-Modell; ziehen, um es zu drehen',
    failed: 'Das Modell konnte nicht berechnet werden. Gezeigt wird die Skizze.',
    notBuildable: 'Noch nicht baubar.',
    noWebgl: 'Dieser Browser kann nicht in 3D zeichnen.',
  },
);

/** Shows the sketch of a link at once and its model as soon as it is found. */
export async function showLink(host: HTMLElement, fragment: string): Promise<void> {
  host.replaceChildren();
  const status = document.createElement('p');
  status.className = 'embed-status';
  status.setAttribute('role', 'status');
  const [shared] = await Promise.all([decodeShare(fragment), loadSentences()]);
  if (!shared?.ok) {
    status.textContent = shared ? inWords(shared.message) : WORDS.none;
    host.append(status);
    return;
  }
  const sketch = readSketchValue(shared.value.sketch);
  if (!sketch.ok) {
    status.textContent = inWords(sketch.message);
    host.append(status);
    return;
  }
  const canvas = document.createElement('canvas');
  canvas.tabIndex = 0;
  canvas.setAttribute('role', 'img');
  canvas.setAttribute('aria-label', WORDS.label);
  host.append(canvas, status, openLink(fragment));
  document.title = sketch.value.name || 'Liftarm';
  let view: SceneView;
  try {
    view = new SceneView(canvas, { catalogue: readCatalogue(catalogueFile), theme: theme() });
  } catch {
    status.textContent = WORDS.noWebgl;
    return;
  }
  view.setNavigation('orbit');
  view.setSketch(sketch.value);
  view.setMode('sketch');
  view.fit('iso');
  await solve(view, { ...shared.value, sketch: sketch.value }, status);
}

async function solve(view: SceneView, state: SharedState, status: HTMLElement): Promise<void> {
  status.textContent = WORDS.solving;
  const client = createSolverClient();
  const settings = settingsOf(readSearchSettings(linkedPreferences(state)) ?? USUAL_SEARCH);
  const result = await client.solve(writeSketch(state.sketch), settings);
  client.dispose();
  const model = result.outcome === 'solved' ? readModel(result.modelJson) : null;
  if (result.outcome !== 'solved' || !model?.ok) {
    status.textContent = WORDS.failed;
    return;
  }
  view.setModel(model.value);
  view.setMode('model');
  view.fit('iso');
  const report: unknown = JSON.parse(result.reportJson);
  const buildable =
    typeof report === 'object' && report !== null && 'buildable' in report && report.buildable;
  status.textContent = buildable ? '' : WORDS.notBuildable;
  status.dataset['bricks'] = `${model.value.parts.length}`;
}

function openLink(fragment: string): HTMLAnchorElement {
  const link = document.createElement('a');
  link.className = 'embed-open';
  link.target = '_blank';
  link.rel = 'noopener';
  link.href = `./#${fragment}`;
  link.textContent = WORDS.open;
  return link;
}

function theme(): 'light' | 'dark' {
  return matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light';
}
