import type { MadeModel } from './made-model.ts';
import type { SolveSettings } from './protocol.ts';

// Models that come with the page, in files of their own: JSON, packed (deflate without a head), written by
// scripts/gallery.mjs.

/** A model as it was made: its sketch has a file of its own, its layout comes when the model is confirmed. */
export type MadeParts = Omit<MadeModel, 'sketch' | 'layoutJson'>;

const TEXTS = ['modelJson', 'reportJson', 'checkJson'] as const;

/** @throws Error when the bytes are no such file. */
export async function unpackMade(bytes: ArrayBuffer): Promise<MadeParts> {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate-raw'));
  const value: unknown = await new Response(stream).json();
  if (!isMade(value)) {
    throw new Error('the model that came with the page is unreadable');
  }
  return value;
}

function isMade(value: unknown): value is MadeParts {
  if (typeof value !== 'object' || value === null) {
    return false;
  }
  const { settings, ...texts } = value as Record<string, unknown>;
  return TEXTS.every((key) => typeof texts[key] === 'string') && isSettings(settings);
}

function isSettings(value: unknown): value is SolveSettings {
  return typeof value === 'object' && value !== null && 'seed' in value && 'preset' in value;
}
