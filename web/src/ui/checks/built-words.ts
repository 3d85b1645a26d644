import { BUILT_DE } from '../text/de/built.ts';
import { BUILT_EN } from '../text/en/built.ts';
import { chooseWords } from '../text/language.ts';

export const builtWords = chooseWords(BUILT_EN, BUILT_DE);
