import type { SKETCH_EN } from '../en/sketch.ts';
import type { Words } from '../language.ts';

export const SKETCH_DE: Words<typeof SKETCH_EN> = {
  faults: {
    title: 'So nicht baubar',
    crossing:
      'Die Linien {a} und {b} kreuzen sich zwischen ihren Knoten: kein Pin verbindet sie dort.',
    mendCrossing: 'Auf Knoten rücken',
    twin: 'Die Linien {a} und {b} sind zweimal dieselbe.',
    mendTwin: 'Eine entfernen',
    refused: 'Linie {n}: {message}',
    edit: 'Beheben',
  },
  symmetry: {
    title: 'Symmetrie',
    text: 'Angekreuzte Ebenen gelten: das Modell wird auf beiden Seiten gleich gesucht.',
    found: 'gefunden',
    plane: 'Spiegel bei {plane}',
    translation: 'Längs einer Linie wiederholt',
    heldNote: '{n} gilt',
    foundNote: '{n} gefunden',
    edit: 'Symmetrie',
    confirmed: 'Die Symmetrie gilt.',
  },
};
