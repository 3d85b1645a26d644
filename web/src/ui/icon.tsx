// One family of line icons: a 20 by 20 box, strokes of 1.5, round ends. Drawn for this page.

const PATHS = {
  line: 'M4.5 15.5 15.5 4.5M4.5 15.5h.01M15.5 4.5h.01',
  rectangle: 'M3.5 5.5h13v9h-13z',
  box: 'M3.5 7.5h9v9h-9zM3.5 7.5l4-4h9l-4 4M16.5 3.5v9l-4 4',
  grid: 'M3.5 3.5h13v13h-13zM3.5 10h13M10 3.5v13',
  select: 'M5 3.5l10.5 6.2-4.7 1.2-2.3 4.6z',
  joint:
    'M10 10m-2.2 0a2.2 2.2 0 1 0 4.4 0a2.2 2.2 0 1 0-4.4 0M3 15.5l5.3-4M17 15.5l-5.3-4M5.5 6a6.2 6.2 0 0 1 9 0M14.5 3.4V6h-2.6',
  keepOut: 'M3.5 3.5h13v13h-13zM6 14 14 6M6 9.5 9.5 6M10.5 14 14 10.5',
  hexagon: 'M10 3l6.1 3.5v7L10 17l-6.1-3.5v-7z',
  undo: 'M7 4.5 3.5 8 7 11.5M3.5 8h8a5 5 0 0 1 0 10H8',
  redo: 'M13 4.5 16.5 8 13 11.5M16.5 8h-8a5 5 0 0 0 0 10H12',
  trash: 'M4 5.5h12M8 5.5v-2h4v2M5.5 5.5l.8 11h7.4l.8-11M8.5 9v4.5M11.5 9v4.5',
  copy: 'M7 7h9.5v9.5H7zM4.5 13h-1V3.5H13v1',
  paste: 'M6.5 4.5h-2v12h11v-12h-2M7.5 3h5v3h-5zM7.5 10h5M7.5 13h5',
  mirror: 'M10 3v14M8 6l-4.5 8.5H8zM12 6l4.5 8.5H12',
  rotate: 'M15.5 7.5A6.2 6.2 0 1 0 16.2 11M16 3.5v4h-4',
  split: 'M3 10h4.5M12.5 10H17M10 3.5v4M10 12.5v4',
  merge: 'M3 10h14M8 7.5 5.5 10 8 12.5M12 7.5l2.5 2.5-2.5 2.5',
  array: 'M3 7h4v6H3zM9.5 7h2.5v6H9.5M14.5 7H17v6h-2.5',
  measure: 'M3 13.5 13.5 3 17 6.5 6.5 17zM6 10.5l1.5 1.5M8.5 8l2 2M11 5.5l1.5 1.5',
  axis: 'M10 2.5v15M5.8 10a4.2 2 0 1 0 8.4 0a4.2 2 0 1 0-8.4 0',
  exact: 'M3.5 10h13M6 6.5v7M14 6.5v7',
  play: 'M6 4l9.5 6L6 16z',
  stop: 'M5 5h10v10H5z',
  download: 'M10 3v9.5M6 9l4 4 4-4M3.5 16.5h13',
  open: 'M3 15.5v-11h5l1.5 2H16v2.5M3 15.5l2.5-6.5H18l-2.5 6.5z',
  sketches: 'M6.5 6.5H17v10H6.5zM6.5 13.5h-3v-10H14v3M9 13.5l5.5-4',
  gallery: 'M3.5 3.5h5.5V9H3.5zM11 3.5h5.5V9H11zM3.5 11h5.5v5.5H3.5zM11 11h5.5v5.5H11z',
  share:
    'M8.2 11.8a3.2 3.2 0 0 0 4.6 0l3-3a3.2 3.2 0 0 0-4.6-4.6l-.9.9M11.8 8.2a3.2 3.2 0 0 0-4.6 0l-3 3a3.2 3.2 0 0 0 4.6 4.6l.9-.9',
  search: 'M8.8 8.8m-5.3 0a5.3 5.3 0 1 0 10.6 0a5.3 5.3 0 1 0-10.6 0M12.8 12.8l4 4',
  help: 'M7.5 7.5a2.5 2.5 0 1 1 3.6 2.2c-.8.4-1.1.9-1.1 1.8M10 14.5h.01M10 2.8a7.2 7.2 0 1 0 0 14.4 7.2 7.2 0 0 0 0-14.4z',
  info: 'M10 9v5M10 6.2h.01M10 2.8a7.2 7.2 0 1 0 0 14.4 7.2 7.2 0 0 0 0-14.4z',
  language:
    'M10 2.8a7.2 7.2 0 1 0 0 14.4 7.2 7.2 0 0 0 0-14.4zM2.8 10h14.4M10 2.8c2.2 2 3.2 4.4 3.2 7.2s-1 5.2-3.2 7.2c-2.2-2-3.2-4.4-3.2-7.2s1-5.2 3.2-7.2',
  theme: 'M10 2.8a7.2 7.2 0 1 0 0 14.4zM10 2.8a7.2 7.2 0 0 1 0 14.4',
  settings: 'M3 6h7M14 6h3M12 4v4M3 14h3M10 14h7M8 12v4',
  fit: 'M3.5 7.5v-4h4M12.5 3.5h4v4M16.5 12.5v4h-4M7.5 16.5h-4v-4',
  cube: 'M10 2.8l6.3 3.6v7.2L10 17.2l-6.3-3.6V6.4zM3.7 6.4 10 10l6.3-3.6M10 10v7.2',
  viewFront:
    'M10 2.8l6.3 3.6v7.2L10 17.2l-6.3-3.6V6.4zM3.7 6.4 10 10l6.3-3.6M10 10v7.2M4.5 8.8v3M6.5 10v3.5',
  viewRight:
    'M10 2.8l6.3 3.6v7.2L10 17.2l-6.3-3.6V6.4zM3.7 6.4 10 10l6.3-3.6M10 10v7.2M15.5 8.8v3M13.5 10v3.5',
  viewTop:
    'M10 2.8l6.3 3.6v7.2L10 17.2l-6.3-3.6V6.4zM3.7 6.4 10 10l6.3-3.6M10 10v7.2M7.5 6.4 10 5M10 7.8l2.5-1.4',
  perspective: 'M5.5 4.5h9l3 11h-15zM10 4.5v11M4 10h12',
  camera: 'M3 6h3.5L8 4h4l1.5 2H17v10H3zM10 10.7m-2.8 0a2.8 2.8 0 1 0 5.6 0a2.8 2.8 0 1 0-5.6 0',
  close: 'M5 5l10 10M15 5 5 15',
  check: 'M4 10.5l4 4 8-9',
  back: 'M9 4.5 3.5 10 9 15.5M3.5 10h13',
  alert: 'M10 3 2.5 16.5h15zM10 8v4M10 14.2h.01',
  menu: 'M3.5 5.5h13M3.5 10h13M3.5 14.5h13',
  chevron: 'M6 8l4 4 4-4',
  plane: 'M3 13l4-7h10l-4 7z',
  cut: 'M3.5 6.5 10 3l6.5 3.5v7L10 17l-6.5-3.5zM10 3v14M13 7.5v6M16.5 6.5 10 10',
  isolate:
    'M10 6.5 13 8.2v3.6l-3 1.7-3-1.7V8.2zM3.5 6.5v-3h3M13.5 3.5h3v3M16.5 13.5v3h-3M6.5 16.5h-3v-3',
  explode:
    'M8 12l-4.5 4.5M12 12l4.5 4.5M8 8 3.5 3.5M12 8l4.5-4.5M3.5 6.5v-3h3M13.5 3.5h3v3M16.5 13.5v3h-3M6.5 16.5h-3v-3',
  palette:
    'M10 3a7 7 0 1 0 0 14c1.4 0 1.7-.9 1.2-1.8-.6-1.1.1-2.2 1.4-2.2H15a2.5 2.5 0 0 0 2-2.6C17 6.3 13.9 3 10 3zM6.5 10h.01M8 6.7h.01M12 6.7h.01',
  parts: 'M3.5 6h13v8h-13zM6.8 10h.01M10 10h.01M13.2 10h.01',
  minus: 'M4 10h12',
  plus: 'M10 4v12M4 10h12',
  new: 'M5 3h6.5L15 6.5V17H5zM11.5 3v3.5H15M10 9.5v4.5M7.7 11.7h4.6',
  all: 'M3.5 3.5h2M8 3.5h4M14.5 3.5h2v2M16.5 8v4M16.5 14.5v2h-2M12 16.5H8M5.5 16.5h-2v-2M3.5 12V8M3.5 5.5v-2M7 10l2 2 4-4',
} as const;

/** Name of one icon of the family. */
export type IconName = keyof typeof PATHS;

/** Draws one icon; it is decoration, so its button must carry the name. */
export function Icon({ name }: { readonly name: IconName }) {
  return (
    <svg class="icon" viewBox="0 0 20 20" aria-hidden="true">
      <path d={PATHS[name]} />
    </svg>
  );
}
