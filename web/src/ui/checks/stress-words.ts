import { STRESS_DE } from '../text/de/stress.ts';
import { STRESS_EN } from '../text/en/stress.ts';
import { chooseWords } from '../text/language.ts';

export const stressWords = chooseWords(STRESS_EN, STRESS_DE);
