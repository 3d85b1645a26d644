import { Dialog } from './dialog.tsx';
import { usePage } from './page-context.ts';
import { SketchPicture } from './sketch-picture.tsx';
import { plural, text } from './text.ts';

/** The list of examples, each with a drawing. */
export function Examples() {
  const { examples, openExample, dialog } = usePage();
  const list = examples.value;
  return (
    <Dialog title={text.examples.title} class="examples">
      <p class="quiet">{text.examples.text}</p>
      {list === null ? <p>{text.app.loading}</p> : null}
      {list?.length === 0 ? <p role="alert">{text.examples.missing}</p> : null}
      <ul class="example-grid">
        {list?.map((example) => (
          <li key={example.file}>
            <button
              type="button"
              class="example"
              onClick={() => {
                dialog.value = null;
                openExample(example);
              }}
            >
              <SketchPicture sketch={example.sketch} />
              <strong>{example.title}</strong>
              <span class="quiet">{example.description}</span>
              <small class="quiet">{plural(example.sketch.lines.length, 'line')}</small>
            </button>
          </li>
        ))}
      </ul>
    </Dialog>
  );
}
