import { safeName } from '../ui/share/save-file.ts';

/** The name of a file that the sketch's own commands save. */
export function fileName(title: string, extension: string): string {
  return safeName(title, extension, 'sketch');
}
