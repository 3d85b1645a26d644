// Writes core/parts/catalogue.json: the numbers of our parts, taken from the facts in
// ../shared/parts/technic_parts.json (see NOTICE for their sources) and the choices in lib/part-choices.mjs.
// Run it after a change of either: node scripts/make-catalogue.mjs [--check]
import { readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { ABS_DENSITY, AXLE_DENSITY, PARTS, STRAIGHT_BEAM_DENSITY } from './lib/part-choices.mjs';

const root = join(dirname(fileURLToPath(import.meta.url)), '..');
const factsPath = join(root, '../shared/parts/technic_parts.json');
const cataloguePath = join(root, 'core/parts/catalogue.json');

const LDU_PER_MODULE = 20;
const CUBIC_CM_PER_CUBIC_LDU = 0.04 ** 3; // 1 LDU = 0.4 mm
const KINDS = { pin: 'pin', axle: 'axle', pin_hole: 'pinHole', axle_hole: 'axleHole' };
const COLLAR_MIN_RADIUS = 7; // LDU; flared pin tips are 6.25 to 6.5, collars and stops 8
const HOLE_RADIUS = 9; // LDU; the outside of the tube around a hole

const round = (value) => Math.round(value * 1e6) / 1e6 + 0;
const turn = ([x, y, z]) => [round(x), round(z), round(-y)];
const modules = (value) => round(value / LDU_PER_MODULE);
const point = (p) => turn(p.map((value) => value / LDU_PER_MODULE));
const add = (a, b, scale = 1) => a.map((value, i) => value + scale * b[i]);
const length = (a) => Math.hypot(...a);

function prism([from, to, axis, radius, halfThickness]) {
  return {
    axis: turn(axis),
    from: point(from),
    halfThickness: modules(halfThickness),
    radius: modules(radius),
    to: point(to),
  };
}

function slotsOf(feature) {
  // The facts number a half-module slot like a whole one; ours lie on the feature's own middle.
  return feature.short ? [feature.center] : feature.slots;
}

function featureRecord(feature) {
  const record = {
    axis: turn(feature.axis),
    center: point(feature.center),
    kind: KINDS[feature.kind],
    length: modules(feature.length),
    slots: slotsOf(feature).map(point),
  };
  if (feature.cross) record.wing = turn(feature.cross);
  return record;
}

/** Rings around heads: the collar of a pin, the stop of an axle. */
function collars(feature) {
  return feature.sections
    .filter((section) => section.radius > COLLAR_MIN_RADIUS)
    .map((section) => {
      const middle = add(feature.center, feature.axis, (section.a + section.b) / 2);
      return prism([middle, middle, feature.axis, section.radius, (section.b - section.a) / 2]);
    });
}

/** A half-covered end is drawn back to the centre of its hole; a stretch of one hole covers nothing. */
function stretch([from, to]) {
  const along = add(to, from, -1);
  const total = length(along);
  const inset = LDU_PER_MODULE / 2;
  if (total <= 2 * inset + 1e-6) return [];
  const unit = along.map((value) => value / total);
  return [{ from: point(add(from, unit, inset)), to: point(add(to, unit, -inset)) }];
}

/**
 * Facts end a bar of a frame at the flank of the bar that it runs into; the hole in which both meet is
 * one module further on.
 */
function untilTheBarsThatItMeets(bar, bars, pinHoles) {
  const total = length(add(bar.to, bar.from, -1));
  const unit = add(bar.to, bar.from, -1).map((value) => value / total);
  const reach = (end, way) => {
    const next = add(end, unit, way);
    const isHole = pinHoles.some((hole) => length(add(hole, next, -1)) < 1e-6);
    const meets = bars.some((other) => other !== bar && isBetween(next, other));
    return isHole && meets ? next : end;
  };
  return { from: reach(bar.from, -1), to: reach(bar.to, 1) };
}

function isBetween(at, { from, to }) {
  const apart = (a, b) => length(add(a, b, -1));
  return Math.abs(apart(at, from) + apart(at, to) - apart(from, to)) < 1e-6;
}

function stretchesOf(fact) {
  const bars = (fact.stretches ?? []).flatMap(stretch);
  const pinHoles = fact.features
    .filter((feature) => KINDS[feature.kind] === 'pinHole')
    .map((feature) => point(feature.center));
  return bars.map((bar) => untilTheBarsThatItMeets(bar, bars, pinHoles));
}

function armsOf(choice, holes) {
  if (choice.arms) return choice.arms;
  const along = holes.map((hole) => hole.center).sort((a, b) => a[2] - b[2] || a[0] - b[0]);
  const [first, last] = [along[0], along[along.length - 1]];
  return [
    [
      [first[0], first[2]],
      [last[0], last[2]],
    ],
  ];
}

function beamSolid(choice, fact, thickness) {
  const holes = fact.features.filter((feature) => KINDS[feature.kind] && feature.axis[1] !== 0);
  const radius = choice.armRadius ?? HOLE_RADIUS;
  return armsOf(choice, holes).flatMap((corners) =>
    (corners.length > 1 ? corners.slice(1) : corners).map((corner, i) =>
      prism([
        [corners[i][0], 0, corners[i][1]],
        [corner[0], 0, corner[1]],
        [0, 1, 0],
        radius,
        (thickness * LDU_PER_MODULE) / 2,
      ]),
    ),
  );
}

function solidOf(choice, fact, thickness) {
  if (choice.class === 'beam') return beamSolid(choice, fact, thickness);
  if (choice.class === 'gear') return choice.body.map(prism);
  const tubes = fact.features
    .filter((feature) => KINDS[feature.kind] && feature.gender === 'F')
    .map((feature) =>
      prism([
        feature.center,
        feature.center,
        feature.axis,
        choice.tubeRadius ?? HOLE_RADIUS,
        feature.length / 2,
      ]),
    );
  return [...tubes, ...(choice.body ?? []).map(prism)];
}

/** g/cm3 by class; axles are of denser plastics than most. */
const DENSITIES = { axle: AXLE_DENSITY, beam: STRAIGHT_BEAM_DENSITY };

function massOf(choice, fact) {
  if (choice.mass) {
    const { mass, massEstimated, massSource } = choice;
    return { mass, massEstimated: Boolean(massEstimated), ...(massSource && { massSource }) };
  }
  const volume = (fact.volume ?? fact.volume_raw) * CUBIC_CM_PER_CUBIC_LDU;
  const mass = volume * (DENSITIES[choice.class] ?? ABS_DENSITY);
  return { mass: Math.round(mass * 100) / 100, massEstimated: true };
}

function partRecord(id, choice, fact) {
  const features = fact.features.filter((feature) => KINDS[feature.kind]);
  const thickness = Math.round(((fact.bbox[1][1] - fact.bbox[0][1]) / LDU_PER_MODULE) * 2) / 2;
  const corners = fact.bbox.map(point);
  const beam = choice.class === 'beam';
  return {
    bounds: {
      max: [0, 1, 2].map((i) => Math.max(corners[0][i], corners[1][i])),
      min: [0, 1, 2].map((i) => Math.min(corners[0][i], corners[1][i])),
    },
    class: choice.class,
    collars: [
      ...features.filter((feature) => feature.gender === 'M').flatMap(collars),
      ...(choice.neck ?? []).map(prism),
    ],
    color: choice.color,
    features: features.map(featureRecord),
    friction: Boolean(choice.friction),
    holes: choice.holes ?? 0,
    id,
    ...massOf(choice, fact),
    name: fact.title.replace(/\s+/g, ' '),
    solid: solidOf(choice, fact, thickness),
    stretches: beam ? stretchesOf(fact) : [],
    thickness: beam ? thickness : 1,
  };
}

function catalogueText(facts) {
  const ids = Object.keys(PARTS).sort();
  const lines = ids.map((id) => {
    const fact = facts.parts[id];
    if (!fact) throw new Error(`no facts about part ${id}`);
    return JSON.stringify(partRecord(id, PARTS[id], fact));
  });
  const head = { format: 'liftarm-catalogue', source: facts.meta.source, version: 1 };
  return `${JSON.stringify(head).slice(0, -1)},"parts":[\n${lines.join(',\n')}\n]}\n`;
}

const text = catalogueText(JSON.parse(readFileSync(factsPath, 'utf8')));
if (process.argv.includes('--check')) {
  if (readFileSync(cataloguePath, 'utf8') !== text) {
    console.error('core/parts/catalogue.json is not what scripts/make-catalogue.mjs writes');
    process.exit(1);
  }
} else {
  writeFileSync(cataloguePath, text);
  console.log(`wrote ${Object.keys(PARTS).length} parts`);
}
