// What the program finds in a sketch.

export const SKETCH_EN = {
  faults: {
    title: 'Worth a look in the drawing',
    crossing: 'Lines {a} and {b} cross between their nodes: no pin can join them.',
    mendCrossing: 'Move to nodes',
    twin: 'Lines {a} and {b} are the same line twice.',
    mendTwin: 'Remove one',
    mendNear: 'Bring together',
    mendLine: 'Add the line',
    mendMoved: 'Draw it so',
    line: 'line {n}',
    from: 'the start of line {n}',
    to: 'the end of line {n}',
    refused: 'Line {n}: {message}',
    edit: 'Mend',
  },
  symmetry: {
    title: 'Symmetry',
    text: 'What is ticked is kept: the model is searched for with all sides alike.',
    found: 'found',
    plane: 'Mirror at {plane}',
    partPlane: '{n} lines mirrored at {plane}',
    translation: '{n} lines again, shifted by ({vector})',
    rotation: 'Looks the same after a turn of {n}°',
    heldNote: '{n} kept',
    foundNote: '{n} found',
    edit: 'Symmetry',
    confirmed: 'Symmetry kept.',
    differs: 'Here the sides differ: the parts did not allow the same on both.',
  },
} as const;
