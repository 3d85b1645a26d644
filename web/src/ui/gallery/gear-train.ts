import { bad, good, type Outcome } from '../../base/outcome.ts';
import { type Mat3, multiply, type Vec3 } from '../../geometry/vec.ts';
import type { Catalogue } from '../../model/catalogue.ts';
import type { PlacedPart } from '../../model/model.ts';

// Gears on shafts along y, added to a gallery model as fixed parts of its own: the sketch holds the
// frame, its exact lines hold the bearings, its keep-out box holds the room.

/** A part on a shaft; `along` is its place on the shaft's axis, modules. */
export interface ShaftPart {
  readonly part: string;
  readonly color: number;
  readonly along: number;
}

/** An axle along y through `at` with what sits on it; all of it turns as one. */
export interface Shaft {
  readonly at: Vec3;
  readonly parts: readonly ShaftPart[];
}

/** Two gears that mesh: shaft numbers and teeth. */
export interface Mesh {
  readonly a: number;
  readonly b: number;
  readonly teethA: number;
  readonly teethB: number;
}

export interface GearTrain {
  readonly shafts: readonly Shaft[];
  readonly meshes: readonly Mesh[];
  /** Turns of each shaft for one turn of the first; negative the other way round. */
  readonly speeds: readonly number[];
  /** Radians that each shaft is turned at rest, so that teeth meet gaps. */
  readonly phases: readonly number[];
}

/** Technic gears are of module 1 mm: two gears mesh at (teeth + teeth) / 16 modules of 8 mm. */
const TEETH_PER_MODULE = 16;
const TOLERANCE = 1e-3;
/** Turns a part whose own axis is x to the shaft's y. */
const X_TO_Y: Mat3 = [0, -1, 0, 1, 0, 0, 0, 0, 1];

/** Teeth of a gear, 0 for every other part. */
export function teethOf(part: string, catalogue: Catalogue): number {
  const known = catalogue.find(part);
  return known?.partClass === 'gear' ? Number(/(\d+) Tooth/.exec(known.name)?.[1] ?? 0) : 0;
}

/** Reads a gears file. @returns the train, or one sentence that says why it cannot turn. */
export function readGearTrain(json: unknown, catalogue: Catalogue): Outcome<GearTrain> {
  const shafts = readShafts(json);
  if (!shafts) {
    return bad('gears: should be a list of shafts with at and parts');
  }
  const unknown = shafts.flatMap((s) => s.parts).find((p) => !catalogue.find(p.part));
  if (unknown) {
    return bad(`gears: part ${unknown.part} is not in the catalogue`);
  }
  const meshes = findMeshes(shafts, catalogue);
  const speeds: number[] = [1];
  const phases: number[] = [0];
  for (let changed = true; changed; ) {
    changed = false;
    for (const mesh of meshes) {
      changed = spread(shafts, mesh, speeds, phases) || changed;
    }
  }
  if (shafts.some((_, i) => speeds[i] === undefined)) {
    return bad('gears: a shaft meshes with no other');
  }
  const locked = meshes.find(
    (mesh) =>
      Math.abs((speeds[mesh.a] ?? 0) * mesh.teethA + (speeds[mesh.b] ?? 0) * mesh.teethB) > 1e-9,
  );
  return locked ? bad('gears: the train is locked') : good({ shafts, meshes, speeds, phases });
}

function spread(shafts: readonly Shaft[], mesh: Mesh, speeds: number[], phases: number[]): boolean {
  const forward = speeds[mesh.a] !== undefined;
  const [a, b] = forward ? [mesh.a, mesh.b] : [mesh.b, mesh.a];
  const [ta, tb] = forward ? [mesh.teethA, mesh.teethB] : [mesh.teethB, mesh.teethA];
  const from = shafts[a];
  const to = shafts[b];
  const speed = speeds[a];
  if (speed === undefined || speeds[b] !== undefined || !from || !to) {
    return false;
  }
  speeds[b] = (-speed * ta) / tb;
  // Angles count from +x towards -z, which is how +y turns.
  const toward = Math.atan2(-(to.at[2] - from.at[2]), to.at[0] - from.at[0]);
  const share = ((toward - (phases[a] ?? 0)) * ta) / (2 * Math.PI);
  // A tooth of one at the point of contact asks for a gap of the other.
  phases[b] = toward + Math.PI - (2 * Math.PI * (0.5 - share)) / tb;
  return true;
}

function findMeshes(shafts: readonly Shaft[], catalogue: Catalogue): Mesh[] {
  const gears = shafts.flatMap((shaft, index) =>
    shaft.parts.flatMap((part) => {
      const teeth = teethOf(part.part, catalogue);
      return teeth > 0 ? [{ index, teeth, at: shaft.at, along: part.along }] : [];
    }),
  );
  return gears.flatMap((p, i) =>
    gears.slice(i + 1).flatMap((q) => {
      const distance = Math.hypot(p.at[0] - q.at[0], p.at[2] - q.at[2]);
      const right = Math.abs(distance - (p.teeth + q.teeth) / TEETH_PER_MODULE) < TOLERANCE;
      return p.index !== q.index && right && Math.abs(p.along - q.along) < 0.5
        ? [{ a: p.index, b: q.index, teethA: p.teeth, teethB: q.teeth }]
        : [];
    }),
  );
}

/** The train's parts in their places. @param turn radians of the first shaft. */
export function placeTrain(train: GearTrain, turn: number, catalogue: Catalogue): PlacedPart[] {
  return train.shafts.flatMap((shaft, i) => {
    const angle = (train.phases[i] ?? 0) + turn * (train.speeds[i] ?? 0);
    const spin: Mat3 = [
      Math.cos(angle),
      0,
      Math.sin(angle),
      0,
      1,
      0,
      -Math.sin(angle),
      0,
      Math.cos(angle),
    ];
    return shaft.parts.map(({ part, color, along }) => ({
      part,
      color,
      position: [shaft.at[0], along, shaft.at[2]] as const,
      rotation: catalogue.find(part)?.partClass === 'axle' ? multiply(spin, X_TO_Y) : spin,
      component: -1,
      layer: 0,
      piece: 0,
    }));
  });
}

/**
 * The model file of a frame with a train in it, as it stands when it is built. The boxes that kept
 * room for the gears are left out: the gears are in them now.
 */
export function withTrain(frameJson: string, train: GearTrain, catalogue: Catalogue): string {
  // Our own module's text: its form is what the contract tests hold.
  const frame = JSON.parse(frameJson) as { parts: PlacedPart[]; sketch?: { keepOut?: unknown } };
  const { keepOut: _, ...sketch } = frame.sketch ?? {};
  const parts = [...frame.parts, ...placeTrain(train, 0, catalogue)];
  return JSON.stringify({ ...frame, parts, ...(frame.sketch ? { sketch } : {}) });
}

function readShafts(json: unknown): Shaft[] | null {
  if (typeof json !== 'object' || json === null || !('shafts' in json)) {
    return null;
  }
  const rows: unknown = json.shafts;
  if (!Array.isArray(rows)) {
    return null;
  }
  const shafts = rows.map(readShaft);
  return shafts.every((shaft) => shaft !== null) && shafts.length > 0 ? shafts : null;
}

function readShaft(row: unknown): Shaft | null {
  if (typeof row !== 'object' || row === null) {
    return null;
  }
  const { at, parts } = row as Record<string, unknown>;
  if (!Array.isArray(at) || !at.every(Number.isFinite) || !Array.isArray(parts)) {
    return null;
  }
  const [x, y, z] = at as number[];
  const read = parts.map((part: unknown): ShaftPart | null => {
    const { part: id, color, along } = (part ?? {}) as Record<string, unknown>;
    return typeof id === 'string' && typeof color === 'number' && typeof along === 'number'
      ? { part: id, color, along }
      : null;
  });
  return x === undefined || y === undefined || z === undefined || read.includes(null)
    ? null
    : { at: [x, y, z], parts: read.filter((part) => part !== null) };
}
