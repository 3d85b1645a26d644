// The frame of the page.

export const APP_EN = {
  app: {
    name: 'Liftarm',
    tagline: 'From a line sketch to a Technic model that can be built',
    skip: 'Skip to the drawing',
    drawing: 'Drawing',
    drawingHelp:
      'Three-dimensional drawing. With a drawing tool: arrow keys move the cursor on the plane, Page Up and Page Down move it off the plane, Enter places a point, Escape steps back.',
    untitled: 'Untitled',
    sketchName: 'Name of the sketch',
    menu: 'Menu',
    tools: 'Tools',
    panel: 'Result and settings',
    showPanel: 'Show result and settings',
    hidePanel: 'Hide result and settings',
    close: 'Close',
    loading: 'Loading…',
    noWebgl:
      'This browser cannot draw in 3D (WebGL is off or missing). The sketch and the result below still work.',
  },
  rooms: {
    back: 'Back to the drawing',
    solving: 'The model is being worked out; it will be here in a moment.',
    failed: 'This page could not be loaded. Check the connection and try again.',
  },
  counts: {
    line: ['line', 'lines'],
    brick: ['brick', 'bricks'],
  },
  groups: {
    file: 'File',
    edit: 'Edit',
    draw: 'Draw',
    annotate: 'Annotate',
    solve: 'Solve',
    view: 'View',
    help: 'Help',
  },
} as const;
