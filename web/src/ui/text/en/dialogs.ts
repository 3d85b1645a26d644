// Examples, palette, help and about.

export const DIALOGS_EN = {
  examples: {
    title: 'Examples',
    text: 'Each one is a drawing to look at, change and generate.',
    lines: '{n} lines',
    missing: 'The examples could not be loaded.',
  },
  bricks: {
    title: 'Brick set',
    text: 'Parts that are off are not used. With counts, the parts list says what is missing.',
    import: 'Open a parts list…',
    reset: 'All parts, no counts',
    owned: 'Owned',
    ownedOf: 'How many of {name} there are',
    needed: 'Always needed: lines in a row are pinned with it.',
    imported: '{n} kinds of parts taken from {name}.',
    short: '{n} missing',
  },
  sketches: {
    title: 'My sketches',
    text: 'Kept in this browser. Nothing is uploaded.',
    create: 'New sketch',
    import: 'Open a file…',
    none: 'Nothing is kept yet: draw a line and it is.',
    duplicate: 'Duplicate {name}',
    copyName: '{name} (copy)',
    remove: 'Delete {name}',
    reallyRemove: 'Delete {name} for good',
    confirm: 'Delete?',
  },
  palette: {
    title: 'All commands',
    placeholder: 'Search for a command',
    none: 'No command has this name.',
  },
  help: {
    title: 'Keys and help',
    text: 'Draw lines of whole length; the program finds beams, pins and axles that make them. Everything you do can be undone.',
    pointer: 'Pointer',
    pointerRows: [
      ['Click', 'Place a point, or select'],
      ['Double click', 'Select a chain of lines'],
      ['Drag with Shift', 'Select by a box'],
      ['Drag with the right button', 'Turn the view'],
      ['Drag with the middle button', 'Shift the view'],
      ['Wheel', 'Zoom'],
      ['One finger', 'Draw'],
      ['Two fingers', 'Turn and zoom'],
    ] as readonly (readonly [string, string])[],
    drawing: 'While drawing',
    drawingRows: [
      ['0–9', 'Type the length, Enter places the point'],
      ['X Y Z', 'Lock an axis, press again to unlock'],
      ['Tab', 'Turn the plane'],
      ['Arrow keys', 'Move the cursor on the plane'],
      ['Page Up, Page Down', 'Move the cursor off the plane'],
      ['Enter', 'Place a point'],
      ['Escape', 'Step back one thing'],
    ] as readonly (readonly [string, string])[],
  },
  about: {
    title: 'About Liftarm',
    text: 'Liftarm turns a 3D line sketch into a Technic model that can be built: real parts, connected, free of collisions. Everything runs in your browser; nothing is uploaded.',
    method:
      'It implements and goes beyond “Computational LEGO Technic Design” by Hao Xu, Ka-Hei Hui, Chi-Wing Fu and Hao Zhang, ACM Transactions on Graphics 38(6), 2019.',
    trademark:
      'LEGO® is a trademark of the LEGO Group, which does not sponsor or endorse this project.',
    sources:
      'Part facts come from the LDraw.org Parts Library (CC BY 4.0) and the LDCad Shadow Library by Roland Melkert and contributors (CC BY-SA 4.0).',
    licence: 'Licence: MIT.',
    librariesTitle: 'Libraries',
    allLicences: 'The licences of all of them',
    libraries:
      'Preact, Preact Signals and three.js (MIT); in the solver Eigen (MPL 2.0) and nlohmann/json (MIT).',
  },
} as const;
