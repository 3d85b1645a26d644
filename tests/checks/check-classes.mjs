// Checks how large classes and functions of the core are (classes.json): private methods and fields of a class, lines
// of a function. Only `class` is counted: a `struct` is a record, and its fields are what it is for. The scanner reads
// braces, semicolons and access labels, which is enough for sources that clang-format has laid out.
// Usage: check-classes.mjs [ROOT]; prints one line per breach and ends with 1 when there is any.
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { dirname, join, relative, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

const HERE = dirname(fileURLToPath(import.meta.url));

/** A source without comments, preprocessor lines, and what stands in quotes; lines stay where they are. */
function bare(source) {
  const blank = (text) => text.replace(/[^\n]/g, ' ');
  return source
    .replace(/\/\/[^\n]*|\/\*[\s\S]*?\*\/|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])'/g, (text) =>
      text.startsWith('/') ? blank(text) : `""${blank(text.slice(2))}`,
    )
    .replace(/^[ \t]*#[^\n]*(?:\\\n[^\n]*)*/gm, blank);
}

/** Without template arguments and attributes, so that their parentheses and commas do not count. */
function plain(head) {
  let text = head.replace(/\[\[[^\]]*\]\]/g, ' ').replace(/->/g, '  ');
  for (let before = ''; before !== text; ) {
    before = text;
    text = text.replace(/<[^<>]*>/g, ' ');
  }
  return text.trim();
}

/** Splits the access labels off the front of a statement. */
function unlabelled(head) {
  const label = /^\s*(public|protected|private)\s*:/;
  let access = null;
  let rest = head;
  for (let found = rest.match(label); found !== null; found = rest.match(label)) {
    access = found[1];
    rest = rest.slice(found[0].length);
  }
  return { access, rest };
}

/** What a statement in a class declares: a 'method', a 'field', or neither. */
export function kindOfMember(statement) {
  const text = plain(statement);
  if (text === '' || /^(using|friend|typedef|template|enum|class|struct)\b/.test(text)) {
    return null;
  }
  const beforeValue = text.split('=')[0];
  if (beforeValue.includes('(') || /\boperator\b/.test(text)) {
    return 'method';
  }
  return /\bconstexpr\b/.test(text) ? null : 'field';
}

function kindOfBlock(head, parent) {
  const text = plain(head);
  if (parent === 'function') {
    return 'function';
  }
  if (/\bnamespace\b/.test(text) || /^extern\b/.test(text)) {
    return 'namespace';
  }
  const type = text.match(/^(?:template\s*)?(class|struct|union|enum)\b/);
  if (type !== null && !text.includes('(')) {
    return type[1] === 'class' ? 'class' : 'record';
  }
  // `: member_{1}, ...` of a constructor is no body yet.
  const initialises = /\)\s*:(?!:)/.test(text) && /\w$/.test(text);
  return text.split('=')[0].includes('(') && !initialises ? 'function' : 'value';
}

/** Reads a source block by block. */
class Scanner {
  classes = [];
  functions = [];
  #text;
  #stack = [{ kind: 'namespace' }];
  #start = 0; // of the statement

  constructor(source) {
    this.#text = bare(source);
    for (let i = 0; i < this.#text.length; ++i) {
      this.#read(i);
    }
  }

  #read(i) {
    const sign = this.#text[i];
    if (sign === ';' && this.#block.kind !== 'function') {
      this.#count(this.#text.slice(this.#start, i));
      this.#start = i + 1;
    } else if (sign === '{') {
      this.#open(i);
    } else if (sign === '}' && this.#stack.length > 1) {
      this.#close(i);
    }
  }

  get #block() {
    return this.#stack.at(-1);
  }

  #lineOf(place) {
    return this.#text.slice(0, place).split('\n').length;
  }

  /** Takes note of the access labels before a statement. @returns the statement. */
  #withoutLabels(head) {
    const { access, rest } = unlabelled(head);
    this.#block.access = access ?? this.#block.access;
    return rest;
  }

  /** Counts a statement where it is a private member. */
  #count(head) {
    const statement = this.#withoutLabels(head);
    const { kind, access, about } = this.#block;
    const member = kind === 'class' && access === 'private' ? kindOfMember(statement) : null;
    if (member !== null) {
      about[member === 'method' ? 'methods' : 'fields'] += 1;
    }
  }

  #open(i) {
    const head = this.#withoutLabels(this.#text.slice(this.#start, i));
    const kind = kindOfBlock(head, this.#block.kind);
    const line = this.#lineOf(i - head.trimStart().length);
    const inner = { kind, line, head, access: 'private', about: null };
    if (kind === 'class') {
      const name = plain(head).match(/class\s+(?:\w+\s+)*?(\w+)\s*(?:final)?\s*(?::|$)/)?.[1];
      inner.about = { name: name ?? '?', line, methods: 0, fields: 0 };
      this.classes.push(inner.about);
    }
    this.#stack.push(inner);
    this.#start = kind === 'value' ? this.#start : i + 1;
  }

  #close(i) {
    const { kind, head, line } = this.#stack.pop();
    if (kind === 'function' && this.#block.kind !== 'function') {
      const name = plain(head).match(/([\w:~]+)\s*\(/)?.[1] ?? '?';
      this.functions.push({ name, line, lines: this.#lineOf(i) - line + 1 });
      this.#count(head);
    }
    // A value in braces belongs to the statement that it stands in.
    this.#start = kind === 'value' ? this.#start : i + 1;
  }
}

/**
 * The classes and functions of a source.
 * @returns {{classes: {name: string, line: number, methods: number, fields: number}[],
 *     functions: {name: string, line: number, lines: number}[]}}
 */
export function scan(source) {
  const { classes, functions } = new Scanner(source);
  return { classes, functions };
}

function sourcesIn(folder) {
  return existsSync(folder)
    ? readdirSync(folder)
        .filter((name) => /\.(h|cpp)$/.test(name))
        .sort()
        .map((name) => join(folder, name))
    : [];
}

/** All breaches under a root folder, one line each. */
export function checkClasses(root, { folders, methods, fields, lines }) {
  return folders
    .flatMap((folder) => sourcesIn(join(root, folder)))
    .flatMap((file) => {
      const name = relative(root, file);
      const { classes, functions } = scan(readFileSync(file, 'utf8'));
      return [
        ...classes
          .filter((c) => c.methods > methods)
          .map(
            (c) =>
              `${name}:${c.line}: ${c.name} has ${c.methods} private methods, ${methods} at most`,
          ),
        ...classes
          .filter((c) => c.fields > fields)
          .map((c) => `${name}:${c.line}: ${c.name} has ${c.fields} fields, ${fields} at most`),
        ...functions
          .filter((f) => f.lines > lines)
          .map((f) => `${name}:${f.line}: ${f.name} has ${f.lines} lines, ${lines} at most`),
      ];
    });
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const limits = JSON.parse(readFileSync(join(HERE, 'classes.json'), 'utf8'));
  const problems = checkClasses(resolve(process.argv[2] ?? join(HERE, '../..')), limits);
  for (const problem of problems) {
    console.error(problem);
  }
  process.exit(problems.length > 0 ? 1 : 0);
}
