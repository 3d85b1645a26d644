import type { GALLERY_EN } from '../en/gallery.ts';
import type { Words } from '../language.ts';

export const GALLERY_DE: Words<typeof GALLERY_EN> = {
  intro: 'Jedes Modell hier haben wir gezeichnet, und jedes ist baubar: öffnen, ändern, bauen.',
  models: 'Modelle',
  firstSteps: 'Erste Schritte',
  facts: '{beams} Balken · {bricks} Teile · {mass} g',
  moves: 'beweglich',
  copy: 'Link kopieren',
  copied: 'Link zu {name} kopiert.',
  turn: 'Zahnräder drehen sehen',
  move: 'Bewegen',
  jointsLabel: 'Das Modell mit beweglichen Gelenken',
  openWhole: 'Mit den Zahnrädern öffnen',
  failed: 'Das ging nicht: {message}',
  back: 'Zurück zur Galerie',
  working: 'Das Modell wird erzeugt…',
  gearsLabel: 'Das Modell mit drehenden Zahnrädern',
  crank: 'Kurbel',
  auto: 'Von selbst drehen',
  shaft: 'Welle {n}',
  turns: '{n} Umdrehungen',
  ratio: '{n} Umdrehungen der Kurbel drehen die letzte Welle einmal.',
  ratioUp: 'Eine Umdrehung der Kurbel dreht die letzte Welle {n}-mal.',
};
