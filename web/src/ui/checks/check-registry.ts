import type { ComponentType } from 'preact';
import type { Page, ShownModel } from '../page.ts';
import { BALANCE_CHECK } from './balance.tsx';
import { FREEDOMS_CHECK } from './freedoms.tsx';
import { JOINTS_CHECK } from './joints.tsx';
import { PROOF_CHECK } from './proof.tsx';
import { STRESS_CHECK } from './stress.tsx';

/** How a check stands: met, not met, nothing to say, or still being computed. */
export interface CheckStatus {
  readonly state: 'ok' | 'bad' | 'none' | 'busy';
  /** A number with its unit, such as `3.2 N`; empty when there is none. */
  readonly number: string;
}

export interface CheckProps {
  readonly shown: ShownModel;
}

/** One further check of the model on screen: a line in the result panel that opens to a picture. */
export interface CheckView {
  readonly id: string;
  readonly title: string;
  /** Reads signals; called whenever one of them changes. */
  readonly status: (page: Page, shown: ShownModel) => CheckStatus;
  /** What the line opens to. Mounted while it is open: start work and colour parts (Page.display) then. */
  readonly component: ComponentType<CheckProps>;
}

/** All further checks, in the order of the panel; a new one is a row here. */
export const CHECK_VIEWS: readonly CheckView[] = [
  FREEDOMS_CHECK,
  JOINTS_CHECK,
  BALANCE_CHECK,
  STRESS_CHECK,
  PROOF_CHECK,
];
