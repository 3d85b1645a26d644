import type { ALTERNATIVES_EN } from '../en/alternatives.ts';

export const ALTERNATIVES_DE: typeof ALTERNATIVES_EN = {
  title: 'Andere Modelle dieser Zeichnung',
  intro:
    'Jedes ist nach anderen Regeln aus denselben Linien gebaut. Ein Klick bringt eines auf die Seite; sein Link ergibt es wieder.',
  loading: 'Wird geladen …',
  failed: 'Die anderen Modelle konnten nicht gesucht werden: {message}',
  searching: 'Suche: {n} von {all}',
  stop: 'Anhalten',
  none: 'Jede andere Suche ergab dasselbe Modell.',
  done: 'Gesucht: {n} andere Modelle.',
  doneOne: 'Gesucht: ein anderes Modell.',
  onScreen: 'Auf der Seite',
  notBuildable: 'Nicht baubar',
  taken: '{name}: jetzt auf der Seite.',
  compare: 'Im Vergleich',
  model: 'Modell',
  names: {
    balanced: 'Wie ein Baumeister',
    simple: 'Mit wenigen Teilen',
    faithful: 'Nah an den Linien',
    'simple-rigid': 'Wenige Teile, steif',
    'faithful-rigid': 'Nah und steif',
    other: 'Mit anderem Zufall',
  },
  figures: {
    bricks: 'Teile',
    kinds: 'Arten',
    deviation: 'Lagen neben den Linien',
    freedoms: 'Lose Wege',
    mass: 'Gramm',
  },
  wellBuilt: 'Gut gebaut',
  wellBuiltValue: '{n} von {all}',
  best: {
    bricks: 'wenigste Teile',
    kinds: 'wenigste Arten',
    deviation: 'am nächsten',
    freedoms: 'am steifsten',
    mass: 'am leichtesten',
  },
};
