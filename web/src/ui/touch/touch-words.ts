import { TOUCH_DE } from '../text/de/touch.ts';
import { TOUCH_EN } from '../text/en/touch.ts';
import { chooseWords } from '../text/language.ts';

export const touchWords = chooseWords(TOUCH_EN, TOUCH_DE);
