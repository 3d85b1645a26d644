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
    linkLeftOut: 'The link has settings that this page does not know; they are left out: {list}',
    download: 'Download the sketch',
    restored: 'Your last sketch is back.',
    storeFull: 'The browser could not save the sketch. Download it so that nothing is lost.',
    settingsRefused: 'The browser could not keep your settings for the next visit.',
    storeFrame:
      'In the frame of another site nothing is kept. Download the sketch before you leave.',
    storeNone: 'This browser keeps nothing between visits. Download the sketch before you leave.',
    exportFailed: 'The file could not be written: {message}',
    reading: 'Reading {name}…',
  },
  /** A part for another in the model of a file. */
  mends: {
    look: 'Look for a mend',
    looking: 'Trying other pins…',
    none: 'No other pin helps here.',
    done: '{after} in place of {before}: nothing is wrong any more.',
    part: '{after} in place of {before}: {n} places are still wrong.',
  },
  /** The nearest drawing that can be built to one that cannot. */
  legal: {
    show: 'Show the nearest that can be built',
    title: 'The nearest drawing that can be built',
    moved: '{n} of {all} lines change; no end moves more than {most} modules.',
    before: 'As it is in the file',
    after: 'With whole lengths',
    line: 'Line {n}: {before} becomes {after}',
    more: 'and {n} more',
    take: 'Take this one',
    leave: 'Leave it',
  },
  /** What other tabs of this browser do to the sketch that is open. */
  tabs: {
    changed: 'Changed in another tab; this is the newest state.',
    removed:
      'This sketch was deleted in another tab. It stays here, and your next edit keeps it again.',
    forked:
      'Another tab changed this sketch meanwhile. What is on this page is kept as a sketch of its own; the other is among your sketches.',
    notRemoved: 'Another tab has changed this sketch since it was listed, so it was not deleted.',
  },
} as const;
