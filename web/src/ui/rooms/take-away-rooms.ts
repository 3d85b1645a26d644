import { chooseWords } from '../text/language.ts';
import type { Room } from './room.ts';

export const ROOM_TITLES = chooseWords(
  {
    instructions: 'Building instructions',
    share: 'Share and download',
    gallery: 'Gallery',
    lessons: 'Lessons',
    laboratory: 'Laboratory',
    linkage: 'Machine from a path',
  } as const,
  {
    instructions: 'Bauanleitung',
    share: 'Teilen und herunterladen',
    gallery: 'Galerie',
    lessons: 'Lektionen',
    laboratory: 'Labor',
    linkage: 'Maschine aus einer Bahn',
  },
);

/** The rooms that take a model away from the screen, and those that teach. */
export const TAKE_AWAY_ROOMS: readonly Room[] = [
  {
    id: 'instructions',
    title: ROOM_TITLES.instructions,
    load: () => import('../instructions/instructions-room.tsx').then((m) => m.InstructionsRoom),
  },
  {
    id: 'share',
    title: ROOM_TITLES.share,
    load: () => import('../share/share-room.tsx').then((m) => m.ShareRoom),
  },
  {
    id: 'gallery',
    title: ROOM_TITLES.gallery,
    load: () => import('../gallery/gallery-room.tsx').then((m) => m.GalleryRoom),
  },
  {
    id: 'lessons',
    title: ROOM_TITLES.lessons,
    load: () => import('../lessons/lessons-room.tsx').then((m) => m.LessonsRoom),
  },
  {
    id: 'laboratory',
    title: ROOM_TITLES.laboratory,
    load: () => import('../laboratory/laboratory-room.tsx').then((m) => m.LaboratoryRoom),
  },
  {
    id: 'linkage',
    title: ROOM_TITLES.linkage,
    load: () => import('../linkages/linkage-room.tsx').then((m) => m.LinkageRoom),
  },
];
