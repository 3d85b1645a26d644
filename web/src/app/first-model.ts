/** The mark in the browser's timeline when the first model of a sketch is shown. */
export const FIRST_MODEL = 'liftarm-first-model';
