import { GALLERY_DE } from '../text/de/gallery.ts';
import { GALLERY_EN } from '../text/en/gallery.ts';
import { chooseWords } from '../text/language.ts';

export const galleryWords = chooseWords(GALLERY_EN, GALLERY_DE);
