import { useEffect, useRef } from 'preact/hooks';
import type { Model } from '../../model/model.ts';
import { cameraFor, ISO_OUT } from '../../view/drawing/drawing-camera.ts';
import { drawn, type MeshShelf } from '../../view/drawing/drawn-part.ts';
import { drawPicture } from '../../view/drawing/picture.ts';

const SIZE = { width: 240, height: 170, margin: 6, maxScale: 24 } as const;
const STYLE = { detail: 'low', smooth: 2, line: 0.5 } as const;

/** A whole model, small, as the page shows it at first. */
export function ModelPicture({
  model,
  shelf,
}: {
  readonly model: Model;
  readonly shelf: MeshShelf;
}) {
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(() => {
    const parts = model.parts.map(drawn);
    const points = parts.flatMap((part) => shelf.corners(part));
    const { data, width, height } = drawPicture(
      parts,
      cameraFor(points, ISO_OUT, SIZE),
      shelf,
      STYLE,
    );
    canvas.current?.getContext('2d')?.putImageData(new ImageData(data, width, height), 0, 0);
  }, [model, shelf]);
  return <canvas ref={canvas} width={SIZE.width} height={SIZE.height} />;
}
