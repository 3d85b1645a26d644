import { lineNodes, pointKey, type SketchDocument, type SketchJoint } from './sketch.ts';

/**
 * Which lines of a sketch move as one: lines that share a node, unless a joint there sets them apart. The twin of
 * sketch::bodiesOfLines in the core, for colours on the page.
 * @returns a body for each line, numbered from 0 in the order of the lines.
 */
export function bodiesOfLines({ lines, joints = [] }: SketchDocument): number[] {
  const meeting = new Map<string, number[]>();
  lines.forEach((line, index) => {
    for (const node of lineNodes(line)) {
      const key = pointKey(node);
      const there = meeting.get(key);
      if (!there) {
        meeting.set(key, [index]);
      } else if (there.at(-1) !== index) {
        there.push(index);
      }
    }
  });
  const parents = lines.map((_, i) => i);
  const rootOf = (i: number): number => {
    let root = i;
    while (parents[root] !== root) {
      root = parents[root] ?? root;
    }
    parents[i] = root;
    return root;
  };
  for (const [key, there] of meeting) {
    const here = joints.filter((joint) => pointKey(joint.at) === key);
    const groups = there.map((line) => here.map((joint) => groupOf(joint, line)).join());
    const firstOf = new Map<string, number>();
    there.forEach((line, i) => {
      const group = groups[i] ?? '';
      const first = firstOf.get(group);
      if (first === undefined) {
        firstOf.set(group, line);
      } else {
        const [a, b] = [rootOf(first), rootOf(line)];
        parents[Math.max(a, b)] = Math.min(a, b);
      }
    });
  }
  const numbers = new Map<number, number>();
  return lines.map((_, i) => {
    const root = rootOf(i);
    const number = numbers.get(root) ?? numbers.size;
    numbers.set(root, number);
    return number;
  });
}

/** The group of a joint that a line is in, or -1; by itself where the joint names no groups. */
function groupOf({ between }: SketchJoint, line: number): number {
  return between ? between.findIndex((group) => group.includes(line)) : line;
}

/** Colours of the bodies of a joint, sRGB: what stands first, then what moves; told apart by lightness too. */
const BODY_COLOURS = [0x2b5fb8, 0xe8890c, 0x2fa35c, 0xa0519f, 0x8a5a3b, 0x27a3b4] as const;

/** The colour of a body by its number in the joint. */
export function bodyColour(body: number): number {
  return BODY_COLOURS[body % BODY_COLOURS.length] ?? BODY_COLOURS[0];
}
