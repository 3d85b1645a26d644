const LETTERS = 'ABCxyz019-_.%#<"';

/** A seeded generator, 0 to 1: the same damage every time. */
export function random(seed: number): () => number {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 4294967296;
  };
}

/** The checksum is put right, so that the damage reaches the inner layers. */
export function withSum(fragment: string): string {
  const [head = '', packed = ''] = fragment.split('.');
  let hash = 0x811c9dc5;
  for (let i = 0; i < packed.length; i++) {
    hash = Math.imul(hash ^ packed.charCodeAt(i), 0x01000193);
  }
  return `${head}.${packed}.${(hash >>> 0).toString(36)}`;
}

/** A link's fragment with one to three letters changed, left out or put in. */
export function mutate(link: string, next: () => number): string {
  const letters = [...link];
  const times = 1 + Math.floor(next() * 3);
  for (let i = 0; i < times; i++) {
    const at = Math.floor(next() * letters.length);
    const letter = LETTERS[Math.floor(next() * LETTERS.length)] ?? 'A';
    letters.splice(at, next() < 0.5 ? 1 : 0, ...(next() < 0.7 ? [letter] : []));
  }
  return next() < 0.6 ? withSum(letters.join('')) : letters.join('');
}
