// Other programs that read what the page writes: a file is right when somebody else can open it.
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdtempSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Page } from '@playwright/test';

function stored(name: string, content: Buffer): string {
  const file = join(mkdtempSync(join(tmpdir(), 'liftarm-file-')), name);
  writeFileSync(file, content);
  return file;
}

export interface PdfFacts {
  readonly title: string;
  readonly pages: number;
  /** Points. */
  readonly width: number;
  readonly height: number;
  /** What each page says. */
  readonly texts: readonly string[];
}

/** What poppler finds in a PDF. */
export function readPdf(content: Buffer): PdfFacts {
  const file = stored('a.pdf', content);
  const info = execFileSync('pdfinfo', [file], { encoding: 'utf8' });
  const field = (name: string) => new RegExp(`^${name}:\\s*(.*)$`, 'm').exec(info)?.[1] ?? '';
  const [width = 0, height = 0] = field('Page size').split(' x ').map(Number.parseFloat);
  const text = execFileSync('pdftotext', ['-layout', file, '-'], { encoding: 'utf8' });
  const texts = text.split('\f').slice(0, -1);
  return { title: field('Title'), pages: Number(field('Pages')), width, height, texts };
}

/** Names and sizes of the entries of a ZIP archive, from Python's reader, which checks their sums. */
export function readZip(content: Buffer): readonly (readonly [string, number])[] {
  const script = `
import json, sys, zipfile
with zipfile.ZipFile(sys.argv[1]) as archive:
    assert archive.testzip() is None
    print(json.dumps([[entry.filename, entry.file_size] for entry in archive.infolist()]))
`;
  const out = execFileSync('python3', ['-c', script, stored('a.zip', content)], {
    encoding: 'utf8',
  });
  return JSON.parse(out) as [string, number][];
}

/** Lets CalculiX solve a deck. @returns what it prints. */
export function solveDeck(content: Buffer): string {
  const file = stored('deck.inp', content);
  const run = spawnSync('ccx', ['-i', 'deck'], { cwd: join(file, '..'), encoding: 'utf8' });
  return `${run.stdout}${run.stderr}`;
}

export interface ImageFacts {
  readonly width: number;
  readonly height: number;
  /** Shares of the pixels. */
  readonly clear: number;
  readonly solid: number;
}

/** What the browser sees in a picture. */
export function readImage(page: Page, content: Buffer, type: string): Promise<ImageFacts> {
  return page.evaluate(
    async ({ base64, kind }) => {
      const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
      const image = await createImageBitmap(new Blob([bytes], { type: kind }));
      const { width, height } = image;
      const context = new OffscreenCanvas(width, height).getContext('2d');
      context?.drawImage(image, 0, 0);
      const data = context?.getImageData(0, 0, width, height).data ?? new Uint8ClampedArray();
      let clear = 0;
      let solid = 0;
      for (let i = 3; i < data.length; i += 4) {
        clear += data[i] === 0 ? 1 : 0;
        solid += data[i] === 255 ? 1 : 0;
      }
      const all = width * height;
      return { width, height, clear: clear / all, solid: solid / all };
    },
    { base64: content.toString('base64'), kind: type },
  );
}

/** How many pictures an animated GIF has. */
export function countFrames(page: Page, content: Buffer): Promise<number> {
  return page.evaluate(async (base64) => {
    const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    const decoder = new ImageDecoder({ data: bytes, type: 'image/gif' });
    await decoder.completed;
    await decoder.tracks.ready;
    return decoder.tracks.selectedTrack?.frameCount ?? 0;
  }, content.toString('base64'));
}

/** Size in pixels and length in seconds of a video, in a page without our rules. */
export async function readVideo(
  page: Page,
  content: Buffer,
  type: string,
): Promise<{ width: number; height: number; seconds: number }> {
  const blank = await page.context().newPage();
  try {
    return await blank.evaluate(
      ({ base64, kind }) => {
        const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
        const video = document.createElement('video');
        video.src = URL.createObjectURL(new Blob([bytes], { type: kind }));
        return new Promise<{ width: number; height: number; seconds: number }>((done, fail) => {
          video.onloadedmetadata = () =>
            done({ width: video.videoWidth, height: video.videoHeight, seconds: video.duration });
          video.onerror = () => fail(new Error(video.error?.message));
        });
      },
      { base64: content.toString('base64'), kind: type },
    );
  } finally {
    await blank.close();
  }
}

/** The elements of a well-formed XML document, by name. @throws where it is not well-formed. */
export function readXml(page: Page, content: Buffer): Promise<Readonly<Record<string, number>>> {
  return page.evaluate((text) => {
    const document = new DOMParser().parseFromString(text, 'application/xml');
    const fault = document.querySelector('parsererror');
    if (fault) {
      throw new Error(fault.textContent);
    }
    const counts: Record<string, number> = {};
    for (const { tagName } of document.querySelectorAll('*')) {
      counts[tagName] = (counts[tagName] ?? 0) + 1;
    }
    return counts;
  }, content.toString('utf8'));
}

export interface StlFacts {
  readonly triangles: number;
  /** Millimetres. */
  readonly size: readonly number[];
  /** Cubic millimetres inside the surfaces. */
  readonly volume: number;
}

/** Reads a binary STL file. @throws where a number is none or the file ends too early or late. */
export function readStl(content: Buffer): StlFacts {
  const triangles = content.readUInt32LE(80);
  if (content.length !== 84 + 50 * triangles) {
    throw new Error(`${content.length} bytes for ${triangles} triangles`);
  }
  const min = [Infinity, Infinity, Infinity];
  const max = [-Infinity, -Infinity, -Infinity];
  let volume = 0;
  for (let t = 0; t < triangles; t++) {
    const at = (k: number) => content.readFloatLE(84 + 50 * t + 12 + 4 * k);
    const [ax, ay, az, bx, by, bz, cx, cy, cz] = Array.from({ length: 9 }, (_, k) => at(k)) as [
      ...[number, number, number],
      ...[number, number, number],
      ...[number, number, number],
    ];
    if (![ax, ay, az, bx, by, bz, cx, cy, cz].every(Number.isFinite)) {
      throw new Error(`triangle ${t} is not a triangle`);
    }
    volume += ax * (by * cz - bz * cy) - ay * (bx * cz - bz * cx) + az * (bx * cy - by * cx);
    for (let k = 0; k < 9; k++) {
      min[k % 3] = Math.min(min[k % 3] ?? 0, at(k));
      max[k % 3] = Math.max(max[k % 3] ?? 0, at(k));
    }
  }
  return { triangles, size: max.map((value, k) => value - (min[k] ?? 0)), volume: volume / 6 };
}
