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
    inside: 'Hineinsehen: schneiden und freistellen',
    cut: 'Schnitt längs',
    cutNone: 'Keiner',
    cutAt: 'Wo',
    showAll: 'Alles zeigen',
    views: 'Feste Ansichten',
    fit: 'Einpassen',
  },
  part: {
    title: 'Teil',
    number: 'Nummer',
    picked: 'Teil {i} von {all}: {name}',
    ofModel: '{n} von {all}',
    toggle: 'Nur diese zeigen, oder wieder alle',
    isolateSame: 'Diese Art',
    isolateNear: 'Nachbarn',
  },
};
