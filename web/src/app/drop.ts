import type { Signal } from '@preact/signals';

/** Opens files that are dropped anywhere on the page. */
export function listenToDrops(dropping: Signal<boolean>, open: (file: File) => void): void {
  const carriesFiles = (event: DragEvent) => event.dataTransfer?.types.includes('Files') ?? false;
  window.addEventListener('dragover', (event) => {
    if (carriesFiles(event)) {
      event.preventDefault();
      dropping.value = true;
    }
  });
  window.addEventListener('dragleave', (event) => {
    // Leaving the window has nowhere to go to; leaving an element inside of it has.
    if (event.relatedTarget === null) {
      dropping.value = false;
    }
  });
  window.addEventListener('drop', (event) => {
    dropping.value = false;
    const file = event.dataTransfer?.files[0];
    if (file) {
      event.preventDefault();
      open(file);
    }
  });
}
