import type { Certificate } from './certificate.ts';
import type { ProofProgress } from './prove.ts';

/** The one message to a prover, which has one proof to find and is ended then. */
export interface ToProver {
  readonly placementsJson: string;
}

export type FromProver =
  | { readonly kind: 'progress'; readonly progress: ProofProgress }
  | { readonly kind: 'proved'; readonly certificate: Certificate }
  /** No memory, or a bug. */
  | { readonly kind: 'failed'; readonly message: string };
