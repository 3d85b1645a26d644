import type { DrawnSketch } from './pen.mjs';

export const DRAWINGS: Readonly<Record<string, () => DrawnSketch>>;
