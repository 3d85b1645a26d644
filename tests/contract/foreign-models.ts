import { type Mat3, multiply, rotate, subtract, type Vec3 } from '../../web/src/geometry/vec.ts';
import type { PlacedPart } from '../../web/src/model/model.ts';

// Technic models as other people's programs write them. The frames are ours, so that it is known what is to be said of
// them; the files have the habits of others: submodels in turned places, steps and notes of many programs, other numbers
// of the same parts, parts that we do not know, shapes of parts within the file.

/** What a file is written like. */
export interface Habits {
  /** The model, of the gallery. */
  readonly id: string;
  /** Submodels that its parts are divided among, one inside of the other where `nested`. */
  readonly submodels: number;
  readonly nested?: boolean;
  /** Other numbers of parts. */
  readonly numbers?: Readonly<Record<string, string>>;
  /** Parts that are not in the catalogue, and how many of each. */
  readonly guests?: Readonly<Record<string, number>>;
  /** The file holds shapes of its parts: all that there are, or those of the guests. */
  readonly shapes?: 'all' | 'guests';
  /** What is written between rows. */
  readonly notes?: readonly string[];
  readonly ending?: string;
  readonly gap?: string;
  readonly places?: number;
}

interface LdrawPlace {
  readonly at: Vec3;
  readonly turn: Mat3;
}

interface LdrawRow extends LdrawPlace {
  readonly color: number | string;
  readonly file: string;
}

export const MODERN: Readonly<Record<string, string>> = {
  2780: '61332',
  6558: '42924',
  40490: '64289',
  32525: '64290',
  32278: '64871',
};
export const OLD: Readonly<Record<string, string>> = { 2780: '4459', 3713: '6590' };

const STUDIO = ['0 STEP', '0 BUFEXCHG A STORE', '0 ROTSTEP 30 45 0 ABS'];
const LDCAD = [
  '0 !LDCAD GROUP_DEF [topLvl=true] [GID=x] [name=a]',
  '0 STEP',
  '0 !LDCAD CONTENT [type=path]',
];
const LEOCAD = ['0 !LEOCAD PIECE STEP_HIDE 4', '0 STEP', '0 GHOST 0 nothing', '0 MLCAD HIDE 0 a'];
const LPUB = ['0 !LPUB INSERT PAGE', '0 STEP', '0 ROTSTEP END', '0 WRITE Turn it over', '0 CLEAR'];

/** Ten of 100 to 600 parts. */
export const FOREIGN: readonly Habits[] = [
  { id: 'airplane', submodels: 3, guests: { '64782': 2, '44309': 3, '3001': 1 }, notes: STUDIO },
  {
    id: 'robot',
    submodels: 6,
    nested: true,
    numbers: MODERN,
    notes: LDCAD,
    guests: { '58120': 2 },
  },
  {
    id: 'walking-robot',
    submodels: 4,
    numbers: OLD,
    ending: '\r\n',
    guests: { '58119': 1, '3023': 8 },
  },
  { id: 'dinosaur', submodels: 1, gap: '\t', notes: LEOCAD },
  { id: 'satellite', submodels: 5, shapes: 'guests', guests: { panel: 4, dish: 1 }, notes: LPUB },
  {
    id: 'excavator',
    submodels: 7,
    numbers: MODERN,
    guests: { '3873': 36, '92693c01': 2 },
    notes: STUDIO,
  },
  { id: 'windmill', submodels: 2, nested: true, shapes: 'all', guests: { sail: 4 } },
  { id: 'truss-bridge', submodels: 12, places: 3, guests: { '4162': 20, '3710': 24 } },
  {
    id: 'plotter',
    submodels: 3,
    ending: '\r',
    numbers: OLD,
    guests: { '54734': 1 },
    notes: LEOCAD,
  },
  {
    id: 'race-car',
    submodels: 9,
    nested: true,
    guests: { '56145': 4, '44771': 4, '64683': 2 },
    notes: LPUB,
  },
];

const HOME: Mat3 = [1, 0, 0, 0, 1, 0, 0, 0, 1];
const LDU = 20;
/** Colours as some programs write them. */
const MIXED = '0x2B40000';

function transposed(m: Mat3): Mat3 {
  return [m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8]];
}

/** Ours to LDraw's: (x, y, z) becomes (20x, -20z, 20y). */
function placeOf({ position: [x, y, z], rotation: r }: PlacedPart): LdrawPlace {
  const turn: Mat3 = [r[0], -r[2], r[1], -r[6], r[8], -r[7], r[3], -r[5], r[4]];
  return { at: [LDU * x, -LDU * z, LDU * y], turn };
}

/** A place as it is seen from another. */
function within(outer: LdrawPlace, { at, turn }: LdrawPlace): LdrawPlace {
  const back = transposed(outer.turn);
  return { at: rotate(back, subtract(at, outer.at)), turn: multiply(back, turn) };
}

/** Where the submodels lie: turned about the upright, as people do. */
function corner(n: number): LdrawPlace {
  const [c, s] = [
    [1, 0],
    [0, 1],
    [0.8, 0.6],
    [-1, 0],
  ][n % 4] ?? [1, 0];
  return { at: [20 * n, -24 * n, 10], turn: [c ?? 1, 0, s ?? 0, 0, 1, 0, -(s ?? 0), 0, c ?? 1] };
}

/** A model as a text of LDraw. */
export function foreignText(parts: readonly PlacedPart[], habits: Habits): string {
  const { submodels, nested = false, numbers = {}, guests = {}, notes = ['0 STEP'] } = habits;
  const rows: LdrawRow[] = parts.map((part, i) => ({
    ...placeOf(part),
    color: i % 17 === 0 ? MIXED : part.color,
    file: `${numbers[part.part] ?? part.part}${i % 5 === 0 ? '.DAT' : '.dat'}`,
  }));
  const strangers = Object.entries(guests).flatMap(([id, count]) =>
    Array.from({ length: count }, (_, i): LdrawRow => {
      const beside = rows[(7 * i) % rows.length] ?? { at: [0, 0, 0] as Vec3 };
      return {
        at: [beside.at[0], beside.at[1] - 60, beside.at[2]],
        turn: HOME,
        color: 4,
        file: `${id}.dat`,
      };
    }),
  );
  const all = [...rows, ...strangers];
  const nameOf = (n: number) => `${habits.id}  sub model ${n}.ldr`;
  const share = Math.ceil(all.length / submodels);
  const body: string[] = [];
  for (let n = 0; n < submodels; n++) {
    const own = all.slice(n * share, (n + 1) * share);
    const inside = own.map((row) => ({ ...row, ...within(corner(n), row) }));
    if (nested && n + 1 < submodels) {
      inside.push({ ...within(corner(n), corner(n + 1)), color: 16, file: nameOf(n + 1) });
    }
    body.push(...section(nameOf(n), inside, notes, habits));
  }
  const tops = nested ? [0] : [...Array(submodels).keys()];
  const main = tops.map((n): LdrawRow => ({ ...corner(n), color: 16, file: nameOf(n) }));
  const head = section('Main model.ldr', main, notes, habits);
  return [...head, ...body, ...shapesOf(all, habits)].join(habits.ending ?? '\n');
}

function section(
  name: string,
  rows: readonly LdrawRow[],
  notes: readonly string[],
  { gap = ' ', places = 6 }: Habits,
): string[] {
  const scale = 10 ** places;
  const number = (x: number) => String(Math.round(x * scale) / scale + 0);
  const lines = rows.flatMap(({ at, turn, color, file }, i) => [
    ['1', color, ...[...at, ...turn].map(number), file].join(gap),
    ...(i % 3 === 2 ? notes : []),
  ]);
  return [
    `0 FILE ${name}`,
    '0 A model',
    `0 Name: ${name}`,
    '0 Author: somebody',
    ...lines,
    '0 NOFILE',
  ];
}

/** A tetrahedron of sorts stands for every shape; its surfaces lie in a file of their own. */
function shapesOf(rows: readonly LdrawRow[], { shapes, guests = {} }: Habits): string[] {
  const names = new Set(rows.map(({ file }) => file.toLowerCase()));
  const held = [...names].filter(
    (name) => shapes === 'all' || (shapes === 'guests' && name.replace('.dat', '') in guests),
  );
  return [
    ...held.flatMap((name) => [
      `0 FILE ${name}`,
      `0 ~A part called ${name}`,
      '0 !LDRAW_ORG Unofficial_Part',
      '0 BFC CERTIFY CCW',
      '1 16 0 0 0 1 0 0 0 1 0 0 0 1 s\\face.dat',
      '2 24 0 0 0 20 0 0',
    ]),
    ...(held.length === 0 ? [] : ['0 FILE s\\face.dat']),
    ...(held.length === 0 ? [] : ['3 16 0 0 0 40 0 0 0 20 0', '4 16 0 0 0 40 0 0 40 0 40 0 0 40']),
    ...(held.length === 0 ? [] : ['5 24 0 0 0 20 0 0 10 10 0 10 -10 0']),
  ];
}
