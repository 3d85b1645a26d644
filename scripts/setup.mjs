// Installs what is missing: Debian packages by apt, npm packages by `npm ci`. Idempotent; well under a
// second when nothing is missing. `--for start` leaves out what only the tests need.
import { existsSync, readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { capture, exitWith, run, StepError, TOP } from './lib/run.mjs';

const BUILD_PACKAGES = [
  'g++',
  'cmake',
  'ninja-build',
  'emscripten',
  'libeigen3-dev',
  'nlohmann-json3-dev',
  'libcli11-dev',
  'libgtest-dev',
  'libgmock-dev',
  'liblzma-dev',
  'libbenchmark-dev',
];
const TEST_PACKAGES = [
  'clang-format',
  'chromium-headless-shell',
  'fonts-dejavu-core',
  'calculix-ccx',
  'poppler-utils',
  'admesh',
];
const APT_OPTIONS = ['-qq', '-o', 'DPkg::Lock::Timeout=300', '-o', 'Acquire::Retries=3'];

function isInstalled(name) {
  // biome-ignore lint/suspicious/noTemplateCurlyInString: dpkg's own placeholder
  const { code, stdout } = capture('dpkg-query', ['-W', '-f=${Status}', name]);
  return code === 0 && stdout.includes('install ok installed');
}

/** @param {string[]} names Debian packages that must be there afterwards. */
export async function installDebianPackages(names) {
  if (capture('dpkg-query', ['--version']).code !== 0) {
    console.log(`Not a Debian system: please see to it that these are there: ${names.join(' ')}`);
    return;
  }
  const missing = names.filter((name) => !isInstalled(name));
  if (missing.length === 0) {
    return;
  }
  console.log(`Installing with apt-get: ${missing.join(' ')}`);
  const root = process.getuid?.() === 0;
  if (!root && capture('sudo', ['--version']).code !== 0) {
    throw new StepError(`Please install as root: apt-get install ${missing.join(' ')}`);
  }
  const apt = (...args) => {
    const command = ['env', 'DEBIAN_FRONTEND=noninteractive', 'apt-get', ...APT_OPTIONS, ...args];
    return root ? run(command[0], command.slice(1)) : run('sudo', command);
  };
  await apt('update');
  await apt('install', '-y', '--no-install-recommends', ...missing);
}

/** Whether node_modules holds what package-lock.json says: npm leaves its own record there. */
function nodeModulesAreFresh() {
  const recordFile = resolve(TOP, 'node_modules/.package-lock.json');
  if (!existsSync(recordFile)) {
    return false;
  }
  const wanted = JSON.parse(readFileSync(resolve(TOP, 'package-lock.json'), 'utf8')).packages;
  const present = JSON.parse(readFileSync(recordFile, 'utf8')).packages;
  return (
    Object.entries(wanted).every(
      ([path, { version, optional, devOptional }]) =>
        path === '' || present[path]?.version === version || optional || devOptional,
    ) && Object.entries(present).every(([path, { version }]) => wanted[path]?.version === version)
  );
}

/** @param {{ forTests: boolean }} options */
export async function setUp({ forTests }) {
  await installDebianPackages(forTests ? [...BUILD_PACKAGES, ...TEST_PACKAGES] : BUILD_PACKAGES);
  if (!nodeModulesAreFresh()) {
    await run('npm', ['ci', '--no-audit', '--no-fund']);
  }
}

if (process.argv[1] === import.meta.filename) {
  setUp({ forTests: !process.argv.includes('start') }).catch(exitWith);
}
