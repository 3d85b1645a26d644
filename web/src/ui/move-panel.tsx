import { placeOfJoint } from '../state/joint-edits.ts';
import { fillWords } from '../tools/tool-words.ts';
import { CheckRow } from './checks/checks-section.tsx';
import { FREEDOMS_CHECK } from './checks/freedoms.tsx';
import { JOINTS_CHECK } from './checks/joints.tsx';
import { NeedsModel } from './needs-model.tsx';
import type { ShownModel } from './page.ts';
import { usePage } from './page-context.ts';
import { text } from './text.ts';

/** The place for motion: each joint and shaft turned, and what else moves. */
export function MovePanel() {
  const page = usePage();
  const shown = page.shown.value;
  if (!shown || !page.result.value?.final) {
    return (
      <>
        <NeedsModel />
        <FromPath />
      </>
    );
  }
  const { joints = [], shafts = [] } = page.store.sketch.value;
  const turning = joints.length + shafts.length;
  return (
    <>
      <section class="move-joints">{turning > 0 ? <Joints shown={shown} /> : <NoJoints />}</section>
      <section class="checks-section">
        <h3>{text.places.looseTitle}</h3>
        <ul class="checks">
          <CheckRow view={FREEDOMS_CHECK} shown={shown} />
        </ul>
      </section>
      <FromPath />
    </>
  );
}

/** The way to a machine that draws a path. */
function FromPath() {
  const page = usePage();
  return (
    <p class="move-from-path">
      <button type="button" class="button" onClick={() => page.openRoom('linkage')}>
        {text.places.fromPath}
      </button>
    </p>
  );
}

function Joints({ shown }: { readonly shown: ShownModel }) {
  const page = usePage();
  // Asks for the study; what it opens to waits for the answer.
  const { state } = JOINTS_CHECK.status(page, shown);
  return (
    <>
      <h3>{text.places.jointsTitle}</h3>
      {state === 'busy' ? <p class="quiet">{text.app.loading}</p> : null}
      <JOINTS_CHECK.component shown={shown} />
      <ChangeJoints />
    </>
  );
}

/** The way from a joint of the model to the drawing, where it is changed. */
function ChangeJoints() {
  const page = usePage();
  const sketch = page.store.sketch.value;
  if (!sketch.joints?.length) {
    return null;
  }
  const change = (index: number) => {
    page.joint.value = placeOfJoint(sketch, index);
    page.useTool('joint');
    page.focusDrawing();
  };
  return (
    <p class="move-change">
      {(sketch.joints ?? []).map((joint, index) => (
        <button
          key={JSON.stringify(joint)}
          type="button"
          class="button small"
          onClick={() => change(index)}
        >
          {fillWords(text.joint.changeThis, { n: index + 1 })}
        </button>
      ))}
    </p>
  );
}

function NoJoints() {
  const page = usePage();
  return (
    <>
      <h3>{text.places.noJoints}</h3>
      <p class="quiet">{text.places.noJointsText}</p>
      <button type="button" class="button primary" onClick={() => page.commands.run('tool.joint')}>
        {text.places.addJoint}
      </button>
    </>
  );
}
