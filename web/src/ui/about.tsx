import { Dialog } from './dialog.tsx';
import { text } from './text.ts';

/** Licence, trademark and sources. */
export function About() {
  const { about } = text;
  return (
    <Dialog title={about.title} class="about">
      <p>{about.text}</p>
      <p>{about.method}</p>
      <p>{about.sources}</p>
      <p>
        {about.licence} {about.librariesTitle}: {about.libraries}
      </p>
      <p>
        <a href="./licences.txt" target="_blank" rel="noopener">
          {about.allLicences}
        </a>
      </p>
      <p class="quiet">{about.trademark}</p>
    </Dialog>
  );
}
