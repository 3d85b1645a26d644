import type { Download, Page } from '@playwright/test';
import { linkOf, publicSketch } from './links.ts';
import { expect } from './test.ts';

/** Opens a public sketch with a room, and waits until its model is there. */
export async function openModelRoom(page: Page, room: string, sketch: string): Promise<void> {
  const link = await linkOf(publicSketch(sketch));
  await page.goto(`./?room=${room}${link}`);
  // Behind the room, the drawing says how the search ended.
  await expect(page.getByTestId('verdict')).toBeAttached({ timeout: 90_000 });
}

/** The bytes of the file that a click downloads. */
export async function bytesOf(page: Page, click: () => Promise<void>): Promise<Buffer> {
  const [file] = await Promise.all([page.waitForEvent('download', { timeout: 200_000 }), click()]);
  return readDownload(file);
}

async function readDownload(file: Download): Promise<Buffer> {
  const stream = await file.createReadStream();
  const chunks: Buffer[] = [];
  for await (const chunk of stream) {
    chunks.push(chunk as Buffer);
  }
  return Buffer.concat(chunks);
}
