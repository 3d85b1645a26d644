import type { SKETCH_EN } from '../en/sketch.ts';
import type { Words } from '../language.ts';

export const SKETCH_DE: Words<typeof SKETCH_EN> = {
  faults: {
    title: 'In der Zeichnung zu prüfen',
    crossing:
      'Die Linien {a} und {b} kreuzen sich zwischen ihren Knoten: kein Pin verbindet sie dort.',
    mendCrossing: 'Auf Knoten rücken',
    twin: 'Die Linien {a} und {b} sind zweimal dieselbe.',
    mendTwin: 'Eine entfernen',
    mendNear: 'Zusammenrücken',
    mendLine: 'Linie ergänzen',
    mendMoved: 'So zeichnen',
    line: 'Linie {n}',
    from: 'der Anfang von Linie {n}',
    to: 'das Ende von Linie {n}',
    refused: 'Linie {n}: {message}',
    edit: 'Beheben',
  },
  symmetry: {
    title: 'Symmetrie',
    text: 'Was angekreuzt ist, gilt: das Modell wird auf allen Seiten gleich gesucht.',
    found: 'gefunden',
    plane: 'Spiegel bei {plane}',
    partPlane: '{n} Linien gespiegelt bei {plane}',
    translation: '{n} Linien noch einmal, verschoben um ({vector})',
    rotation: 'Sieht nach einer Drehung um {n}° gleich aus',
    heldNote: '{n} gilt',
    foundNote: '{n} gefunden',
    edit: 'Symmetrie',
    confirmed: 'Die Symmetrie gilt.',
    differs: 'Hier sind die Seiten verschieden: die Teile ließen dasselbe auf beiden nicht zu.',
  },
};
