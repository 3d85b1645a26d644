import { useState } from 'preact/hooks';
import type { Vec3 } from '../../geometry/vec.ts';
import { modelCorners } from '../../model/bounds.ts';
import type { Catalogue } from '../../model/catalogue.ts';
import type { PlacedPart } from '../../model/model.ts';
import { posesAt } from '../../model/motion.ts';
import type { PartDisplay } from '../../view/view-types.ts';
import { JointList } from '../checks/joints.tsx';
import { MotionStudy } from '../checks/motion-study.ts';
import { type Turnable, turnablesOf } from '../checks/turnables.ts';
import { type SolvedParts, solveSketch } from '../share/solved-parts.ts';
import { type GalleryRow, loadGallerySketch, loadMade } from './gallery-index.ts';
import { GalleryView, type GalleryViewProps } from './gallery-view.tsx';
import { galleryWords as words } from './gallery-words.ts';
import { MovingPicture } from './moving-picture.tsx';

interface Moving {
  readonly parts: readonly PlacedPart[];
  readonly study: MotionStudy;
  readonly turnables: readonly Turnable[];
  readonly frame: readonly Vec3[];
}

/** A gallery model whose joints and shafts turn: each by its own slider, within its range. */
export function JointView(props: GalleryViewProps) {
  return (
    <GalleryView {...props} load={load}>
      {(moving) => <Joints moving={moving} />}
    </GalleryView>
  );
}

function Joints({ moving }: { readonly moving: Moving }) {
  const [display, setDisplay] = useState<PartDisplay | null>(null);
  const { parts, frame, turnables, study } = moving;
  return (
    <div class="gallery-moving">
      <MovingPicture parts={parts} frame={frame} display={display} label={words.jointsLabel} />
      <JointList joints={turnables} study={study} onDisplay={setDisplay} />
    </div>
  );
}

async function load(row: GalleryRow, preset: string, catalogue: Catalogue): Promise<Moving> {
  const { sketch } = await loadGallerySketch(row);
  const { json, parts } =
    (await madeParts(row, preset)) ?? (await solveSketch(sketch, { preset, seed: 1 }));
  const study = new MotionStudy(json);
  const turnables = turnablesOf(await study.answer(), sketch);
  return { parts, study, turnables, frame: await sweptPoints(parts, study, turnables, catalogue) };
}

/** The model that comes with the page, if it is one of this preset. */
async function madeParts(
  row: GalleryRow,
  preset: string,
): Promise<Pick<SolvedParts, 'json' | 'parts'> | null> {
  const made = row.made ? await loadMade(row).catch(() => null) : null;
  if (made?.settings.preset !== preset) {
    return null;
  }
  const json = made.modelJson;
  return { json, parts: (JSON.parse(json) as Pick<SolvedParts, 'parts'>).parts };
}

/** Corners of all places that the parts come to, so that nothing leaves the picture. */
async function sweptPoints(
  parts: readonly PlacedPart[],
  study: MotionStudy,
  turnables: readonly Turnable[],
  catalogue: Catalogue,
): Promise<Vec3[]> {
  const points = modelCorners({ name: '', parts }, catalogue);
  for (const { mover, turns } of turnables) {
    const path = turns ? await study.path(mover) : null;
    for (const degrees of path?.angles ?? []) {
      const poses = path ? posesAt(path, degrees) : new Map();
      const moved = parts.flatMap((part, i) => {
        const pose = poses.get(i);
        return pose ? [{ ...part, ...pose }] : [];
      });
      points.push(...modelCorners({ name: '', parts: moved }, catalogue));
    }
  }
  return points;
}
