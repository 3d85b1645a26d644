// The gallery of models.

export const GALLERY_EN = {
  intro: 'Every model here was drawn by us and can be built: open one, change it, build it.',
  facts: '{beams} beams · {bricks} parts · {mass} g',
  moves: 'moves',
  copy: 'Copy link',
  copied: 'Link to {name} copied.',
  turn: 'See the gears turn',
  move: 'Move it',
  jointsLabel: 'The model with moving joints',
  openWhole: 'Open with its gears',
  failed: 'That did not work: {message}',
  back: 'Back to the gallery',
  working: 'Generating the model…',
  gearsLabel: 'The model with turning gears',
  crank: 'Crank',
  auto: 'Turn by itself',
  shaft: 'Shaft {n}',
  turns: '{n} turns',
  ratio: '{n} turns of the crank turn the last shaft once.',
  ratioUp: 'One turn of the crank turns the last shaft {n} times.',
} as const;
