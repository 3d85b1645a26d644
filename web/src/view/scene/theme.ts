import type { SnapKind, ThemeName } from '../view-types.ts';

/** All colours of the 3D view, sRGB. Panels take theirs from the style sheet. */
export interface ViewTheme {
  /** Background, from the top to the bottom of the picture. */
  readonly backgroundTop: number;
  readonly backgroundBottom: number;
  readonly grid: number;
  readonly gridStrong: number;
  /** Opacity of the ground grid and of the shadow on it. */
  readonly gridOpacity: number;
  readonly shadowOpacity: number;
  readonly lightScale: number;
  readonly line: number;
  readonly node: number;
  readonly end: number;
  readonly junction: number;
  readonly selected: number;
  readonly hovered: number;
  readonly error: number;
  readonly ghost: number;
  readonly joint: number;
  readonly keepOut: number;
  readonly symmetry: number;
  readonly preview: number;
  readonly snaps: Readonly<Record<SnapKind, number>>;
  /** Principal axes: x, y, z. */
  readonly axes: readonly [number, number, number];
}

const LIGHT: ViewTheme = {
  backgroundTop: 0xf7f8fa,
  backgroundBottom: 0xe4e8ed,
  grid: 0x9aa5b1,
  gridStrong: 0x66727f,
  gridOpacity: 0.42,
  shadowOpacity: 0.22,
  lightScale: 1,
  line: 0x33414f,
  node: 0x33414f,
  end: 0x1f2a35,
  junction: 0x1f2a35,
  selected: 0x1669d6,
  hovered: 0x4d95f0,
  error: 0xd12f36,
  ghost: 0x8593a1,
  joint: 0xc25a00,
  keepOut: 0xb4232a,
  symmetry: 0x7a4fc4,
  preview: 0x1669d6,
  snaps: {
    grid: 0x5b6875,
    end: 0x0f7a3d,
    node: 0x0b7285,
    axis: 0x1669d6,
    'in-line': 0x7a4fc4,
    plane: 0x5b6875,
    pythagorean: 0xb35c00,
    sixty: 0xa8328c,
  },
  axes: [0xc4363c, 0x2b8a3e, 0x2563c9],
};

const DARK: ViewTheme = {
  backgroundTop: 0x20262d,
  backgroundBottom: 0x14181d,
  grid: 0x55616e,
  gridStrong: 0x8794a1,
  gridOpacity: 0.5,
  shadowOpacity: 0.5,
  lightScale: 0.92,
  line: 0xc6d0da,
  node: 0xc6d0da,
  end: 0xf0f4f8,
  junction: 0xf0f4f8,
  selected: 0x5ea6ff,
  hovered: 0x9cc8ff,
  error: 0xff6b70,
  ghost: 0x6b7885,
  joint: 0xffa24d,
  keepOut: 0xff6b70,
  symmetry: 0xb197fc,
  preview: 0x5ea6ff,
  snaps: {
    grid: 0x9aa8b5,
    end: 0x51cf66,
    node: 0x3bc9db,
    axis: 0x5ea6ff,
    'in-line': 0xb197fc,
    plane: 0x9aa8b5,
    pythagorean: 0xffa94d,
    sixty: 0xf783ce,
  },
  axes: [0xff6b6b, 0x69db7c, 0x74a9ff],
};

/** The colours of a theme. */
export function viewTheme(name: ThemeName): ViewTheme {
  return name === 'dark' ? DARK : LIGHT;
}
