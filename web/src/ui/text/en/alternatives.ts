// Several models of one drawing, side by side.

export const ALTERNATIVES_EN = {
  title: 'Other models of this drawing',
  intro:
    'Each is built of the same lines by other rules. A click puts one on the page; its link gives it again.',
  loading: 'Loading…',
  failed: 'The other models could not be searched for: {message}',
  searching: 'Searching: {n} of {all}',
  stop: 'Stop',
  none: 'Every other search gave the same model.',
  done: 'Searched: {n} other models.',
  doneOne: 'Searched: one other model.',
  onScreen: 'On the page',
  notBuildable: 'Not buildable',
  taken: '{name}: on the page now.',
  compare: 'Compared',
  model: 'Model',
  names: {
    balanced: 'As a builder would',
    simple: 'With few parts',
    faithful: 'Close to the lines',
    'simple-rigid': 'Few parts, stiff',
    'faithful-rigid': 'Close and stiff',
    other: 'By other chances',
  } as Readonly<Record<string, string>>,
  figures: {
    bricks: 'Parts',
    kinds: 'Kinds',
    deviation: 'Layers off the lines',
    freedoms: 'Loose ways',
    mass: 'Grams',
  },
  wellBuilt: 'Well built',
  wellBuiltValue: '{n} of {all}',
  best: {
    bricks: 'fewest parts',
    kinds: 'fewest kinds',
    deviation: 'closest',
    freedoms: 'stiffest',
    mass: 'lightest',
  },
};
