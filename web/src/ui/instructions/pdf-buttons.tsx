import { useRef, useState } from 'preact/hooks';
import { fillWords } from '../../tools/tool-words.ts';
import { safeName, saveFile } from '../share/save-file.ts';
import type { Book } from './book.ts';
import { instructionWords as words } from './instruction-words.ts';
import type { PaperName } from './pdf/paper.ts';

/** Print and PDF. Both are the same pages: what is printed is what is saved. */
export function PdfButtons({ book }: { readonly book: Book }) {
  const [said, setSaid] = useState('');
  const [bad, setBad] = useState(false);
  const busy = useRef(false);
  const frame = useRef<HTMLIFrameElement>(null);
  const make = async (paper: PaperName): Promise<Blob | null> => {
    if (busy.current) {
      return null;
    }
    busy.current = true;
    setBad(false);
    try {
      const { makePdf } = await import('./pdf/make-pdf.ts');
      const pdf = await makePdf(book, paper, (n, all) =>
        setSaid(fillWords(words.making, { n, all })),
      );
      setSaid('');
      return pdf;
    } catch (error) {
      setBad(true);
      setSaid(fillWords(words.pdfFailed, { message: String(error) }));
      return null;
    } finally {
      busy.current = false;
    }
  };
  const save = async (paper: PaperName): Promise<void> => {
    const pdf = await make(paper);
    if (pdf) {
      saveFile(safeName(book.title, `${paper.toLowerCase()}.pdf`), pdf);
    }
  };
  const print = async (): Promise<void> => {
    const pdf = await make(/^(en-US|en-CA|es-MX)$/.test(navigator.language) ? 'Letter' : 'A4');
    const target = frame.current;
    if (pdf && target) {
      target.onload = () => target.contentWindow?.print();
      target.src = URL.createObjectURL(pdf);
    }
  };
  const button = (label: string, work: () => Promise<void>) => (
    <button
      type="button"
      class="button"
      onClick={() => {
        work().catch(() => undefined);
      }}
    >
      {label}
    </button>
  );
  return (
    <div class="pdf-buttons">
      <span role={bad ? 'alert' : 'status'} class="quiet">
        {said}
      </span>
      {button(words.print, print)}
      {button(words.pdfA4, () => save('A4'))}
      {button(words.pdfLetter, () => save('Letter'))}
      <iframe
        class="print-frame"
        ref={frame}
        title={words.print}
        tabIndex={-1}
        aria-hidden="true"
      />
    </div>
  );
}
