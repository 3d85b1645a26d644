/** A file of the package; its files lie side by side, whatever bundles them. */
export function beside(file: string): URL {
  return new URL(file, import.meta.url);
}
