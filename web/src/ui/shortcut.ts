/** The parts of a keyboard event that decide on a shortcut. */
export interface KeyPress {
  readonly key: string;
  /** The place on the keyboard, such as `KeyZ`. */
  readonly code?: string;
  readonly ctrlKey: boolean;
  readonly metaKey: boolean;
  readonly shiftKey: boolean;
  readonly altKey: boolean;
}

/** How a key is written where its name is too long. */
const SHORT: Readonly<Record<string, string>> = {
  Mod: 'Ctrl',
  Escape: 'Esc',
  Plus: '+',
  ArrowLeft: '←',
  ArrowRight: '→',
  ArrowUp: '↑',
  ArrowDown: '↓',
};

const SYMBOLS: Readonly<Record<string, string>> = {
  Mod: '⌘',
  Shift: '⇧',
  Alt: '⌥',
  Enter: '↵',
  Delete: '⌦',
  Escape: 'Esc',
};

/**
 * The key as our shortcuts name it. What a layout says counts where it is one of our signs: who has a French
 * or a German keyboard presses the letter that is printed on it. Where it is another script's, as on Cyrillic,
 * Greek, Hebrew or Arabic layouts, the place on the keyboard counts: Z is where Z is on an English one.
 */
export function keyOf({ key, code }: Pick<KeyPress, 'key' | 'code'>): string {
  if (key.length !== 1 || key.charCodeAt(0) < 128) {
    return key;
  }
  const place = /^(?:Key|Digit|Numpad)([A-Z0-9])$/.exec(code ?? '')?.[1];
  return place?.toLowerCase() ?? key;
}

/** Whether a key press is the shortcut `Mod+Shift+K`. Letters match in either case. */
export function matchesShortcut(press: KeyPress, shortcut: string, mac: boolean): boolean {
  const parts = shortcut.split('+');
  const last = parts.at(-1) ?? '';
  // The sign that joins the parts cannot stand for itself.
  const key = last === 'Plus' ? '+' : last;
  const mod = mac ? press.metaKey : press.ctrlKey;
  const other = mac ? press.ctrlKey : press.metaKey;
  return (
    keyOf(press).toLowerCase() === key.toLowerCase() &&
    mod === parts.includes('Mod') &&
    !other &&
    press.altKey === parts.includes('Alt') &&
    // A sign such as ? needs Shift on some keyboards and not on others.
    (press.shiftKey === parts.includes('Shift') || /^[^a-z0-9]$/i.test(key))
  );
}

/** The keys of a shortcut as they stand on the keyboard. */
export function shortcutKeys(shortcut: string, mac: boolean): string[] {
  return shortcut.split('+').map((part) => {
    const short = SHORT[part] ?? part;
    return mac ? (SYMBOLS[part] ?? short) : short;
  });
}
