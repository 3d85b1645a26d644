// `npm run fix`: formats everything and applies Biome's safe fixes.
import { capture, exitWith, localBin, run } from './lib/run.mjs';

const { stdout } = capture('git', [
  'ls-files',
  '--cached',
  '--others',
  '--exclude-standard',
  '*.h',
  '*.cpp',
  // What the checks must find fault with stays as it is.
  ':!tests/checks/fixtures',
]);
run('clang-format', ['-i', ...stdout.split('\n').filter(Boolean)])
  .then(() => run(localBin('biome'), ['check', '--write', '.']))
  .catch(exitWith);
