/** The mark in the browser's timeline when a model is on screen for the first time, all of its parts drawn. */
export const FIRST_MODEL = 'liftarm-first-model';
/** The mark when what a visit begins with is over: the model is drawn, and the solver was there for it. */
export const SETTLED = 'liftarm-settled';
