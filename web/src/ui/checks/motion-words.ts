import { MOTION_DE } from '../text/de/motion.ts';
import { MOTION_EN } from '../text/en/motion.ts';
import { chooseWords } from '../text/language.ts';

export const motionWords = chooseWords(MOTION_EN, MOTION_DE);
