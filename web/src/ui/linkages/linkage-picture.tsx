import { useEffect, useRef } from 'preact/hooks';
import type { LinkageAnswer, PlanePoint } from '../../model/linkage-answer.ts';
import { prefersReducedMotion } from '../../view/scene/defaults.ts';

const TURN_MS = 4000;
const MARGIN = 1;

/** A linkage that turns by itself: the drawn path, its own path, and its four links. */
export function LinkagePicture(props: {
  readonly answer: LinkageAnswer;
  readonly drawn: readonly PlanePoint[];
  readonly closed: boolean;
}) {
  const { answer, drawn, closed } = props;
  const links = useRef<SVGPathElement>(null);
  const dot = useRef<SVGCircleElement>(null);
  useEffect(() => {
    let frame = 0;
    const show = (time: number) => {
      const turn = prefersReducedMotion() ? 0 : (time % TURN_MS) / TURN_MS;
      const pose = answer.poses[Math.floor(turn * answer.poses.length)];
      if (pose) {
        links.current?.setAttribute('d', linksPath(answer, pose));
        dot.current?.setAttribute('cx', String(pose[4]));
        dot.current?.setAttribute('cy', String(-pose[5]));
      }
      frame = prefersReducedMotion() ? 0 : requestAnimationFrame(show);
    };
    show(0);
    return () => cancelAnimationFrame(frame);
  }, [answer]);
  const traced = answer.poses.map(([, , , , u, v]): PlanePoint => [u, v]);
  return (
    <svg class="linkage-picture" viewBox={boxOf(answer, drawn)} aria-hidden="true">
      <path class="linkage-drawn" d={linePath(drawn, closed)} />
      <path class="linkage-traced" d={linePath(traced, true)} />
      <path class="linkage-links" ref={links} />
      {answer.pivots.map(([u, v]) => (
        <circle key={`${u}/${v}`} class="linkage-pivot" cx={u} cy={-v} r={0.45} />
      ))}
      <circle class="linkage-dot" ref={dot} r={0.35} />
    </svg>
  );
}

/** SVG's y axis points down. */
export function linePath(points: readonly PlanePoint[], closed: boolean): string {
  const rows = points.map(([u, v], i) => `${i === 0 ? 'M' : 'L'}${u} ${-v}`);
  return rows.join('') + (closed && points.length > 2 ? 'Z' : '');
}

type Pose = LinkageAnswer['poses'][number];

function linksPath({ pivots }: LinkageAnswer, pose: Pose): string {
  const [[u, v], [s, t]] = pivots;
  const [au, av, bu, bv, pu, pv] = pose;
  return `M${u} ${-v}L${au} ${-av}M${s} ${-t}L${bu} ${-bv}M${au} ${-av}L${bu} ${-bv}L${pu} ${-pv}Z`;
}

function boxOf({ poses, pivots }: LinkageAnswer, drawn: readonly PlanePoint[]): string {
  const us = [...drawn, ...pivots].map(([u]) => u);
  const vs = [...drawn, ...pivots].map(([, v]) => -v);
  for (const [au, av, bu, bv, pu, pv] of poses) {
    us.push(au, bu, pu);
    vs.push(-av, -bv, -pv);
  }
  const left = Math.min(...us) - MARGIN;
  const top = Math.min(...vs) - MARGIN;
  return `${left} ${top} ${Math.max(...us) + MARGIN - left} ${Math.max(...vs) + MARGIN - top}`;
}
