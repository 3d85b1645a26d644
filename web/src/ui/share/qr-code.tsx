import qrcode from 'qrcode-generator';

/** A QR code of level L holds this many bytes at most (version 40). */
export const MAX_QR_BYTES = 2953;
const QUIET = 4;

/** The SVG path of a text's QR code and the number of modules on a side; null when it is too long. */
export function qrPath(text: string): { readonly path: string; readonly size: number } | null {
  if (new TextEncoder().encode(text).length > MAX_QR_BYTES) {
    return null;
  }
  const code = qrcode(0, 'L');
  code.addData(text, 'Byte');
  code.make();
  const count = code.getModuleCount();
  const rows: string[] = [];
  for (let y = 0; y < count; y++) {
    for (let x = 0; x < count; x++) {
      if (code.isDark(y, x)) {
        rows.push(`M${x + QUIET} ${y + QUIET}h1v1h-1z`);
      }
    }
  }
  return { path: rows.join(''), size: count + 2 * QUIET };
}

/** The code as an SVG file. */
export function qrSvg(text: string): string | null {
  const code = qrPath(text);
  return (
    code &&
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${code.size} ${code.size}">` +
      `<rect width="100%" height="100%" fill="#fff"/><path d="${code.path}" fill="#000"/></svg>\n`
  );
}

/** A QR code, black on white in every theme: that is what cameras read. */
export function QrCode(props: { readonly text: string; readonly label: string }) {
  const code = qrPath(props.text);
  return code ? (
    <svg
      class="qr-code"
      viewBox={`0 0 ${code.size} ${code.size}`}
      role="img"
      aria-label={props.label}
      data-text={props.text}
    >
      <rect width="100%" height="100%" fill="#fff" />
      <path d={code.path} fill="#000" />
    </svg>
  ) : null;
}
