import '../../../styles/tokens.css';
import '../../../styles/base.css';
import './embed.css';

// The viewer for other people's pages: nothing heavy is loaded before the reader sees the frame.

const host = document.getElementById('viewer');

async function begin(element: HTMLElement): Promise<void> {
  const { showLink } = await import('./viewer.ts');
  await showLink(element, location.hash.slice(1));
}

// Another link in the same frame: begin again.
window.addEventListener('hashchange', () => location.reload());

if (host) {
  const watcher = new IntersectionObserver((entries) => {
    if (entries.some((entry) => entry.isIntersecting)) {
      watcher.disconnect();
      begin(host).catch(() => host.append('Liftarm could not be loaded.'));
    }
  });
  watcher.observe(host);
}
