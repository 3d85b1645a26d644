import { INSTRUCTIONS_DE } from '../text/de/instructions.ts';
import { INSTRUCTIONS_EN } from '../text/en/instructions.ts';
import { chooseWords } from '../text/language.ts';

export const instructionWords = chooseWords(INSTRUCTIONS_EN, INSTRUCTIONS_DE);
