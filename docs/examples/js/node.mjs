// Solves a table, checks it, looks at how stiff it is, and writes what a builder needs. Run: see README.md.
import { writeFileSync } from 'node:fs';
import { createLiftarm } from 'liftarm';

const leg = (x, y) => ({ from: [x, y, 0], to: [x, y, 6] });
const sketch = {
  format: 'technic-sketch',
  version: 1,
  name: 'Table',
  lines: [
    ...[leg(0, 0), leg(8, 0), leg(8, 6), leg(0, 6)],
    { from: [0, 0, 6], to: [8, 0, 6] },
    { from: [8, 0, 6], to: [8, 6, 6] },
    { from: [8, 6, 6], to: [0, 6, 6] },
    { from: [0, 6, 6], to: [0, 0, 6] },
  ],
};

const liftarm = createLiftarm();
try {
  const { model, report } = await liftarm.solve(sketch, { seed: 1 });
  const { buildable, wellBuilt } = await liftarm.check(model);
  const { freedoms, balance } = await liftarm.analyseMotion(model);
  console.log(`${report.name}: ${report.beams} beams, ${report.bricks} parts, ${report.mass} g`);
  console.log(`buildable: ${buildable}; well built: ${wellBuilt.passed} of ${wellBuilt.of}`);
  console.log(`freedoms beyond its joints: ${freedoms.beyondJoints}; stands: ${balance?.stable}`);
  writeFileSync('table.mpd', await liftarm.exportModel(model, 'mpd'));
} finally {
  liftarm.close();
}
