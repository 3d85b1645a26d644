/** Shares of zero bytes at even or odd places from which text is taken for UTF-16. */
const WIDE = 0.3;

/**
 * The text of a file, in the encodings that programs write: UTF-8, UTF-16 with or without its mark, and where bytes are
 * neither, Windows' Latin letters.
 */
export function decodeText(bytes: Uint8Array<ArrayBuffer>): string {
  const wide = wideEncoding(bytes);
  if (wide !== null) {
    return new TextDecoder(wide).decode(bytes);
  }
  try {
    return new TextDecoder('utf-8', { fatal: true }).decode(bytes);
  } catch {
    return new TextDecoder('windows-1252').decode(bytes);
  }
}

function wideEncoding(bytes: Uint8Array): 'utf-16le' | 'utf-16be' | null {
  const [a, b] = bytes;
  if (a === 0xff && b === 0xfe) {
    return 'utf-16le';
  }
  if (a === 0xfe && b === 0xff) {
    return 'utf-16be';
  }
  const peek = bytes.subarray(0, 512);
  const zeros = (odd: 0 | 1) => peek.filter((byte, i) => i % 2 === odd && byte === 0).length;
  const enough = (WIDE * peek.length) / 2;
  if (peek.length > 3 && zeros(1) > enough) {
    return 'utf-16le';
  }
  return peek.length > 3 && zeros(0) > enough ? 'utf-16be' : null;
}
