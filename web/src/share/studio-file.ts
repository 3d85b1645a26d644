import { bad, good, type Outcome } from '../base/outcome.ts';

// Studio's files (.io) are archives, some closed with the password that is the same for all of them, with the model as
// LDraw inside. Other archives with a model in them are opened too.

const STUDIO_PASSWORD = 'soho0909';
const MODEL_NAME = /\.(ldr|mpd)$/i;
const FIRST_CHOICE = /^model\.ldr$/i;
/** Of the model when it is unpacked. */
const MAX_BYTES = 32 * 2 ** 20;
const MAX_ENTRIES = 10_000;

export const ARCHIVE_FAULTS = {
  none: 'the archive holds no model (.ldr or .mpd)',
  locked: 'the archive is closed with a password that is not known here',
  large: 'the model in the archive is larger than 32 MB, which is the limit',
  broken: 'the archive is damaged',
} as const;

export function looksLikeArchive(bytes: Uint8Array): boolean {
  return bytes[0] === 0x50 && bytes[1] === 0x4b && bytes[2] === 3 && bytes[3] === 4;
}

/** The model in an archive, or one sentence. */
export async function modelInArchive(
  bytes: Uint8Array<ArrayBuffer>,
): Promise<Outcome<Uint8Array<ArrayBuffer>>> {
  const zip = await import('@zip.js/zip.js/index-native.js');
  const reader = new zip.ZipReader(new zip.Uint8ArrayReader(bytes), {
    password: STUDIO_PASSWORD,
    useWebWorkers: false,
  });
  try {
    const files: { readonly name: string; readonly size: number; read(): Promise<Uint8Array> }[] =
      [];
    for await (const entry of reader.getEntriesGenerator()) {
      if (!entry.directory && MODEL_NAME.test(entry.filename) && files.length < MAX_ENTRIES) {
        const read = () => entry.getData(new zip.Uint8ArrayWriter());
        files.push({ name: entry.filename, size: entry.uncompressedSize, read });
      }
    }
    const chosen = files.find(({ name }) => FIRST_CHOICE.test(name)) ?? files[0];
    if (!chosen) {
      return bad(ARCHIVE_FAULTS.none);
    }
    if (chosen.size > MAX_BYTES) {
      return bad(ARCHIVE_FAULTS.large);
    }
    return good(new Uint8Array(await chosen.read()));
  } catch (error) {
    const message = error instanceof Error ? error.message : '';
    const locked = [zip.ERR_ENCRYPTED, zip.ERR_INVALID_PASSWORD, zip.ERR_UNSUPPORTED_ENCRYPTION];
    return bad(locked.includes(message) ? ARCHIVE_FAULTS.locked : ARCHIVE_FAULTS.broken);
  } finally {
    await reader.close().catch(() => undefined);
  }
}
