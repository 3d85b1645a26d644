import type { Vec3 } from '../../geometry/vec.ts';
import type { Curve } from './angle-plot.tsx';

/** The angles and ways of one period as CSV: seconds, degrees, modules. */
export function motionTable(
  seconds: readonly number[],
  curves: readonly Curve[],
  traces: readonly (readonly Vec3[])[],
): string {
  const heads = [
    'seconds',
    ...curves.map(({ name }) => `${name} (degrees)`),
    ...traces.flatMap((_, i) => ['x', 'y', 'z'].map((axis) => `Point ${i + 1} ${axis}`)),
  ];
  const rows = seconds.map((second, k) => [
    second,
    ...curves.map(({ angles }) => angles[k] ?? 0),
    ...traces.flatMap((points) => points[k] ?? [0, 0, 0]),
  ]);
  const cells = (row: readonly number[]) => row.map((value) => rounded(value)).join(',');
  return `${heads.map(quoted).join(',')}\n${rows.map(cells).join('\n')}\n`;
}

function rounded(value: number): string {
  return String(Math.round(value * 10_000) / 10_000 + 0);
}

function quoted(name: string): string {
  return /[",\n]/.test(name) ? `"${name.replaceAll('"', '""')}"` : name;
}
