import { ALTERNATIVES_DE } from '../text/de/alternatives.ts';
import { ALTERNATIVES_EN } from '../text/en/alternatives.ts';
import { chooseWords } from '../text/language.ts';

export const alternativeWords = chooseWords(ALTERNATIVES_EN, ALTERNATIVES_DE);
