import { CommandButton } from './controls.tsx';
import { modelComing } from './model-coming.ts';
import { usePage } from './page-context.ts';
import { text } from './text.ts';

/** What a place says that needs a model and has none, with the ways to one. */
export function NeedsModel() {
  const page = usePage();
  const drawn = page.store.sketch.value.lines.length > 0;
  if (modelComing(page)) {
    return (
      <p class="needs-model" role="status">
        {text.rooms.solving}
      </p>
    );
  }
  return (
    <section class="needs-model">
      <h3>{text.places.needsModel}</h3>
      <p class="quiet">{drawn ? text.places.needsGenerate : text.places.needsModelText}</p>
      <div class="mends">
        {drawn ? (
          <CommandButton id="generate" words={text.solve.generate} class="primary" />
        ) : (
          <button type="button" class="button primary" onClick={() => page.openRoom(null)}>
            {text.places.toDraw}
          </button>
        )}
        <CommandButton id="examples" words={text.places.toExample} />
      </div>
    </section>
  );
}
