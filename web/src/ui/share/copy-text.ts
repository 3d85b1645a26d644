/**
 * Puts a text on the clipboard. Where the page comes from another machine without a certificate there is no clipboard
 * for scripts, but a selected text can still be copied. Rejects when neither works.
 */
export async function copyText(text: string): Promise<void> {
  // The typings know secure contexts alone.
  const clipboard = navigator.clipboard as Clipboard | undefined;
  if (clipboard) {
    await clipboard.writeText(text);
    return;
  }
  const field = document.createElement('textarea');
  field.value = text;
  field.readOnly = true;
  field.className = 'visually-hidden';
  const before = document.activeElement;
  document.body.append(field);
  field.select();
  const done = document.execCommand('copy');
  field.remove();
  if (before instanceof HTMLElement) {
    before.focus();
  }
  if (!done) {
    throw new Error('the browser did not copy');
  }
}
