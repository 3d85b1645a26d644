import { ChecksSection } from './checks/checks-section.tsx';
import { WellBuiltSection } from './checks/well-built-section.tsx';
import { NeedsModel } from './needs-model.tsx';
import { usePage } from './page-context.ts';
import { FigureSection, ProblemSection } from './result-section.tsx';
import { SketchFaults } from './sketch-section.tsx';

/** The place for checking: everything that is wrong, and every check with what it opens to. */
export function CheckPanel() {
  const shown = usePage().result.value;
  return (
    <>
      <SketchFaults />
      {shown?.final ? (
        <>
          <ProblemSection result={shown} />
          <ChecksSection result={shown} />
          {shown.wellBuilt ? <WellBuiltSection built={shown.wellBuilt} /> : null}
          <FigureSection result={shown} />
        </>
      ) : (
        <NeedsModel />
      )}
    </>
  );
}
