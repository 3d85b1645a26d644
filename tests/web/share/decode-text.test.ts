import { describe, expect, it } from 'vitest';
import { decodeText } from '../../../web/src/share/decode-text.ts';

const wide = (text: string, endian: 'little' | 'big') => {
  const bytes = new Uint8Array(2 * text.length);
  const view = new DataView(bytes.buffer);
  [...text].forEach((letter, i) => {
    view.setUint16(2 * i, letter.charCodeAt(0), endian === 'little');
  });
  return bytes;
};

describe('the text of a file', () => {
  const text = '0 Träger\n1 71 0 0 0 32316.dat';

  it.each([
    ['UTF-8', new TextEncoder().encode(text)],
    ['UTF-8 with its mark', new TextEncoder().encode(`\uFEFF${text}`)],
    ['UTF-16 with its mark', wide(`\uFEFF${text}`, 'little')],
    ['UTF-16, the other way round', wide(`\uFEFF${text}`, 'big')],
    ['UTF-16 without a mark', wide(text, 'little')],
    ['Latin letters', Uint8Array.from(text, (letter) => letter.charCodeAt(0))],
  ])('is read from %s', (_name, bytes) => {
    expect(decodeText(new Uint8Array(bytes))).toBe(text);
  });

  it('may be nothing', () => {
    expect(decodeText(new Uint8Array())).toBe('');
  });
});
