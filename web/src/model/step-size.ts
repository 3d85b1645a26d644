/** What a step of the instructions asks for at most: one part for a beginner, six for an expert. */
export const PARTS_A_STEP = { least: 1, usual: 3, most: 6 } as const;
