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
    linkLeftOut:
      'Der Link hat Einstellungen, die diese Seite nicht kennt; sie sind weggelassen: {list}',
    download: 'Skizze herunterladen',
    restored: 'Ihre letzte Skizze ist wieder da.',
    storeFull:
      'Der Browser konnte die Skizze nicht sichern. Laden Sie sie herunter, damit nichts verloren geht.',
    settingsRefused:
      'Der Browser konnte Ihre Einstellungen nicht für den nächsten Besuch behalten.',
    storeFrame:
      'Im Rahmen einer anderen Seite wird nichts behalten. Laden Sie die Skizze herunter, bevor Sie gehen.',
    storeNone:
      'Dieser Browser behält nichts zwischen den Besuchen. Laden Sie die Skizze herunter, bevor Sie gehen.',
    exportFailed: 'Die Datei ließ sich nicht schreiben: {message}',
    reading: '{name} wird gelesen …',
  },
  mends: {
    look: 'Abhilfe suchen',
    looking: 'Andere Pins werden probiert …',
    none: 'Kein anderer Pin hilft hier.',
    done: '{after} statt {before}: Es stimmt nun alles.',
    part: '{after} statt {before}: An {n} Stellen stimmt noch etwas nicht.',
  },
  legal: {
    show: 'Die nächste baubare zeigen',
    title: 'Die nächste Zeichnung, die sich bauen lässt',
    moved: '{n} von {all} Linien ändern sich; kein Ende rückt weiter als {most} Module.',
    before: 'Wie sie in der Datei steht',
    after: 'Mit ganzen Längen',
    line: 'Linie {n}: aus {before} wird {after}',
    more: 'und {n} weitere',
    take: 'Diese nehmen',
    leave: 'So lassen',
  },
  tabs: {
    changed: 'In einem anderen Tab geändert; das ist der neueste Stand.',
    removed:
      'Diese Skizze wurde in einem anderen Tab gelöscht. Hier bleibt sie, und Ihre nächste Änderung sichert sie wieder.',
    forked:
      'Ein anderer Tab hat diese Skizze inzwischen geändert. Was auf dieser Seite steht, ist als eigene Skizze gesichert; die andere ist unter Ihren Skizzen.',
    notRemoved:
      'Ein anderer Tab hat diese Skizze geändert, seit sie gelistet wurde; sie wurde nicht gelöscht.',
  },
};
