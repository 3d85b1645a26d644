/** The mark in the browser's timeline when a model is on screen for the first time, all of its parts drawn. */
export const FIRST_MODEL = 'liftarm-first-model';
