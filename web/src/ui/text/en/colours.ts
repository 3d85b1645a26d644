export const COLOURS_EN = {
  title: 'Colours',
  scheme: 'Beams are coloured',
  schemes: {
    length: 'by length',
    component: 'by frame',
    usual: 'grey, as usual',
  },
  all: 'All beams',
  selected: (n: string) => `Selected lines (${n})`,
  none: 'as the rest',
  choose: (colour: string) => `Colour: ${colour}`,
  step: 'Colours',
  hint: 'Select lines to give their beams a colour of their own.',
  unusual: (n: string) =>
    `${n} parts are in a colour other than the one this program knows them in: check that it is sold.`,
};
