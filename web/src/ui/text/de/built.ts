import type { BUILT_EN } from '../en/built.ts';
import type { Words } from '../language.ts';

export const BUILT_DE: Words<typeof BUILT_EN> = {
  title: 'Gut gebaut',
  passed: (n: string, of: string) => `${n} von ${of}`,
  about: 'Was man beim Bauen erwartet, über ein baubares Modell hinaus.',
  layers: (n: string) => `${n} Lagen daneben`,
  falls: 'kippt um',
  below: (n: string) => `${n} zu tief`,
  lifted: (n: string) => `${n} Füße in der Luft`,
  loose: (n: string) => `${n} beweglich`,
  turning: (n: string) => `${n} auf einer Achse`,
  naked: (n: string, of: string) => `${n} von ${of} in nichts`,
  mirrored: (n: string, of: string) => `${n} von ${of} Balken`,
  parts: (n: string, kinds: string) => `${n} Teile, ${kinds} Sorten`,
  good: 'gut',
  notAsked: 'nicht verlangt',
  more: (n: string) => `${n} weitere`,
  nowhere: 'Kein Ort zu zeigen.',
};
