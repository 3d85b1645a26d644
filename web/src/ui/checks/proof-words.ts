import { PROOF_DE } from '../text/de/proof.ts';
import { PROOF_EN } from '../text/en/proof.ts';
import { chooseWords } from '../text/language.ts';

export const proofWords = chooseWords(PROOF_EN, PROOF_DE);
