import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { basename, join } from 'node:path';
import type { Plugin } from 'vite';

const FILE = 'licences.txt';
const RULE = `\n${'='.repeat(80)}\n\n`;

type Bundle = Readonly<
  Record<string, { readonly type: string; readonly moduleIds?: readonly string[] }>
>;

export interface LicenceFolders {
  /** The top of the project: LICENSE, NOTICE, and `licences/` with the texts of what the solver links. */
  readonly top: string;
}

/**
 * Writes licences.txt: the licence of everything that the built page holds. A package without a text ends the build.
 * Workers are bundled apart and before the page: their plugin takes note of what is in them.
 */
export function licences(folders: LicenceFolders): {
  readonly page: Plugin;
  readonly worker: Plugin;
} {
  const shipped = new Set<string>();
  const note = (bundle: Bundle) => {
    for (const file of Object.values(bundle)) {
      for (const id of file.moduleIds ?? []) {
        shipped.add(id);
      }
    }
  };
  return {
    worker: {
      name: 'liftarm-licences-of-workers',
      apply: 'build',
      generateBundle: (_, bundle) => note(bundle),
    },
    page: {
      name: 'liftarm-licences',
      apply: 'build',
      generateBundle(_, bundle) {
        note(bundle);
        const source = licencesText(packagesOf([...shipped]), folders);
        this.emitFile({ type: 'asset', fileName: FILE, source });
      },
    },
  };
}

/** The folders of the packages that modules come from. */
export function packagesOf(modules: readonly string[]): string[] {
  const found = modules.flatMap(
    (id) => /^(.*\/node_modules\/(?:@[^/]+\/)?[^/]+)\//.exec(id)?.[1] ?? [],
  );
  return [...new Set(found)].sort();
}

/** @throws Error that names a package without a licence's text. */
export function licencesText(packages: readonly string[], { top }: LicenceFolders): string {
  const own = ['LICENSE', 'NOTICE'].map((name) => readFileSync(join(top, name), 'utf8'));
  const ofPage = packages.map((folder) => licenceOf(folder, top));
  const ofSolver = readdirSync(join(top, 'licences'))
    .filter((name) => name.endsWith('.txt'))
    .sort()
    .map((name) => readFileSync(join(top, 'licences', name), 'utf8'));
  return [...own, ...ofPage, ...ofSolver].map((text) => `${text.trim()}\n`).join(RULE);
}

interface PackageFacts {
  readonly name: string;
  readonly version: string;
  readonly license: string;
  readonly homepage?: string;
}

function licenceOf(folder: string, top: string): string {
  const facts = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8')) as PackageFacts;
  const { name, version, license, homepage } = facts;
  const file = readdirSync(folder).find((each) => /^(licen[cs]e|copying)(\.|$)/i.test(each));
  // Some packages say their licence and do not bring its text.
  const kept = join(top, 'licences/npm', `${basename(folder)}.txt`);
  if (file === undefined && !existsSync(kept)) {
    throw new Error(`${name} has no licence file: put the text into licences/npm/`);
  }
  const text = readFileSync(file === undefined ? kept : join(folder, file), 'utf8');
  const source = `https://www.npmjs.com/package/${name}/v/${version}`;
  return `${name} ${version} (${license})\n${homepage ?? source}\nSource: ${source}\n\n${text}`;
}
