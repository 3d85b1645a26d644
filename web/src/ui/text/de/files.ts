import type { FILES_EN } from '../en/files.ts';
import type { Words } from '../language.ts';

export const FILES_DE: Words<typeof FILES_EN> = {
  files: {
    drop: 'Eine Skizze oder ein Modell hier ablegen',
    opened: '{name} ist geöffnet.',
    openedModel: 'Das Modell {name} ist geöffnet und geprüft.',
    refused: '{name}: {message}',
    tooLarge: 'Die Datei ist größer als 32 MB; mehr geht nicht',
    empty: 'Die Datei ist leer',
    neither: 'Das ist weder eine Skizze noch ein Modell von uns',
    notJson: 'Das ist kein JSON, oder ein Stück davon fehlt',
    unreadable: 'Die Datei ließ sich nicht lesen',
    badModel: 'parts[{i}]: braucht part, position und rotation',
    copied: 'Link kopiert.',
    copyFailed: 'Der Browser ließ uns nicht kopieren. Der Link steht in der Adresszeile.',
    fromLink: 'Aus einem Link geöffnet.',
    restored: 'Ihre letzte Skizze ist wieder da.',
    storeFull:
      'Der Browser konnte die Skizze nicht sichern. Laden Sie sie herunter, damit nichts verloren geht.',
    storeNone:
      'Dieser Browser behält nichts zwischen den Besuchen. Laden Sie die Skizze herunter, bevor Sie gehen.',
    exportFailed: 'Die Datei ließ sich nicht schreiben: {message}',
    checking: '{name} wird geprüft …',
  },
};
