// What parts of a drawing are for screen readers and keys. SVG has no elements of its own for these, and
// its attributes know upper and lower case: tabIndex would be another one.

export const FIGURE = { role: 'group' } as const;
/** A drawing that is worked with keys as a whole. */
export const BOARD = { role: 'group', tabindex: 0 } as const;

/** What makes a part of a drawing a button. @param pressed for parts that stay chosen. */
export function pressable(label: string, onPress: () => void, pressed?: boolean) {
  return {
    role: 'button',
    tabindex: 0,
    'aria-label': label,
    ...(pressed === undefined ? {} : { 'aria-pressed': pressed }),
    onClick: onPress,
    onKeyDown: (event: KeyboardEvent) => {
      if (event.key === 'Enter' || event.key === ' ') {
        event.preventDefault();
        onPress();
      }
    },
  } as const;
}
