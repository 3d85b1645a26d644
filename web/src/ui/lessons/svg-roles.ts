// What parts of a drawing are for screen readers and keys. SVG has no elements of its own for these.

export const FIGURE = { role: 'group' } as const;
export const PRESSABLE = { role: 'button', tabIndex: 0 } as const;
/** A drawing that is worked with keys as a whole. */
export const BOARD = { role: 'group', tabIndex: 0 } as const;
