import { LINKAGES_DE } from '../text/de/linkages.ts';
import { LINKAGES_EN } from '../text/en/linkages.ts';
import { chooseWords } from '../text/language.ts';

export const linkageWords = chooseWords(LINKAGES_EN, LINKAGES_DE);
