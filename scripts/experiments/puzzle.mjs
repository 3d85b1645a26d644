import { gridSketch } from '../lib/families/families.mjs';
import { provedBound } from './grids.mjs';
import { settings, yesNo } from './laboratory.mjs';

const NINE = ['lengths=2,3,5,7,9', 'search.frames=0', 'search.axles=0'];
/** What the ten people of the paper were given, read both ways. */
const SETS = [
  ['straight, up to nine', [...NINE, 'search.corners=0']],
  ['straight and L, up to nine', [...NINE, 'bent=32140,32526']],
];
const TITLES = ['n', 'beams allowed', 'method', 'beams', 'gaps', 'fewest (proved)', 'buildable'];

export const puzzle = {
  name: 'puzzle',
  title: 'People’s puzzle',
  shows:
    'Grids of 2, 3 and 4 cells a side with beams of at most nine holes, the puzzle that ten people were given for an hour each: what our search and the paper’s method find beside the fewest that anybody can.',
  differs:
    'What people did we know from the paper’s text alone: all ten solved n = 2; nobody matched the paper’s method at n = 3 and 4; at n = 4 five were free of gaps, the best with 24 beams. The text does not say whether L beams were among those allowed, so both are here. The paper’s method cools by 0.9998, as its authors set it for grids. The last column but one is proved by integer programming (L beams) or counting, which agree with known optima for straight beams: 6, 16 and 20.',
  async run(laboratory) {
    const rows = [];
    const slow = settings([`paper.coolingRate=${laboratory.quick ? 0.99 : 0.9998}`]);
    for (const n of laboratory.some([2, 3, 4], 1)) {
      const sketch = laboratory.fileOf(gridSketch(n));
      for (const [bricks, pairs] of SETS) {
        const args = ['--preset', 'simple', ...settings(pairs)];
        const bound = await provedBound(laboratory, sketch, args);
        for (const method of ['default', 'paper']) {
          const run = `grid ${n}, ${bricks}, ${method}`;
          const r = laboratory.solve(run, sketch, [...args, ...slow, '--method', method]);
          rows.push([n, bricks, method, r.beams + r.axles, r.gaps, bound, yesNo(r.buildable)]);
        }
      }
    }
    return { tables: [{ titles: TITLES, rows }], csv: { titles: TITLES, rows } };
  },
};
