import { CONTEST_DE } from '../../text/de/contest.ts';
import { CONTEST_EN } from '../../text/en/contest.ts';
import { chooseWords } from '../../text/language.ts';

export const contestWords = chooseWords(CONTEST_EN, CONTEST_DE);
