import type { Picture } from '../../view/drawing/picture.ts';

/** A picture on a canvas of its own size. */
export function pictureCanvas(picture: Picture): HTMLCanvasElement {
  const canvas = document.createElement('canvas');
  canvas.width = picture.width;
  canvas.height = picture.height;
  canvas
    .getContext('2d')
    ?.putImageData(new ImageData(picture.data, picture.width, picture.height), 0, 0);
  return canvas;
}

/** A picture as PNG, or as JPEG on white. @throws Error when the browser cannot make one. */
export function pictureBlob(
  picture: Picture,
  type: 'image/png' | 'image/jpeg' = 'image/png',
): Promise<Blob> {
  const canvas = pictureCanvas(picture);
  if (type === 'image/jpeg') {
    const context = canvas.getContext('2d');
    if (context) {
      context.globalCompositeOperation = 'destination-over';
      context.fillStyle = '#ffffff';
      context.fillRect(0, 0, canvas.width, canvas.height);
    }
  }
  return new Promise((resolve, reject) => {
    canvas.toBlob(
      (blob) =>
        blob ? resolve(blob) : reject(new Error('The browser could not make the picture.')),
      type,
      0.92,
    );
  });
}
