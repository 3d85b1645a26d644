/** What a canvas shows at the time of the call, as a PNG. @throws Error when the browser cannot. */
export function canvasToPng(canvas: HTMLCanvasElement): Promise<Blob> {
  return new Promise<Blob>((resolve, reject) => {
    canvas.toBlob((blob) => {
      if (blob) {
        resolve(blob);
      } else {
        reject(new Error('The browser could not make a picture of the view.'));
      }
    }, 'image/png');
  });
}
