import type { Outcome } from '../../base/outcome.ts';
import { encodeShare, type SharedState } from '../../share/codec.ts';

/** The folder of the page that is open, with a slash at its end. */
export function pageFolder(href: string): string {
  return new URL('./', href).href;
}

/** The address that opens a sketch with its settings. */
export async function linkTo(state: SharedState, href: string): Promise<Outcome<string>> {
  const fragment = await encodeShare(state);
  return fragment.ok ? { ok: true, value: `${pageFolder(href)}#${fragment.value}` } : fragment;
}

/** HTML that shows the viewer in somebody else's page. */
export function embedHtml(link: string, title: string): string {
  const [folder = '', fragment = ''] = link.split('#');
  const safe = title.replace(/[&<>"]/g, (c) => `&#${c.charCodeAt(0)};`);
  return (
    `<iframe src="${folder}embed.html#${fragment}" title="${safe}" loading="lazy" ` +
    'width="640" height="480" style="border:0" allow="fullscreen"></iframe>'
  );
}
