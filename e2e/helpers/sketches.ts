/** The text of a sketch file: a scaffold of `n` by `n` cells in two storeys; a large one takes a while. */
export function scaffold(n: number): string {
  const lines: unknown[] = [];
  const end = 4 * n;
  for (let i = 0; i <= n; i++) {
    for (let k = 0; k <= 2; k++) {
      lines.push({ from: [0, 4 * i, 6 * k], to: [end, 4 * i, 6 * k] });
      lines.push({ from: [4 * i, 0, 6 * k], to: [4 * i, end, 6 * k] });
    }
    for (let j = 0; j <= n; j++) {
      lines.push({ from: [4 * i, 4 * j, 0], to: [4 * i, 4 * j, 12] });
    }
  }
  return JSON.stringify({ format: 'technic-sketch', version: 1, name: 'Scaffold', lines });
}
