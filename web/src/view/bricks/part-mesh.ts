import { add, dot, scale, subtract, type Vec3 } from '../../geometry/vec.ts';
import type { Part } from '../../model/catalogue.ts';
import { addAxle } from './axle.ts';
import { addBush, addStop, hasFlanges } from './bush.ts';
import { DETAILS, type Detail, type DetailName, DIMENSIONS } from './detail.ts';
import { addGear } from './gear.ts';
import { buildGuestMesh } from './guest-mesh.ts';
import { addAxleHole, addPinHole, axleHoleOpening, pinHoleOpening } from './holes.ts';
import {
  type BrickMesh,
  type Frame,
  frameAlong,
  MeshBuilder,
  type Point2,
  reversed,
  shifted,
} from './mesh-builder.ts';
import {
  type BodyCell,
  type BodyGroup,
  type Bridge,
  layOutPart,
  type MaleRun,
} from './part-layout.ts';
import { addPinHead } from './pin.ts';
import { addPlate } from './plate.ts';
import { addRevolved, circlePoints, fullCircle } from './revolve.ts';
import { addWeb, circleFaces, circleSection, rectangleFaces, rectangleSection } from './web.ts';

/**
 * Builds the mesh of any part of the catalogue in its own frame: bodies from its solid, openings from
 * its holes, heads and axles from its male features, webs between bodies that cross.
 */
export function buildPartMesh(part: Part, detailName: DetailName): BrickMesh {
  if (part.guest) {
    return buildGuestMesh(part.guest);
  }
  const detail = DETAILS[detailName];
  const builder = new MeshBuilder();
  const layout = layOutPart(part);
  if (hasFlanges(part)) {
    addBush(builder, part, detail);
  } else if (!addGear(builder, part, detail)) {
    for (const group of layout.groups) {
      addGroup(builder, group, detail);
    }
    for (const bridge of layout.bridges) {
      addBridge(builder, bridge, detail);
    }
  }
  for (const male of layout.males) {
    if (male.feature.kind === 'pin') {
      addPin(builder, part, male, detail);
    } else {
      addAxleRun(builder, male, detail);
    }
  }
  if (part.partClass === 'axle') {
    for (const collar of part.collars) {
      addStop(builder, collar, detail);
    }
  }
  return builder.build();
}

function addGroup(builder: MeshBuilder, group: BodyGroup, detail: Detail): void {
  const frame = groupFrame(group);
  const flat = (p: Vec3): Point2 => {
    const offset = subtract(p, frame.origin);
    return [dot(offset, frame.x), dot(offset, frame.y)];
  };
  const openings = group.holes.map((hole) => {
    const [x, y] = flat(hole.center);
    const place = { ...frame, origin: at(frame, x, y) };
    if (hole.kind === 'pinHole') {
      addPinHole(builder, place, group.halfHeight, detail);
      return pinHoleOpening(x, y, detail);
    }
    const wing = hole.wing ?? frame.x;
    const [wx, wy] = [dot(wing, frame.x), dot(wing, frame.y)];
    addAxleHole(builder, frameAlong(place.origin, frame.z, wing), group.halfHeight);
    return axleHoleOpening(x, y, Math.atan2(wy, wx));
  });
  addPlate(
    builder,
    frame,
    {
      graph: { points: group.points.map(flat), bars: group.bars },
      radius: group.radius,
      halfHeight: group.halfHeight,
      openings,
    },
    detail,
  );
}

function groupFrame(group: BodyGroup): Frame {
  const origin = group.points[0] ?? [0, 0, 0];
  const bar = group.bars[0];
  const a = group.points[bar?.[0] ?? 0];
  const b = group.points[bar?.[1] ?? 0];
  return frameAlong(origin, group.axis, bar && a && b ? subtract(b, a) : undefined);
}

function at(frame: Frame, x: number, y: number): Vec3 {
  return add(frame.origin, add(scale(frame.x, x), scale(frame.y, y)));
}

/** Half the width of a web, and how far from a barrel's middle a head's foot stands. */
const WEB_HALF = 0.45;
const NECK_HEIGHT = 0.5;
/** Of the disc that ends a neck round an axle. */
const NECK_DISC = 0.02;

/** How deep webs and necks reach into the bodies that they join: to just outside the hole. */
const BURIED = DIMENSIONS.counterboreRadius + 0.02;

/** Height of a barrel's surface above its axis, `across` off its middle line. */
function barrelHeight(across: number): number {
  return Math.sqrt(Math.max(0, BURIED * BURIED - across * across));
}

function addBridge(builder: MeshBuilder, bridge: Bridge, detail: Detail): void {
  const { a, b } = bridge;
  const offset = subtract(b.at, a.at);
  if (bridge.kind === 'neck') {
    const gap = Math.sqrt(dot(offset, offset));
    addNeck(builder, a, { outward: offset, height: gap - b.halfHeight }, detail);
    return;
  }
  const alongA = dot(offset, a.axis);
  const alongB = dot(offset, b.axis);
  const way = subtract(offset, add(scale(a.axis, alongA), scale(b.axis, alongB)));
  const gap = Math.sqrt(dot(way, way));
  const frame = frameAlong(a.at, way, a.axis);
  const flip = dot(frame.y, b.axis) < 0 ? -1 : 1;
  const x = overlap([0, Math.min(a.halfHeight, WEB_HALF)], [alongA, 0.5]);
  const y = overlap([flip * alongB, Math.min(b.halfHeight, WEB_HALF)], [0, 0.5]);
  const steps = detail.name === 'low' ? 1 : 6;
  addWeb(builder, frame, {
    section: rectangleSection(x, y, steps),
    startFaces: rectangleFaces(steps, 'y'),
    endFaces: rectangleFaces(steps, 'x'),
    start: (_, across) => barrelHeight(across),
    end: (across) => gap - barrelHeight(across - alongA),
    round: false,
    lines: detail.name !== 'low',
  });
}

/** Where two stretches given by middle and half length overlap, as low and high. */
function overlap(
  p: readonly [number, number],
  q: readonly [number, number],
): readonly [number, number] {
  return [Math.max(p[0] - p[1], q[0] - q[1]), Math.min(p[0] + p[1], q[0] + q[1])];
}

/** The round foot between a barrel and a head that grows sideways out of it. */
function addNeck(
  builder: MeshBuilder,
  root: BodyCell,
  run: { readonly outward: Vec3; readonly height: number },
  detail: Detail,
): void {
  const frame = frameAlong(root.at, run.outward, root.axis);
  if (Math.abs(dot(root.axis, frame.z)) > 0.5) {
    return;
  }
  addWeb(builder, frame, {
    section: circleSection(DIMENSIONS.collarRadius, detail.segments),
    startFaces: circleFaces(detail.segments),
    endFaces: circleFaces(detail.segments),
    start: (_, y) => barrelHeight(y),
    end: () => run.height,
    round: true,
    lines: false,
  });
}

function addPin(builder: MeshBuilder, part: Part, male: MaleRun, detail: Detail): void {
  const { feature, roots, joined } = male;
  const friction = part.friction;
  const base = frameAlong(feature.center, feature.axis, feature.wing);
  const half = feature.length / 2;
  for (const side of [0, 1] as const) {
    const rooted = roots[side];
    if (rooted || joined[side]) {
      // The other end is the tip.
      const outward = side === 0 ? base : reversed(base);
      addPinHead(
        builder,
        shifted(outward, -half),
        { length: feature.length, collar: true, bore: 'blind', friction },
        detail,
      );
      if (rooted) {
        addNeck(builder, rooted, { outward: outward.z, height: NECK_HEIGHT }, detail);
      }
      return;
    }
  }
  const low = collarHeight(part, male) + half;
  const collar = shifted(base, low - half);
  const shape = { collar: true, bore: 'through', friction } as const;
  addPinHead(builder, reversed(collar), { ...shape, length: low }, detail);
  addPinHead(builder, collar, { ...shape, length: feature.length - low }, detail);
}

/** Where the collar of a pin with two free ends sits, from its middle along its axis. */
function collarHeight(part: Part, male: MaleRun): number {
  const { center, axis } = male.feature;
  const heights = part.collars.map((collar) => dot(subtract(collar.from, center), axis));
  return heights[0] ?? 0;
}

function addAxleRun(builder: MeshBuilder, male: MaleRun, detail: Detail): void {
  const { feature, roots, joined } = male;
  const frame = frameAlong(feature.center, feature.axis, feature.wing);
  const ends = { low: !(roots[0] || joined[0]), high: !(roots[1] || joined[1]) };
  addAxle(builder, frame, { halfLength: feature.length / 2, ends }, detail);
  roots.forEach((root, side) => {
    if (root) {
      const outward = scale(feature.axis, side === 0 ? 1 : -1);
      addNeck(builder, root, { outward, height: NECK_HEIGHT }, detail);
      addNeckFace(builder, shifted(frameAlong(root.at, outward), NECK_HEIGHT), detail);
    }
  });
}

/** The ring round an axle where it leaves its neck: a thin disc, closed by itself. */
function addNeckFace(builder: MeshBuilder, frame: Frame, detail: Detail): void {
  const radius = DIMENSIONS.collarRadius;
  addRevolved(
    builder,
    frame,
    [
      [0, -NECK_DISC],
      [radius, -NECK_DISC],
      [radius, 0],
      [0, 0],
    ],
    { segments: detail.segments, rims: 'none' },
  );
  builder.hardPolyline(circlePoints(frame, radius, 0, fullCircle(detail.segments)));
}
