import { readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { describe, expect, it } from 'vitest';
import { PHRASES_DE, SENTENCES_DE } from '../../../web/src/ui/text/de/sentences.ts';
import { makeInterpreter } from '../../../web/src/ui/text/sentences.ts';

const SOURCES = resolve(import.meta.dirname, '../../../web/src');

/** Where sentences are written that no words of the interface stand for. */
const READERS = [
  'state/read-sketch.ts',
  'share/codec.ts',
  'share/read-obj.ts',
  'share/read-mpd.ts',
  'model/parts-list.ts',
  'instructions/assembly-plan.ts',
];

const german = makeInterpreter(SENTENCES_DE, PHRASES_DE);

/** The sentences in a source: what `bad` and `Refusal` are given, with a7 for each value. */
function sentencesIn(file: string): string[] {
  const source = readFileSync(resolve(SOURCES, file), 'utf8');
  const literals = /(?:bad|Refusal)\(\s*(?:'((?:[^'\\]|\\.)*)'|`((?:[^`\\]|\\.)*)`)/g;
  return [...source.matchAll(literals)].map((match) =>
    (match[1] ?? match[2] ?? '').replace(/\$\{(?:[^{}]|\{[^{}]*\})*\}/g, 'a7'),
  );
}

describe('sentences of the core and of readers', () => {
  const say = makeInterpreter(
    [
      ['{n} heads in holes', '{n} Köpfe in Löchern'],
      ['missing; expected {wanted}', 'fehlt; erwartet wird {wanted}'],
      ['an object (such as {example})', 'ein Objekt (etwa {example})'],
    ],
    [['lines', 'Linien']],
  );

  it('are said with their values', () => {
    expect(say('12 heads in holes')).toBe('12 Köpfe in Löchern');
  });

  it('are said after the place that they are about', () => {
    expect(say('joints[3].at: missing; expected 3')).toBe('joints[3].at: fehlt; erwartet wird 3');
  });

  it('may be values of others', () => {
    expect(say('a: missing; expected an object (such as {})')).toBe(
      'a: fehlt; erwartet wird ein Objekt (etwa {})',
    );
  });

  it('know phrases inside a sentence only', () => {
    expect(say('missing; expected lines')).toBe('fehlt; erwartet wird Linien');
    expect(say('lines')).toBe('lines');
  });

  it('stay as they are when no form fits', () => {
    expect(say('lines[2]: something new')).toBe('lines[2]: something new');
  });
});

describe('the German table', () => {
  it.each([...SENTENCES_DE, ...PHRASES_DE])('carries over each value of: %s', (english, other) => {
    const values = (text: string) => [...text.matchAll(/\{(\w+)\}/g)].map((m) => m[1]).sort();
    expect(values(other)).toEqual(values(english));
  });

  it.each(READERS)('knows every sentence of %s', (file) => {
    const sentences = sentencesIn(file);
    expect(sentences.length).toBeGreaterThan(0);
    expect(sentences.filter((sentence) => german(sentence) === sentence)).toEqual([]);
  });

  it('says a form of its own before a shorter one that fits too', () => {
    expect(
      german('lines[0]: from and to are the same point; a line is at least 1 module long'),
    ).toBe('lines[0]: from und to sind derselbe Punkt; eine Linie ist mindestens 1 Modul lang');
  });
});
