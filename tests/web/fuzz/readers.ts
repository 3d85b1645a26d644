// What must hold whatever bytes a reader of the page gets: an answer, never a throw; a refusal says why in one line; what
// is taken can be used. Driven by a coverage-guided fuzzer (scripts/fuzz-targets.mjs) and over the kept inputs
// (corpora.test.ts).
import catalogueFile from '../../../core/parts/catalogue.json' with { type: 'json' };
import { bad, type Outcome } from '../../../web/src/base/outcome.ts';
import { readCatalogue } from '../../../web/src/model/catalogue.ts';
import { readPartsList } from '../../../web/src/model/parts-list.ts';
import { decodeShare, encodeShare, packFragment } from '../../../web/src/share/codec.ts';
import { decodeText } from '../../../web/src/share/decode-text.ts';
import { readMpd } from '../../../web/src/share/read-mpd.ts';
import { readObj } from '../../../web/src/share/read-obj.ts';
import { readSketch } from '../../../web/src/state/read-sketch.ts';

const catalogue = readCatalogue(catalogueFile);
const known = new Set(catalogue.parts.map(({ id }) => id));

function demand(holds: boolean, what: string): void {
  if (!holds) {
    throw new Error(what);
  }
}

function demandReason(answer: Outcome<unknown>): void {
  if (!answer.ok) {
    demand(answer.message !== '', 'a refusal says why');
    demand(!answer.message.includes('\n'), `a refusal is one line: ${answer.message}`);
  }
}

function textOf(data: Uint8Array): string {
  return decodeText(new Uint8Array(data));
}

/** What a person reads of a file that was taken otherwise than it stands there. */
function demandSentence(sentence: string): void {
  demand(sentence !== '' && !sentence.includes('\n'), 'a note is one line');
}

function mpd(data: Uint8Array): void {
  const answer = readMpd(textOf(data), catalogue, { note: demandSentence });
  demandReason(answer);
  if (!answer.ok) {
    return;
  }
  const { parts } = JSON.parse(answer.value) as {
    parts: { part: string; position: number[]; rotation: number[] }[];
  };
  demand(parts.length > 0, 'a model has parts');
  for (const { part, position, rotation } of parts) {
    demand(known.has(part), `${part} is known`);
    demand([...position, ...rotation].every(Number.isFinite), `${part} is somewhere`);
  }
}

function obj(data: Uint8Array): void {
  const answer = readObj(textOf(data), 'fuzz', demandSentence);
  demandReason(answer);
  if (answer.ok) {
    demandReason(readSketch(JSON.stringify(answer.value)));
  }
}

function parts(data: Uint8Array): void {
  const answer = readPartsList(textOf(data), known);
  demandReason(answer);
  for (const [part, count] of answer.ok ? answer.value.counts : []) {
    demand(known.has(part), `${part} is known`);
    demand(Number.isInteger(count) && count >= 0, `${count} of ${part}`);
  }
}

function sketch(data: Uint8Array): void {
  const answer = readSketch(textOf(data));
  demandReason(answer);
  if (answer.ok) {
    const again = readSketch(JSON.stringify(answer.value));
    demand(again.ok, 'what is read can be read again');
    demand(JSON.stringify(again.ok && again.value) === JSON.stringify(answer.value), 'as it was');
  }
}

/** An odd first byte: the text of a link's content, well packed; an even one: the link itself. */
async function link(data: Uint8Array): Promise<void> {
  const [first = 0] = data;
  const text = textOf(data.subarray(1));
  const fragment = first % 2 === 1 ? await packFragment(`${1 + ((first >> 1) % 4)}`, text) : text;
  const answer = await decodeShare(fragment);
  demandReason(answer ?? bad('none of ours'));
  if (answer?.ok) {
    const again = await encodeShare(answer.value);
    demandReason(again);
    const back = again.ok ? await decodeShare(again.value) : null;
    demand(!again.ok || back?.ok === true, 'what a link gives can be linked again');
  }
}

export type Target = (data: Uint8Array) => void | Promise<void>;

export const READERS: Readonly<Record<string, Target>> = { link, mpd, obj, parts, sketch };
