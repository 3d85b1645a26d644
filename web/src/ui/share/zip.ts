/** A file of a ZIP archive. */
export interface ZipEntry {
  /** ASCII, with `/` between folders. */
  readonly name: string;
  readonly content: Uint8Array;
}

// Pictures do not get smaller by packing them twice: entries are stored as they are, and that part of the
// format (APPNOTE 4.3: local headers, central directory, its end) is short enough to write here.

const VERSION = 20;
/** The first of January 1980, the zero of the format: the same pictures give the same file. */
const DATE = 0x21;

/** One archive of all entries. @throws Error above four gigabytes or 65,535 entries. */
export function zipOf(entries: readonly ZipEntry[]): Blob {
  const parts: Uint8Array<ArrayBuffer>[] = [];
  const directory: Uint8Array<ArrayBuffer>[] = [];
  let offset = 0;
  for (const { name, content } of entries) {
    const letters = new TextEncoder().encode(name);
    const shared = [VERSION, 0, 0, 0, DATE];
    const sizes = [crc32(content), content.length, content.length];
    const local = [...u32(0x04034b50), ...shared.flatMap(u16), ...sizes.flatMap(u32)];
    const header = bytes([...local, ...u16(letters.length), ...u16(0), ...letters]);
    directory.push(
      bytes([
        ...u32(0x02014b50),
        ...u16(VERSION),
        ...shared.flatMap(u16),
        ...sizes.flatMap(u32),
        ...[letters.length, 0, 0, 0, 0].flatMap(u16),
        ...[0, offset].flatMap(u32),
        ...letters,
      ]),
    );
    parts.push(header, content as Uint8Array<ArrayBuffer>);
    offset += header.length + content.length;
  }
  const size = directory.reduce((sum, row) => sum + row.length, 0);
  if (offset + size > 0xffffffff || entries.length > 0xffff) {
    throw new Error('too much for one archive');
  }
  const count = u16(entries.length);
  const end = [...u32(0x06054b50), 0, 0, 0, 0, ...count, ...count, ...u32(size), ...u32(offset)];
  return new Blob([...parts, ...directory, bytes([...end, 0, 0])], { type: 'application/zip' });
}

function bytes(values: readonly number[]): Uint8Array<ArrayBuffer> {
  return new Uint8Array(values);
}

function u16(value: number): number[] {
  return [value & 0xff, (value >>> 8) & 0xff];
}

function u32(value: number): number[] {
  return [...u16(value & 0xffff), ...u16(value >>> 16)];
}

/** The check sum of ZIP and PNG: polynomial 0xedb88320, bit by bit in a table. */
export function crc32(content: Uint8Array): number {
  let sum = 0xffffffff;
  for (const byte of content) {
    sum = (sum >>> 8) ^ (TABLE[(sum ^ byte) & 0xff] ?? 0);
  }
  return (sum ^ 0xffffffff) >>> 0;
}

const TABLE = Array.from({ length: 256 }, (_, start) => {
  let value = start;
  for (let bit = 0; bit < 8; bit++) {
    value = value & 1 ? (value >>> 1) ^ 0xedb88320 : value >>> 1;
  }
  return value;
});
