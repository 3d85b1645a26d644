import type { VIEW_EN } from '../en/view.ts';
import type { Words } from '../language.ts';

export const VIEW_DE: Words<typeof VIEW_EN> = {
  view: {
    title: 'Ansicht',
    show: 'Zeigen',
    sketch: 'Skizze',
    both: 'Beides',
    model: 'Modell',
    explode: 'Zerlegen',
    colour: 'Farbe',
    byPart: 'Teil',
    byLayer: 'Lage',
    byAxis: 'Lochachse',
    byComponent: 'Lochebene',
    byPiece: 'Stück',
    views: 'Feste Ansichten',
    fit: 'Einpassen',
  },
};
