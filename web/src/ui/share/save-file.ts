/** Hands a file to the browser, which saves it where the person wants it. */
export function saveFile(name: string, content: Blob): void {
  const address = URL.createObjectURL(content);
  const link = document.createElement('a');
  link.href = address;
  link.download = name;
  link.click();
  // The browser reads the address after the click; a minute is plenty.
  setTimeout(() => URL.revokeObjectURL(address), 60_000);
}

/**
 * A file name from the name of a sketch: letters, digits, and hyphens for everything else.
 * `unnamed` stands where nothing is left.
 */
export function safeName(title: string, extension: string, unnamed = 'model'): string {
  const base = title
    .normalize('NFKD')
    .replace(/[^\p{L}\p{N}]+/gu, '-')
    .replace(/^-+|-+$/g, '')
    .toLowerCase()
    .slice(0, 60);
  return `${base || unnamed}.${extension}`;
}
