import type { PROOF_EN } from '../en/proof.ts';
import type { Words } from '../language.ts';

export const PROOF_DE: Words<typeof PROOF_EN> = {
  title: 'Wenigste Balken',
  proved: 'bewiesen',
  atLeast: (least) => `mindestens ${least}`,
  nobody: (beams) => `Bewiesen: Mit weniger als diesen ${beams} Balken geht es nicht.`,
  gap: (beams, least) => `Dieses Modell hat ${beams} Balken; mindestens ${least} sind nötig.`,
  openGap: 'Mehr ist nicht bewiesen; ob es mit weniger geht, ist offen.',
  prove: 'Beweise es',
  stop: 'Beweis abbrechen',
  loading: 'Der Beweiser wird geladen …',
  working: (done, pieces, leaves) => `${done} von ${pieces} Stücken bewiesen, ${leaves} Fälle.`,
  failed: 'Das ließ sich nicht beweisen.',
  unknown: 'Bekannt nur bei Modellen, die hier erzeugt wurden.',
  about:
    'Zählt alle Arten, wie die benutzten Teile die Linien abdecken könnten, gleich in welchen Schichten, mit nicht mehr Achsen auf Linien als in diesem Modell. Frei bleiben Kanten nur neben Ecken, denen keine Richtung der Löcher allein genügt.',
};
