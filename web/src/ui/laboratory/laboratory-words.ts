import { LABORATORY_DE } from '../text/de/laboratory.ts';
import { LABORATORY_EN } from '../text/en/laboratory.ts';
import { chooseWords } from '../text/language.ts';

export const laboratoryWords = chooseWords(LABORATORY_EN, LABORATORY_DE);
