// A machine from a drawn path.

export const LINKAGES_EN = {
  intro:
    'Draw the path that a point is to take: drag, or click point after point. Six machines of real beams come back; each is turned by one crank.',
  canvas: 'Where the path is drawn; a square is one module of 8 mm',
  kind: 'What the path is for',
  kinds: { any: 'Any path', foot: 'Foot of a walker', line: 'There and back on a line' },
  closed: 'Closed',
  plane: 'Plane',
  planes: { x: 'seen from the right', y: 'seen from the front', z: 'seen from above' },
  shapes: 'Begin with',
  shape: { foot: 'Foot', line: 'Line', ellipse: 'Ellipse' },
  clear: 'Clear',
  making: 'Listing all machines: {percent} %',
  looking: 'Looking…',
  found: '{n} machines, found in {seconds} s. Take one: it becomes your drawing.',
  none: 'No machine of four bars draws this. Try it smaller, or rounder.',
  failed: 'That did not work: {message}',
  take: 'Take machine {n}: {error} mm off the path on average',
  error: '{error} mm off, {largest} mm at most',
  links: 'crank {crank}, rocker {rocker}, coupler {coupler}, pivots {frame} apart',
  transmission: 'pushes at {angle}° or better',
} as const;
