import { useEffect, useRef } from 'preact/hooks';
import type { Vec3 } from '../../geometry/vec.ts';
import type { PlacedPart } from '../../model/model.ts';
import { StillRenderer } from '../../view/still/still-renderer.ts';
import type { PartDisplay } from '../../view/view-types.ts';
import { usePage } from '../page-context.ts';

const SIZE = { width: 960, height: 600 } as const;
const DIRECTION: Vec3 = [-0.35, -0.8, 0.5];

/** A picture of parts that is drawn again whenever they have moved. */
export function MovingPicture(props: {
  readonly parts: readonly PlacedPart[];
  readonly display?: PartDisplay | null;
  /** Points that must stay in the picture, modules; the parts' own corners when left out. */
  readonly frame?: readonly Vec3[];
  readonly label: string;
}) {
  const { catalogue, webglMissing } = usePage();
  const { parts, display, frame, label } = props;
  const host = useRef<HTMLDivElement>(null);
  const renderer = useRef<StillRenderer | null>(null);
  const missing = webglMissing.value;
  useEffect(() => {
    if (missing) {
      return undefined;
    }
    const made = new StillRenderer(catalogue);
    renderer.current = made;
    host.current?.append(made.canvas);
    return () => {
      renderer.current = null;
      made.canvas.remove();
      made.dispose();
    };
  }, [catalogue, missing]);
  useEffect(() => {
    renderer.current?.draw({
      ...SIZE,
      parts,
      direction: DIRECTION,
      backdrop: 'studio',
      ...(display ? { display } : {}),
      ...(frame ? { frame } : {}),
    });
  }, [parts, display, frame]);
  return <div class="moving-picture" ref={host} role="img" aria-label={label} />;
}
