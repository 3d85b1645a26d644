// Checks that each C++ file compiles by itself. The builds put several files into one translation unit
// (CMAKE_UNITY_BUILD), where a file may live on what another one includes.
// Usage: check-alone.mjs [--all | FILE...]; without any, what the commits since the main branch touch (on the main
// branch: the last commit) and what is not committed yet. Needs build/native, for its flags.
import { spawn, spawnSync } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

const TOP = resolve(dirname(fileURLToPath(import.meta.url)), '../..');
const COMMANDS = resolve(TOP, 'build/native/compile_commands.json');
const MAIN_BRANCHES = ['origin/main', 'main'];

/** The target that a file of core/ or tests/ belongs to; null for what the native build leaves out. */
export function targetOf(file) {
  const [, wing, folder] =
    /^(core|tests\/core)\/([a-z_]+)\/[a-z_0-9]+\.(?:h|cpp)$/.exec(file) ?? [];
  if (folder === undefined) {
    return null;
  }
  return wing === 'core'
    ? `liftarm_${folder}`
    : folder === 'helpers'
      ? 'liftarm_test_helpers'
      : `test_${folder}`;
}

/** The arguments of a compiler command without its input, its output and its precompiled header. */
export function flagsOf(command) {
  const words = command.split(' ').filter((word) => word !== '');
  const flags = [];
  for (let i = words.findIndex((word) => word.startsWith('-')); i < words.length; i++) {
    if (['-o', '-c', '-include', '-MF', '-MT'].includes(words[i])) {
      i += 1;
    } else if (!['-Winvalid-pch', '-Wno-shadow', '-Wshadow=local'].includes(words[i])) {
      flags.push(words[i].replaceAll('\\"', '"'));
    }
  }
  return flags;
}

function flagsByTarget() {
  if (!existsSync(COMMANDS)) {
    throw new Error('build/native is missing: npm run build:native');
  }
  const flags = new Map();
  for (const { command, file } of JSON.parse(readFileSync(COMMANDS, 'utf8'))) {
    const target = /\/CMakeFiles\/([a-z_]+)\.dir\//.exec(`${file} ${command}`)?.[1];
    if (target !== undefined && !flags.has(target)) {
      flags.set(target, flagsOf(command));
    }
  }
  return flags;
}

function git(...args) {
  const { status, stdout } = spawnSync('git', args, { cwd: TOP, encoding: 'utf8' });
  return status === 0 ? stdout.trim().split('\n').filter(Boolean) : null;
}

/** The commit to compare with; null where none is known (a clone of one commit). */
function base() {
  const [head] = git('rev-parse', 'HEAD') ?? [];
  for (const branch of MAIN_BRANCHES) {
    const [fork] = git('merge-base', 'HEAD', branch) ?? [];
    if (fork !== undefined && fork !== head) {
      return fork;
    }
  }
  return git('rev-parse', 'HEAD~1')?.[0] ?? null;
}

function touched() {
  const from = base();
  const committed = from === null ? [] : git('diff', '--name-only', from, 'HEAD');
  const changed = git('diff', '--name-only', 'HEAD') ?? [];
  const added = git('ls-files', '--others', '--exclude-standard') ?? [];
  return [...new Set([...committed, ...changed, ...added])];
}

/** @returns what the compiler says against a file, or null. */
export function compileAlone(file, flags) {
  return new Promise((done) => {
    // By its path from the top, as a header: a header that is the main file has a #pragma once too many.
    const args = [...flags, '-fsyntax-only', '-fmax-errors=3', '-x', 'c++', '-I', TOP, '-'];
    const child = spawn('c++', args, { cwd: TOP, stdio: ['pipe', 'ignore', 'pipe'] });
    let said = '';
    child.stderr.on('data', (text) => {
      said += text;
    });
    child.on('close', (code) =>
      done(code === 0 ? null : `${file} does not compile alone:\n${said}`),
    );
    child.stdin.end(`#include "${resolve(TOP, file)}"\n`);
  });
}

/** @returns one text for each of these files that does not compile alone. */
export async function checkAlone(files) {
  const flags = flagsByTarget();
  const queue = files.filter((file) => flags.has(targetOf(file)) && existsSync(join(TOP, file)));
  const count = queue.length;
  const faults = [];
  const worker = async () => {
    for (let file = queue.shift(); file !== undefined; file = queue.shift()) {
      const fault = await compileAlone(file, flags.get(targetOf(file)));
      faults.push(...(fault === null ? [] : [fault]));
    }
  };
  await Promise.all(Array.from({ length: availableParallelism() }, worker));
  return { count, faults };
}

if (process.argv[1] === import.meta.filename) {
  const named = process.argv.slice(2);
  const all = () => git('ls-files', 'core/*.h', 'core/*.cpp', 'tests/core/*.h', 'tests/core/*.cpp');
  const files = named[0] === '--all' ? all() : named.length > 0 ? named : touched();
  const { count, faults } = await checkAlone(files);
  console.log(`${count} C++ files compiled alone, ${faults.length} do not`);
  if (faults.length > 0) {
    console.error(faults.join('\n'));
    process.exit(1);
  }
}
