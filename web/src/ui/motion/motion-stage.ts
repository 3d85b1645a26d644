import { scale, type Vec3 } from '../../geometry/vec.ts';
import { modelCorners } from '../../model/bounds.ts';
import type { Catalogue } from '../../model/catalogue.ts';
import type { Model } from '../../model/model.ts';
import {
  type Course,
  degreesAt,
  type Moment,
  momentsOf,
  periodOf,
} from '../../model/motion-curves.ts';
import { mixedPoses } from '../../model/motion-mix.ts';
import { MotionTraces, type Trace } from '../../view/overlays/motion-traces.ts';
import { StillRenderer } from '../../view/still/still-renderer.ts';
import type { ColourScheme, ThemeName } from '../../view/view-types.ts';
import type { FilmSource } from '../instructions/film-export.ts';

export interface MotionFilm {
  readonly model: Model;
  readonly catalogue: Catalogue;
  readonly course: Course;
  /** From the eye into the picture. */
  readonly looking: Vec3;
  readonly colourBy: ColourScheme;
  readonly theme: ThemeName;
  /** The ways of points as they are at a moment. */
  readonly traces: (moment: Moment) => readonly Trace[];
}

/** Poses at which the picture is made large enough, of those of one period. */
const FRAMED = 12;

/** Draws any moment of one period of a motion. */
export class MotionStage implements FilmSource {
  readonly duration: number;
  readonly #film: MotionFilm;
  readonly #renderer: StillRenderer;
  readonly #traces = new MotionTraces();
  readonly #frame: readonly Vec3[];

  /** @throws Error when the browser cannot draw in 3D. */
  constructor(film: MotionFilm) {
    this.#film = film;
    this.duration = periodOf(film.course);
    this.#renderer = new StillRenderer(film.catalogue);
    const moments = momentsOf(film.course);
    const every = Math.max(1, Math.floor(moments.length / FRAMED));
    this.#frame = moments
      .filter((_, i) => i % every === 0)
      .flatMap(({ driven }) => modelCorners(posed(film.model, driven), film.catalogue));
  }

  get canvas(): HTMLCanvasElement {
    return this.#renderer.canvas;
  }

  draw(second: number, width: number, height: number): void {
    const { model, course, looking, colourBy, theme, traces } = this.#film;
    const [lead, ...others] = course.driven;
    if (!lead) {
      return;
    }
    const within = second % Math.max(1e-9, this.duration);
    const driven = [{ ...lead, degrees: degreesAt(course, within) }, ...others];
    this.#traces.set(traces({ second: within, driven }));
    this.#renderer.draw({
      parts: model.parts,
      width,
      height,
      frame: this.#frame,
      direction: scale(looking, -1),
      backdrop: 'studio',
      theme,
      colourBy,
      display: { poses: mixedPoses(driven) },
      overlays: [this.#traces],
    });
  }

  dispose(): void {
    this.#traces.dispose();
    this.#renderer.dispose();
  }
}

function posed(model: Model, driven: Moment['driven']): Model {
  const poses = mixedPoses(driven);
  const parts = model.parts.map((part, i) => ({ ...part, ...poses.get(i) }));
  return { ...model, parts };
}
