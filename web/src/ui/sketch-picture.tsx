import type { Vec3 } from '../geometry/vec.ts';
import { lineLength, type SketchDocument } from '../model/sketch.ts';

const SIZE = 120;
const PAD = 10;

/** A point as seen from the corner, before it is scaled: x to the right, y down. */
function flat(p: Vec3): readonly [number, number] {
  return [(p[0] - p[1]) * 0.866, (p[0] + p[1]) * 0.36 - p[2] * 0.93];
}

/** A sketch as a small drawing: cheap enough to show twenty of them. */
export function SketchPicture({ sketch }: { readonly sketch: SketchDocument }) {
  const ends = sketch.lines.flatMap((line) => [flat(line.from), flat(line.to)]);
  const xs = ends.map(([x]) => x);
  const ys = ends.map(([, y]) => y);
  const [x0, x1] = [Math.min(...xs), Math.max(...xs)];
  const [y0, y1] = [Math.min(...ys), Math.max(...ys)];
  const scale = (SIZE - 2 * PAD) / Math.max(x1 - x0, y1 - y0, 1);
  const place = (p: Vec3) => {
    const [x, y] = flat(p);
    const px = SIZE / 2 + (x - (x0 + x1) / 2) * scale;
    const py = SIZE / 2 + (y - (y0 + y1) / 2) * scale;
    return `${px.toFixed(1)} ${py.toFixed(1)}`;
  };
  const path = sketch.lines
    .filter((line) => lineLength(line) > 0)
    .map((line) => `M${place(line.from)}L${place(line.to)}`)
    .join('');
  return (
    <svg class="sketch-picture" viewBox={`0 0 ${SIZE} ${SIZE}`} aria-hidden="true">
      <path d={path} />
    </svg>
  );
}
