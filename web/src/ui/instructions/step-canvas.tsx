import { useEffect, useRef, useState } from 'preact/hooks';
import { fillWords } from '../../tools/tool-words.ts';
import type { Book } from './book.ts';
import { instructionWords as words } from './instruction-words.ts';
import { type Arrow, drawStep } from './step-picture.ts';

const MAX_PIXELS = 1400;

/** The picture of a step, as large as its place. */
export function StepCanvas({ book, index }: { readonly book: Book; readonly index: number }) {
  const host = useRef<HTMLDivElement>(null);
  const canvas = useRef<HTMLCanvasElement>(null);
  const [size, setSize] = useState({ width: 0, height: 0 });
  const [arrows, setArrows] = useState<readonly Arrow[]>([]);
  useEffect(() => {
    const element = host.current;
    if (!element) {
      return;
    }
    const observer = new ResizeObserver(() => {
      const { width, height } = element.getBoundingClientRect();
      setSize({ width: Math.floor(width), height: Math.floor(height) });
    });
    observer.observe(element);
    return () => observer.disconnect();
  }, []);
  useEffect(() => {
    if (size.width < 20 || size.height < 20) {
      return;
    }
    // After the words are on screen: the picture takes a moment.
    const timer = setTimeout(() => {
      const scale = Math.min(1, MAX_PIXELS / Math.max(size.width, size.height));
      const width = Math.round(size.width * scale);
      const height = Math.round(size.height * scale);
      const drawn = drawStep(book, index, { width, height, margin: 24 });
      const target = canvas.current;
      if (target) {
        target.width = width;
        target.height = height;
        const image = new ImageData(drawn.picture.data, width, height);
        target.getContext('2d')?.putImageData(image, 0, 0);
        target.dataset['step'] = `${index + 1}`;
        setArrows(drawn.arrows);
      }
    });
    return () => clearTimeout(timer);
  }, [book, index, size]);
  const view = canvas.current;
  return (
    <div
      class="step-picture"
      ref={host}
      role="img"
      aria-label={`${words.picture}: ${fillWords(words.step, { n: index + 1, all: book.steps.length })}`}
    >
      <canvas ref={canvas} />
      <svg
        class="step-arrows"
        viewBox={`0 0 ${view?.width ?? 1} ${view?.height ?? 1}`}
        aria-hidden="true"
      >
        {arrows.map((arrow) => (
          <path key={JSON.stringify(arrow)} d={arrowPath(arrow)} />
        ))}
      </svg>
    </div>
  );
}

/** A shaft with a solid head. */
export function arrowPath({ x1, y1, x2, y2 }: Arrow, half = 7, head = 16): string {
  const size = Math.hypot(x2 - x1, y2 - y1) || 1;
  const ux = (x2 - x1) / size;
  const uy = (y2 - y1) / size;
  const neck = Math.max(0, size - head);
  const at = (along: number, across: number) =>
    `${(x1 + ux * along - uy * across).toFixed(1)} ${(y1 + uy * along + ux * across).toFixed(1)}`;
  const thin = half / 3;
  return (
    `M${at(0, -thin)}L${at(neck, -thin)}L${at(neck, -half)}L${at(size, 0)}` +
    `L${at(neck, half)}L${at(neck, thin)}L${at(0, thin)}Z`
  );
}
