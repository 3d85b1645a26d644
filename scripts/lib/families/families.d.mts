import type { SketchDocument } from '../../../web/src/model/sketch.ts';

export function gridSketch(n: number): SketchDocument;
export function cubeSketch(side: number): SketchDocument;
