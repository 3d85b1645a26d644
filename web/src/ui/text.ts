import { APP_DE } from './text/de/app.ts';
import { COMMANDS_DE } from './text/de/commands.ts';
import { DIALOGS_DE } from './text/de/dialogs.ts';
import { DRAW_DE } from './text/de/draw.ts';
import { FILES_DE } from './text/de/files.ts';
import { PLACES_DE } from './text/de/places.ts';
import { SKETCH_DE } from './text/de/sketch.ts';
import { SOLVE_DE } from './text/de/solve.ts';
import { VIEW_DE } from './text/de/view.ts';
import { APP_EN } from './text/en/app.ts';
import { COMMANDS_EN } from './text/en/commands.ts';
import { DIALOGS_EN } from './text/en/dialogs.ts';
import { DRAW_EN } from './text/en/draw.ts';
import { FILES_EN } from './text/en/files.ts';
import { PLACES_EN } from './text/en/places.ts';
import { SKETCH_EN } from './text/en/sketch.ts';
import { SOLVE_EN } from './text/en/solve.ts';
import { VIEW_EN } from './text/en/view.ts';
import { chooseWords, formatNumber } from './text/language.ts';

const EN = {
  ...APP_EN,
  ...COMMANDS_EN,
  ...DIALOGS_EN,
  ...DRAW_EN,
  ...FILES_EN,
  ...PLACES_EN,
  ...SKETCH_EN,
  ...SOLVE_EN,
  ...VIEW_EN,
};

/** The words of the page in the language in use. */
export const text = chooseWords(EN, {
  ...APP_DE,
  ...COMMANDS_DE,
  ...DIALOGS_DE,
  ...DRAW_DE,
  ...FILES_DE,
  ...PLACES_DE,
  ...SKETCH_DE,
  ...SOLVE_DE,
  ...VIEW_DE,
});

/** Words for a count: one of them, several of them. */
export function plural(count: number, what: keyof typeof text.counts): string {
  const [one, many] = text.counts[what];
  return `${formatNumber(count)} ${count === 1 ? one : many}`;
}
