import { type Detail, DIMENSIONS } from './detail.ts';
import { type Frame, type MeshBuilder, type Point2, toPart } from './mesh-builder.ts';
import { addRevolved, arcAngles, fullCircle } from './revolve.ts';

/** One end of a pin: it grows along the frame's z axis, from 0 to `length`. */
export interface PinHead {
  readonly length: number;
  /** A collar stands at the foot and fills the counterbore there. */
  readonly collar: boolean;
  /** The bore goes on behind the foot (a pin with two heads) or ends in the body. */
  readonly bore: 'through' | 'blind';
  readonly friction: boolean;
}

/** Measures of a head in modules. */
const HEAD = {
  lipBottom: 0.15,
  lipLow: 0.09,
  lipHigh: 0.03,
  tipRadius: 0.298,
  slotDepth: 0.7,
  slotHalfAngle: 0.22,
  boreFloor: 0.15,
  ridgeFrom: 0.2,
  ridgeTo: 0.55,
  ridgeRadius: 0.303,
  ridgeHalfWidth: 0.025,
} as const;

const SHADE = { bore: 0.3, mouth: 0.7, slot: 0.45 } as const;

/** Adds one head of a pin: shaft, lip, bore, and in high detail the slot and the friction ridges. */
export function addPinHead(
  builder: MeshBuilder,
  frame: Frame,
  head: PinHead,
  detail: Detail,
): void {
  const foot = footProfile(head);
  const tip = tipProfile(head.length, detail);
  const join = detail.pinDetails ? head.length - HEAD.slotDepth : (tip[0]?.[1] ?? 0);
  const shaft: Point2[] = [...foot, [DIMENSIONS.pinRadius, join]];
  const ring = headAngles(detail);
  const common = { segments: detail.segments, angles: ring, silhouettes: detail.silhouettes };
  addRevolved(builder, frame, shaft, {
    ...common,
    rims: head.collar ? 'corners-and-ends' : 'corners',
  });
  if (detail.pinDetails) {
    addSlottedTip(builder, frame, { tip, join }, detail);
    if (head.friction) {
      addRidges(builder, frame, head.collar ? 0 : -HEAD.ridgeFrom);
    }
  } else {
    addRevolved(builder, frame, tip, { ...common, rims: 'corners' });
  }
  addBore(builder, frame, head, { detail, ring });
}

/** The two half shells of a slit tip, and the slits between them. */
const SHELLS = [Math.PI / 2, (3 * Math.PI) / 2].map((middle) =>
  around(middle, Math.PI / 2 - HEAD.slotHalfAngle),
);
const SLITS = [0, Math.PI].map((middle) => around(middle, HEAD.slotHalfAngle));

function around(middle: number, half: number): readonly [number, number] {
  return [middle - half, middle + half];
}

/** The steps round a head: shaft, shells, slits and bore share them, so that no edge meets half of another. */
function headAngles(detail: Detail): readonly number[] {
  if (!detail.pinDetails) {
    return fullCircle(detail.segments);
  }
  const arcs = [SLITS[0], SHELLS[0], SLITS[1], SHELLS[1]].map((arc) =>
    arcAngles(detail.segments, arc ?? [0, 0]),
  );
  return arcs.flatMap((angles, i) => (i < arcs.length - 1 ? angles.slice(0, -1) : angles));
}

function footProfile(head: PinHead): Point2[] {
  const { pinRadius, collarRadius, collarWidth } = DIMENSIONS;
  return head.collar
    ? [
        // The foot of a head that grows from an axle is seen round it.
        ...(head.bore === 'blind' ? [[0, 0] as const] : []),
        [collarRadius, 0],
        [collarRadius, collarWidth],
        [pinRadius, collarWidth],
      ]
    : [[pinRadius, 0]];
}

/** From the shaft over the lip to the rim of the bore. */
function tipProfile(length: number, detail: Detail): Point2[] {
  const { pinRadius, pinLipRadius, pinBoreRadius } = DIMENSIONS;
  if (detail.name === 'low') {
    return [
      [pinRadius, length - HEAD.lipBottom],
      [HEAD.tipRadius, length],
      [pinBoreRadius, length],
    ];
  }
  return [
    [pinRadius, length - HEAD.lipBottom],
    [pinLipRadius, length - HEAD.lipLow],
    [pinLipRadius, length - HEAD.lipHigh],
    [HEAD.tipRadius, length],
    [pinBoreRadius, length],
  ];
}

/** The part of the head that is slit: two half shells with the slit's sides and floor. */
function addSlottedTip(
  builder: MeshBuilder,
  frame: Frame,
  shape: { readonly tip: readonly Point2[]; readonly join: number },
  detail: Detail,
): void {
  const { tip, join } = shape;
  const shell: Point2[] = [[DIMENSIONS.pinRadius, join], ...tip];
  const bore = DIMENSIONS.pinBoreRadius;
  for (const arc of SHELLS) {
    const angles = arcAngles(detail.segments, arc);
    const common = { segments: detail.segments, angles };
    addRevolved(builder, frame, shell, {
      ...common,
      rims: 'corners',
      silhouettes: detail.silhouettes,
    });
    const inside: Point2[] = [
      [bore, tip.at(-1)?.[1] ?? 0],
      [bore, join],
    ];
    addRevolved(builder, frame, inside, {
      ...common,
      shades: [SHADE.mouth, SHADE.bore],
      rims: 'corners-and-ends',
    });
    for (const [angle, side] of [
      [arc[0], -1],
      [arc[1], 1],
    ] as const) {
      addSlotSide(builder, frame, { shell, angle, side });
    }
  }
  addSlotFloor(builder, frame, join, detail);
}

/** The flat side of a slit at an angle; `side` tells which way it looks round the axis. */
function addSlotSide(
  builder: MeshBuilder,
  frame: Frame,
  wall: { readonly shell: readonly Point2[]; readonly angle: number; readonly side: 1 | -1 },
): void {
  const { shell, angle, side } = wall;
  const bore = DIMENSIONS.pinBoreRadius;
  const place = (r: number, t: number): readonly [number, number, number] =>
    toPart(frame, r * Math.cos(angle), r * Math.sin(angle), t);
  // A fan from where the wall ends at the bore: every other point of it is seen from there.
  const corners = [place(bore, shell[0]?.[1] ?? 0), ...shell.map(([r, t]) => place(r, t))];
  const turned = side > 0 ? corners.reverse() : corners;
  builder.flatFan(side > 0 ? turned : [...turned.slice(-1), ...turned.slice(0, -1)], SHADE.slot);
  for (let i = 0; i + 2 < shell.length; i++) {
    const [a, b] = [shell[i] ?? [0, 0], shell[i + 1] ?? [0, 0]];
    builder.hardLine(place(a[0], a[1]), place(b[0], b[1]));
  }
  const top = shell.at(-1)?.[1] ?? 0;
  builder.hardLine(place(HEAD.tipRadius, top), place(bore, top));
}

function addSlotFloor(builder: MeshBuilder, frame: Frame, height: number, detail: Detail): void {
  for (const arc of SLITS) {
    addRevolved(
      builder,
      frame,
      [
        [DIMENSIONS.pinRadius, height],
        [DIMENSIONS.pinBoreRadius, height],
      ],
      {
        segments: detail.segments,
        shades: [SHADE.slot, SHADE.slot],
        rims: 'none',
        angles: arcAngles(detail.segments, arc),
      },
    );
  }
}

function addBore(
  builder: MeshBuilder,
  frame: Frame,
  head: PinHead,
  { detail, ring }: { readonly detail: Detail; readonly ring: readonly number[] },
): void {
  const bore = DIMENSIONS.pinBoreRadius;
  const top = detail.pinDetails ? head.length - HEAD.slotDepth : head.length;
  const floor = head.bore === 'through' ? 0 : HEAD.boreFloor;
  const wall: Point2[] = [
    [bore, top],
    [bore, floor],
  ];
  const shades: number[] = [detail.pinDetails ? SHADE.bore : SHADE.mouth, SHADE.bore];
  if (head.bore === 'blind') {
    wall.push([0, floor]);
    shades.push(SHADE.bore);
  }
  addRevolved(builder, frame, wall, {
    segments: detail.segments,
    angles: ring,
    shades,
    rims: detail.pinDetails ? 'none' : 'corners-and-ends',
  });
}

/** Four low ridges along the shaft that hold the pin in its hole. */
function addRidges(builder: MeshBuilder, frame: Frame, offset: number): void {
  const { ridgeHalfWidth: w, ridgeRadius: r } = HEAD;
  const low = HEAD.ridgeFrom + offset;
  const high = HEAD.ridgeTo + offset;
  for (let i = 0; i < 4; i++) {
    const angle = Math.PI / 4 + (i * Math.PI) / 2;
    const c = Math.cos(angle);
    const s = Math.sin(angle);
    const place = (radial: number, across: number, t: number): readonly [number, number, number] =>
      toPart(frame, radial * c - across * s, radial * s + across * c, t);
    const inner = DIMENSIONS.pinRadius - 0.01;
    builder.flatQuad([place(r, -w, low), place(r, w, low), place(r, w, high), place(r, -w, high)]);
    // Within the shaft, so that the ridge is closed by itself.
    builder.flatQuad([
      place(inner, -w, high),
      place(inner, w, high),
      place(inner, w, low),
      place(inner, -w, low),
    ]);
    for (const side of [1, -1] as const) {
      const a = place(inner, side * w, low);
      const b = place(inner, side * w, high);
      const p = place(r, side * w, low);
      const q = place(r, side * w, high);
      builder.flatQuad(side > 0 ? [p, a, b, q] : [a, p, q, b]);
    }
    builder.flatQuad([
      place(inner, -w, high),
      place(r, -w, high),
      place(r, w, high),
      place(inner, w, high),
    ]);
    builder.flatQuad([
      place(inner, w, low),
      place(r, w, low),
      place(r, -w, low),
      place(inner, -w, low),
    ]);
  }
}
