/**
 * Colours that the bricks come in: LDraw code, name, and an sRGB value for the screen. Only solid
 * colours in which Technic parts are sold.
 */

export interface BrickColour {
  /** LDraw colour code. */
  readonly code: number;
  readonly name: string;
  /** 0xRRGGBB, sRGB. */
  readonly hex: number;
}

export const BRICK_COLOURS: readonly BrickColour[] = [
  { code: 0, name: 'Black', hex: 0x1d1f22 },
  { code: 1, name: 'Blue', hex: 0x1e5aa8 },
  { code: 2, name: 'Green', hex: 0x00852b },
  { code: 4, name: 'Red', hex: 0xb40000 },
  { code: 5, name: 'Dark Pink', hex: 0xd3359d },
  { code: 7, name: 'Light Grey', hex: 0x8a928d },
  { code: 8, name: 'Dark Grey', hex: 0x545955 },
  { code: 10, name: 'Bright Green', hex: 0x58ab41 },
  { code: 14, name: 'Yellow', hex: 0xfac80a },
  { code: 15, name: 'White', hex: 0xf4f4f4 },
  { code: 19, name: 'Tan', hex: 0xd7ba8c },
  { code: 22, name: 'Purple', hex: 0x671f81 },
  { code: 25, name: 'Orange', hex: 0xd67923 },
  { code: 26, name: 'Magenta', hex: 0x901f76 },
  { code: 27, name: 'Lime', hex: 0xa5ca18 },
  { code: 28, name: 'Dark Tan', hex: 0x897d62 },
  { code: 70, name: 'Reddish Brown', hex: 0x5f3109 },
  { code: 71, name: 'Light Bluish Grey', hex: 0x969696 },
  { code: 72, name: 'Dark Bluish Grey', hex: 0x646464 },
  { code: 73, name: 'Medium Blue', hex: 0x7396c8 },
  { code: 84, name: 'Medium Nougat', hex: 0xaa7d55 },
  { code: 85, name: 'Dark Purple', hex: 0x441a91 },
  { code: 179, name: 'Pearl Silver', hex: 0x898788 },
  { code: 191, name: 'Bright Light Orange', hex: 0xfcac00 },
  { code: 226, name: 'Bright Light Yellow', hex: 0xffec6c },
  { code: 272, name: 'Dark Blue', hex: 0x19325a },
  { code: 288, name: 'Dark Green', hex: 0x00451a },
  { code: 308, name: 'Dark Brown', hex: 0x352100 },
  { code: 320, name: 'Dark Red', hex: 0x720012 },
  { code: 321, name: 'Dark Azure', hex: 0x469bc3 },
  { code: 322, name: 'Medium Azure', hex: 0x68c3e2 },
  { code: 330, name: 'Olive Green', hex: 0x77774e },
  { code: 378, name: 'Sand Green', hex: 0x708e7c },
  { code: 379, name: 'Sand Blue', hex: 0x70819a },
  { code: 484, name: 'Dark Orange', hex: 0x91501c },
];

/** What an unknown code is drawn as: Light Bluish Grey. */
export const FALLBACK_COLOUR_CODE = 71;

const BY_CODE: ReadonlyMap<number, BrickColour> = new Map(
  BRICK_COLOURS.map((colour) => [colour.code, colour]),
);

/** The colour with this LDraw code, or undefined. */
export function findColour(code: number): BrickColour | undefined {
  return BY_CODE.get(code);
}

/** sRGB value for a code; Light Bluish Grey for one that is not in the table. */
export function colourHex(code: number): number {
  return BY_CODE.get(code)?.hex ?? BY_CODE.get(FALLBACK_COLOUR_CODE)?.hex ?? 0x969696;
}

/** Name for a code, or `Colour N`. */
export function colourName(code: number): string {
  return BY_CODE.get(code)?.name ?? `Colour ${code}`;
}

/** Relative luminance of an sRGB value, 0 (black) to 1 (white), as WCAG 2 defines it. */
export function luminance(hex: number): number {
  const channel = (shift: number): number => {
    const value = ((hex >> shift) & 0xff) / 255;
    return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
  };
  return 0.2126 * channel(16) + 0.7152 * channel(8) + 0.0722 * channel(0);
}

/** A mix of two sRGB values: `a` at amount 0, `b` at amount 1. */
export function mixHex(a: number, b: number, amount: number): number {
  const mix = (shift: number): number => {
    const from = (a >> shift) & 0xff;
    const to = (b >> shift) & 0xff;
    return Math.round(from + (to - from) * amount) << shift;
  };
  return mix(16) | mix(8) | mix(0);
}

/**
 * Colour of the drawn edges of a brick: a darker shade of light bricks, a lighter shade of dark
 * ones, so that black parts keep their lines, as in printed instructions.
 */
export function edgeHex(hex: number): number {
  return luminance(hex) < 0.06 ? mixHex(hex, 0xffffff, 0.42) : mixHex(hex, 0x000000, 0.72);
}

/**
 * A fixed series of distinct colours for groups (layers, components, pieces): neighbours differ
 * clearly, the series repeats after its length.
 */
const GROUP_COLOURS: readonly number[] = [
  0x4477aa, 0xee6677, 0x228833, 0xccbb44, 0x66ccee, 0xaa3377, 0xf28e2b, 0x7c6fd0, 0x2a9d8f,
  0xb5835a,
];

/** Colour of group `index`; grey for a negative index, which means no group. */
export function groupHex(index: number): number {
  if (index < 0 || !Number.isFinite(index)) {
    return 0xb8bcc2;
  }
  return GROUP_COLOURS[Math.floor(index) % GROUP_COLOURS.length] ?? 0xb8bcc2;
}
