import { describe, expect, it } from 'vitest';
import { keyOf, matchesShortcut, shortcutKeys } from '../../../web/src/ui/shortcut.ts';

const press = (
  key: string,
  held: Partial<Record<'ctrl' | 'meta' | 'shift' | 'alt', boolean>> = {},
) => ({
  key,
  ctrlKey: held.ctrl ?? false,
  metaKey: held.meta ?? false,
  shiftKey: held.shift ?? false,
  altKey: held.alt ?? false,
});

describe('shortcuts', () => {
  it.each([
    [press('z', { ctrl: true }), 'Mod+Z', false, true],
    [press('z', { meta: true }), 'Mod+Z', true, true],
    [press('z', { ctrl: true }), 'Mod+Z', true, false],
    [press('Z', { ctrl: true, shift: true }), 'Mod+Z', false, false],
    [press('Z', { ctrl: true, shift: true }), 'Mod+Shift+Z', false, true],
    [press('l'), 'L', false, true],
    [press('L', { shift: true }), 'L', false, false],
    [press('?', { shift: true }), '?', false, true],
    [press('l', { alt: true }), 'L', false, false],
  ])('case %#', (event, shortcut, mac, expected) => {
    expect(matchesShortcut(event, shortcut, mac)).toBe(expected);
  });

  it.each([
    ['Cyrillic', { key: 'я', code: 'KeyZ' }, 'z'],
    ['Greek', { key: 'λ', code: 'KeyL' }, 'l'],
    ['Hebrew', { key: 'ז', code: 'KeyZ' }, 'z'],
    ['Arabic', { key: '٣', code: 'Digit3' }, '3'],
    ['German', { key: 'z', code: 'KeyY' }, 'z'],
    ['French', { key: 'a', code: 'KeyQ' }, 'a'],
    ['any', { key: 'Enter', code: 'Enter' }, 'Enter'],
  ])('takes a key of a %s layout', (_, press, key) => {
    expect(keyOf(press)).toBe(key);
  });

  it('undoes with a Cyrillic layout', () => {
    const event = { ...press('я', { ctrl: true }), code: 'KeyZ' };
    expect(matchesShortcut(event, 'Mod+Z', false)).toBe(true);
  });

  it('names the keys of each system', () => {
    expect(shortcutKeys('Mod+Shift+Z', false)).toEqual(['Ctrl', 'Shift', 'Z']);
    expect(shortcutKeys('Mod+Shift+Z', true)).toEqual(['⌘', '⇧', 'Z']);
  });
});
