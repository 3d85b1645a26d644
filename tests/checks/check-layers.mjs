// Checks the layer table (layers.json, the picture in core/README.md) against every include and import,
// the size of C++ files, and that no elementary function of the platform is called. A folder may use itself, what its row names, and what those may use.
// Usage: check-layers.mjs [ROOT]; prints one line per breach and ends with 1 when there is any.
import { existsSync, readdirSync, readFileSync, statSync } from 'node:fs';
import { dirname, join, relative, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

const HERE = dirname(fileURLToPath(import.meta.url));
const INCLUDE = /^\s*#\s*include\s+"([^"]+)"/;
const IMPORT = /(?:\bfrom|\bimport)\s*\(?\s*(['"])([^'"]+)\1/;

/** All files under a folder with one of the endings; none when the folder is missing. */
function filesUnder(folder, endings) {
  if (!existsSync(folder)) {
    return [];
  }
  return readdirSync(folder, { recursive: true })
    .map((name) => join(folder, name))
    .filter((file) => endings.some((end) => file.endsWith(end)) && statSync(file).isFile())
    .sort();
}

/** What each folder may use, with everything below it. */
export function closure(table) {
  const reach = (folder) =>
    new Set([folder, ...(table[folder] ?? []).flatMap((f) => [...reach(f)])]);
  return new Map(Object.keys(table).map((folder) => [folder, reach(folder)]));
}

/** Lines of a file that match, as [line number, captured text]. */
function matches(file, pattern, group) {
  return readFileSync(file, 'utf8')
    .split('\n')
    .flatMap((line, i) => {
      const found = line.match(pattern)?.[group];
      return found === undefined ? [] : [[i + 1, found]];
    });
}

function checkCpp(root, layers) {
  const allowed = closure(layers.core);
  const problems = [];
  const checkFile = (file, folder, may) => {
    const name = relative(root, file);
    for (const [line, include] of matches(file, INCLUDE, 1)) {
      const target = include.includes('/') ? include.split('/')[0] : null;
      if (target === null) {
        problems.push(`${name}:${line}: "${include}" must be included as "folder/file.h"`);
      } else if (!may.has(target)) {
        problems.push(`${name}:${line}: ${folder}/ may not include ${target}/`);
      }
    }
  };
  for (const file of filesUnder(join(root, 'core'), ['.h', '.cpp'])) {
    const folder = relative(join(root, 'core'), file).split('/')[0];
    const may = allowed.get(folder);
    if (may === undefined) {
      problems.push(`${relative(root, file)}: core/${folder} is not in layers.json`);
    } else {
      checkFile(file, folder, may);
    }
  }
  for (const file of filesUnder(join(root, 'wasm'), ['.h', '.cpp'])) {
    checkFile(file, 'wasm', new Set(['wasm', ...layers.wasm]));
  }
  return problems;
}

// What libm computes differs between platforms; base/det_math and std::sqrt, which rounds exactly, do not.
const LIBM =
  /\bstd::(sin|cos|tan|asin|acos|atan2?|exp2?|expm1|log(?:2|10|1p)?|pow|cbrt|hypot|fma|tgamma|erf)\s*\(/;

/** Elementary functions of the platform: the same input must give the same model everywhere (DESIGN 2). */
function checkLibm(root) {
  return ['core', 'wasm'].flatMap((folder) =>
    filesUnder(join(root, folder), ['.h', '.cpp']).flatMap((file) =>
      matches(file, LIBM, 1).map(
        ([line, name]) =>
          `${relative(root, file)}:${line}: std::${name} differs between platforms; see base/det_math.h`,
      ),
    ),
  );
}

function checkSizes(root, { maxLines }) {
  return ['core', 'wasm', 'tests']
    .flatMap((folder) => filesUnder(join(root, folder), ['.h', '.cpp']))
    .filter((file) => !file.includes('/fixtures/'))
    .map((file) => [file, readFileSync(file, 'utf8').split('\n').length - 1])
    .filter(([, lines]) => lines > maxLines)
    .map(([file, lines]) => `${relative(root, file)}: ${lines} lines, ${maxLines} at most`);
}

function checkWeb(root, layers) {
  const source = join(root, 'web/src');
  const allowed = closure(layers.web);
  // Files directly in web/src (the entry point) stand above every folder.
  const everything = new Set(Object.keys(layers.web));
  const problems = [];
  for (const file of filesUnder(source, ['.ts', '.tsx'])) {
    const [folder, ...rest] = relative(source, file).split('/');
    const may = rest.length === 0 ? everything : allowed.get(folder);
    if (may === undefined) {
      problems.push(`${relative(root, file)}: web/src/${folder} is not in layers.json`);
      continue;
    }
    for (const [line, target] of matches(file, IMPORT, 2)) {
      const breach = target.startsWith('.')
        ? importBreach(source, resolve(dirname(file), target), may)
        : packageBreach(layers.webPackages, target, folder);
      if (breach !== null) {
        problems.push(`${relative(root, file)}:${line}: ${folder}/ may not import ${breach}`);
      }
    }
  }
  return problems;
}

function importBreach(source, target, may) {
  const path = relative(source, target);
  const folder = path.split('/')[0];
  // Styles, data and built files outside web/src have no layer.
  return path.startsWith('..') || may.has(folder) ? null : `${folder}/`;
}

function packageBreach(webPackages, target, folder) {
  const name = target.split('/')[0];
  return webPackages[name]?.includes(folder) === false ? `'${name}'` : null;
}

/** All breaches under a root folder, one line each. */
export function checkLayers(root) {
  const layers = JSON.parse(readFileSync(join(HERE, 'layers.json'), 'utf8'));
  return [
    ...checkCpp(root, layers),
    ...checkLibm(root),
    ...checkSizes(root, layers),
    ...checkWeb(root, layers),
  ];
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const problems = checkLayers(resolve(process.argv[2] ?? join(HERE, '../..')));
  for (const problem of problems) {
    console.error(problem);
  }
  process.exit(problems.length > 0 ? 1 : 0);
}
