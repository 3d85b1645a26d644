import type { COLOURS_EN } from '../en/colours.ts';
import type { Words } from '../language.ts';

export const COLOURS_DE: Words<typeof COLOURS_EN> = {
  title: 'Farben',
  scheme: 'Balken sind gefärbt',
  schemes: {
    length: 'nach Länge',
    component: 'nach Rahmen',
    usual: 'grau, wie üblich',
  },
  all: 'Alle Balken',
  selected: (n: string) => `Gewählte Linien (${n})`,
  none: 'wie der Rest',
  choose: (colour: string) => `Farbe: ${colour}`,
  step: 'Farben',
  hint: 'Wählen Sie Linien, um ihren Balken eine eigene Farbe zu geben.',
  unusual: (n: string) =>
    `${n} Teile haben eine andere Farbe als die, in der dieses Programm sie kennt: Prüfen Sie, ob es sie so gibt.`,
};
