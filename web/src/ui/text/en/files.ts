// Files, links and what is kept.

export const FILES_EN = {
  files: {
    drop: 'Drop a sketch or a model here',
    opened: 'Opened {name}.',
    openedModel: 'Opened the model {name} and checked it.',
    refused: '{name}: {message}',
    tooLarge: 'the file is larger than 32 MB, which is the limit',
    empty: 'the file is empty',
    neither: 'this is neither a sketch nor a model of ours',
    notJson: 'this is not JSON, or a part of it is missing',
    unreadable: 'the file could not be read',
    badModel: 'parts[{i}]: should have part, position and rotation',
    copied: 'Link copied.',
    copyFailed: 'The browser did not let us copy. The link is in the address bar.',
    fromLink: 'Opened from a link.',
    restored: 'Your last sketch is back.',
    storeFull: 'The browser could not save the sketch. Download it so that nothing is lost.',
    storeNone: 'This browser keeps nothing between visits. Download the sketch before you leave.',
    exportFailed: 'The file could not be written: {message}',
    checking: 'Checking {name}…',
  },
} as const;
