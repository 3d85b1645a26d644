import { IDENTITY, ORIGIN } from '../../geometry/vec.ts';
import type { Catalogue } from '../../model/catalogue.ts';
import { StillRenderer } from './still-renderer.ts';

const SIZE = { width: 160, height: 112 } as const;
/** From the part to the eye: along the holes of a beam enough to see that they are holes. */
const DIRECTION = [0.45, -1, 0.62] as const;

/** Pictures of single parts, made one after the other between frames, each once. */
export class Thumbnails {
  readonly #catalogue: Catalogue;
  readonly #pictures = new Map<string, Promise<string>>();
  #renderer: StillRenderer | null = null;
  #last: Promise<unknown> = Promise.resolve();

  constructor(catalogue: Catalogue) {
    this.#catalogue = catalogue;
  }

  /** Address of a part's picture, good as long as the page. Rejects without WebGL. */
  picture(id: string): Promise<string> {
    const known = this.#pictures.get(id);
    if (known !== undefined) {
      return known;
    }
    const picture = this.#last.then(nextFrame).then(() => this.#draw(id));
    this.#last = picture.catch(() => undefined);
    this.#pictures.set(id, picture);
    return picture;
  }

  async #draw(id: string): Promise<string> {
    this.#renderer ??= new StillRenderer(this.#catalogue);
    const color = this.#catalogue.find(id)?.color ?? 71;
    const place = { position: ORIGIN, rotation: IDENTITY, component: -1, layer: 0, piece: 0 };
    const blob = await this.#renderer.png({
      ...SIZE,
      parts: [{ part: id, color, ...place }],
      direction: DIRECTION,
      projection: 'orthographic',
    });
    return URL.createObjectURL(blob);
  }
}

function nextFrame(): Promise<void> {
  return new Promise((resolve) => {
    setTimeout(resolve, 16);
  });
}
