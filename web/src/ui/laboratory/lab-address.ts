/** Keys of the laboratory in the address. */
export const LAB_KEYS = { tab: 'lab', race: 'race' } as const;

type LabKey = (typeof LAB_KEYS)[keyof typeof LAB_KEYS];

export function textInAddress(key: LabKey): string {
  return new URLSearchParams(location.search).get(key) ?? '';
}

/** Changes the address in place: the back button leaves the room, and not the choices one by one. */
export function setInAddress(key: LabKey, value: string | null): void {
  const url = new URL(location.href);
  if (value === null) {
    url.searchParams.delete(key);
  } else {
    url.searchParams.set(key, value);
  }
  history.replaceState(history.state, '', url.href);
}
