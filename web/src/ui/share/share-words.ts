import { SHARE_DE } from '../text/de/share.ts';
import { SHARE_EN } from '../text/en/share.ts';
import { chooseWords } from '../text/language.ts';

export const shareWords = chooseWords(SHARE_EN, SHARE_DE);
