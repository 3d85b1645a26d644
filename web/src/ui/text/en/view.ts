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
    views: 'Standard views',
    fit: 'Fit',
  },
} as const;
