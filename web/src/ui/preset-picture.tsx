/** What a preset does to an L of two lines: where its beams lie, and whether the corner is stiff. */
const BEAMS: Readonly<Record<string, readonly string[]>> = {
  balanced: ['M12 38H56', 'M14 38V12', 'M14 24 28 38'],
  simple: ['M12 44H56', 'M20 44V12'],
  faithful: ['M12 38H56', 'M14 38V12'],
  'simple-rigid': ['M12 44H56', 'M20 44V12', 'M20 22 42 44'],
  'faithful-rigid': ['M12 38H56', 'M14 38V12', 'M14 18 34 38'],
};

/** A small drawing of a preset: dashed lines of the sketch, bars of the model. */
export function PresetPicture({ preset }: { readonly preset: string }) {
  return (
    <svg class="preset-picture" viewBox="0 0 64 52" aria-hidden="true">
      {(BEAMS[preset] ?? []).map((path) => (
        <path key={path} class="bar" d={path} />
      ))}
      <path class="line" d="M14 12V38H56" />
    </svg>
  );
}
