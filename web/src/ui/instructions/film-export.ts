import { canvasToPng } from '../../view/still/canvas-png.ts';

/** What a film is made of: any moment of it, drawn on a canvas. */
export interface FilmSource {
  readonly canvas: HTMLCanvasElement;
  /** Seconds at speed 1. */
  readonly duration: number;
  /** @param second at speed 1. */
  draw(second: number, width: number, height: number): void;
}

export interface FilmFile {
  readonly extension: 'mp4' | 'webm' | 'gif' | 'zip';
  readonly content: Blob;
}

export interface FilmOptions {
  readonly speed: number;
  readonly signal: AbortSignal;
  /** @param share 0 to 1. */
  readonly onProgress: (share: number) => void;
}

const VIDEO = { width: 1280, height: 720, rate: 30 } as const;
const GIF = { width: 480, height: 360, rate: 10, colours: 128 } as const;
const PICTURES = { width: 960, height: 540, rate: 10 } as const;

/** Whether this browser can write videos. */
export function canWriteVideo(): boolean {
  return 'VideoEncoder' in globalThis;
}

/** The film as MP4 where the browser can, else as WebM. @throws Error when it can write neither. */
export async function writeVideo(stage: FilmSource, options: FilmOptions): Promise<FilmFile> {
  const media = await import('mediabunny');
  const { width, height, rate } = VIDEO;
  const mp4 = await media.getFirstEncodableVideoCodec(['avc', 'hevc'], { width, height });
  const codec =
    mp4 ?? (await media.getFirstEncodableVideoCodec(['vp9', 'vp8', 'av1'], { width, height }));
  if (!codec) {
    throw new Error('this browser can encode no video');
  }
  const target = new media.BufferTarget();
  const output = new media.Output({
    format: mp4 ? new media.Mp4OutputFormat() : new media.WebMOutputFormat(),
    target,
  });
  stage.draw(0, width, height);
  const source = new media.CanvasSource(stage.canvas, { codec, bitrate: media.QUALITY_HIGH });
  output.addVideoTrack(source, { frameRate: rate });
  await output.start();
  for (const frame of frames(stage, options, rate)) {
    stage.draw(frame.second, width, height);
    await source.add(frame.index / rate, 1 / rate);
    options.onProgress(frame.share);
    if (options.signal.aborted) {
      await output.cancel();
      throw new DOMException('stopped', 'AbortError');
    }
  }
  await output.finalize();
  if (!target.buffer) {
    throw new Error('the encoder gave nothing');
  }
  const type = mp4 ? 'video/mp4' : 'video/webm';
  return { extension: mp4 ? 'mp4' : 'webm', content: new Blob([target.buffer], { type }) };
}

/** The film as GIF: larger and coarser, but every browser can write it. */
export async function writeGif(stage: FilmSource, options: FilmOptions): Promise<FilmFile> {
  const { GIFEncoder, quantize, applyPalette } = await import('gifenc');
  const { width, height, rate, colours } = GIF;
  const gif = GIFEncoder();
  const copy = document.createElement('canvas');
  copy.width = width;
  copy.height = height;
  const context = copy.getContext('2d', { willReadFrequently: true });
  if (!context) {
    throw new Error('the browser gave no canvas');
  }
  for (const frame of frames(stage, options, rate)) {
    stage.draw(frame.second, width, height);
    context.drawImage(stage.canvas, 0, 0);
    const { data } = context.getImageData(0, 0, width, height);
    const palette = quantize(data, colours);
    gif.writeFrame(applyPalette(data, palette), width, height, { palette, delay: 1000 / rate });
    options.onProgress(frame.share);
    // The page stays alive, and the button to stop works.
    await new Promise((resolve) => setTimeout(resolve));
    options.signal.throwIfAborted();
  }
  gif.finish();
  const content = new Blob([gif.bytes() as Uint8Array<ArrayBuffer>], { type: 'image/gif' });
  return { extension: 'gif', content };
}

/** The film as numbered pictures in an archive, for programs that make a video of them. */
export async function writePictures(stage: FilmSource, options: FilmOptions): Promise<FilmFile> {
  const { zipSync } = await import('fflate');
  const { width, height, rate } = PICTURES;
  const entries: Record<string, Uint8Array> = {};
  for (const frame of frames(stage, options, rate)) {
    stage.draw(frame.second, width, height);
    const png = await canvasToPng(stage.canvas);
    const name = `frame-${`${frame.index + 1}`.padStart(5, '0')}.png`;
    entries[name] = new Uint8Array(await png.arrayBuffer());
    options.onProgress(frame.share);
    options.signal.throwIfAborted();
  }
  // Pictures do not get smaller by packing them twice.
  const archive = zipSync(entries, { level: 0 });
  return { extension: 'zip', content: new Blob([archive], { type: 'application/zip' }) };
}

function* frames(stage: FilmSource, options: FilmOptions, rate: number) {
  const count = Math.max(1, Math.ceil((stage.duration / options.speed) * rate));
  for (let index = 0; index < count; index++) {
    yield { index, second: (index / rate) * options.speed, share: (index + 1) / count };
  }
}
