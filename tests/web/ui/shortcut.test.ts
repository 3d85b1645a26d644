import { describe, expect, it } from 'vitest';
import { matchesShortcut, shortcutKeys } from '../../../web/src/ui/shortcut.ts';

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

  it('names the keys of each system', () => {
    expect(shortcutKeys('Mod+Shift+Z', false)).toEqual(['Ctrl', 'Shift', 'Z']);
    expect(shortcutKeys('Mod+Shift+Z', true)).toEqual(['⌘', '⇧', 'Z']);
  });
});
