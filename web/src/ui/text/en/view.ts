// How the scene is looked at.

export const VIEW_EN = {
  view: {
    title: 'View',
    show: 'Show',
    sketch: 'Sketch',
    both: 'Both',
    model: 'Model',
    explode: 'Explode',
    colour: 'Colour',
    byPart: 'Part',
    byLayer: 'Layer',
    byAxis: 'Hole axis',
    byComponent: 'Plane of holes',
    byPiece: 'Piece',
    inside: 'Look inside: cut and isolate',
    cut: 'Cut along',
    cutNone: 'None',
    cutAt: 'Where',
    showAll: 'Show all',
    views: 'Standard views',
    fit: 'Fit',
  },
  part: {
    title: 'Part',
    number: 'Number',
    picked: 'Part {i} of {all}: {name}',
    ofModel: '{n} of {all}',
    toggle: 'Show these alone, or all again',
    isolateSame: 'This kind',
    isolateNear: 'Neighbours',
  },
} as const;
