// `npm run fix`: formats everything and applies Biome's safe fixes.
import { capture, exitWith, localBin, run } from './lib/run.mjs';

const { stdout } = capture('git', [
  'ls-files',
  '--cached',
  '--others',
  '--exclude-standard',
  '*.h',
  '*.cpp',
]);
run('clang-format', ['-i', ...stdout.split('\n').filter(Boolean)])
  .then(() => run(localBin('biome'), ['check', '--write', '.']))
  .catch(exitWith);
