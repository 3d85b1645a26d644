import type { LinkageModule, LinkageTable } from './linkage-module.ts';

/** A hundredth of a second each, or so. */
const COUPLERS_AT_ONCE = 20;

/** The whole table. What is told of the way there arrives while it is made. */
export function makeTable(
  module: LinkageModule,
  onProgress: (fraction: number) => void = () => undefined,
): LinkageTable {
  const table = new module.LinkageTable();
  while (!table.advance(COUPLERS_AT_ONCE)) {
    onProgress(table.fraction());
  }
  return table;
}
