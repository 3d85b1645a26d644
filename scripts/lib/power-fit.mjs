// A power law through measured points: no packages, no files, so that it can be tested.

/**
 * Least squares of log y on log x: y = factor * x ^ exponent.
 * @param {{x: number, y: number}[]} points positive numbers; at least two different x.
 * @returns {{exponent: number, factor: number, rSquared: number} | null} null with too few points.
 */
export function fitPower(points) {
  const logs = points
    .filter(({ x, y }) => x > 0 && y > 0 && Number.isFinite(x) && Number.isFinite(y))
    .map(({ x, y }) => ({ u: Math.log(x), v: Math.log(y) }));
  const mean = (key) => logs.reduce((sum, point) => sum + point[key], 0) / logs.length;
  const meanU = mean('u');
  const meanV = mean('v');
  const sumOf = (f) => logs.reduce((sum, { u, v }) => sum + f(u - meanU, v - meanV), 0);
  const uu = sumOf((du) => du * du);
  const uv = sumOf((du, dv) => du * dv);
  const vv = sumOf((_, dv) => dv * dv);
  if (logs.length < 2 || uu === 0) {
    return null;
  }
  const exponent = uv / uu;
  return {
    exponent,
    factor: Math.exp(meanV - exponent * meanU),
    rSquared: vv === 0 ? 1 : (uv * uv) / (uu * vv),
  };
}
