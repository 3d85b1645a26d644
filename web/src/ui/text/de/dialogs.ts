import type { DIALOGS_EN } from '../en/dialogs.ts';
import type { Words } from '../language.ts';

export const DIALOGS_DE: Words<typeof DIALOGS_EN> = {
  examples: {
    title: 'Beispiele',
    text: 'Jedes ist eine Zeichnung zum Ansehen, Ändern und Erzeugen.',
    lines: '{n} Linien',
    missing: 'Die Beispiele ließen sich nicht laden.',
  },
  bricks: {
    title: 'Teilesatz',
    text: 'Ausgeschaltete Teile werden nicht verwendet. Mit Anzahlen sagt die Teileliste, was fehlt.',
    import: 'Teileliste öffnen …',
    reset: 'Alle Teile, ohne Anzahl',
    owned: 'Vorhanden',
    ownedOf: 'Wie viele von {name} da sind',
    needed: 'Immer nötig: Linien in einer Flucht werden damit verbunden.',
    imported: '{n} Arten von Teilen aus {name} übernommen.',
    short: '{n} fehlen',
  },
  sketches: {
    title: 'Meine Skizzen',
    text: 'In diesem Browser aufbewahrt. Nichts wird hochgeladen.',
    create: 'Neue Skizze',
    import: 'Datei öffnen …',
    none: 'Noch ist nichts aufbewahrt: eine Linie genügt.',
    duplicate: '{name} verdoppeln',
    copyName: '{name} (Kopie)',
    remove: '{name} löschen',
    reallyRemove: '{name} endgültig löschen',
    confirm: 'Löschen?',
  },
  palette: {
    title: 'Alle Befehle',
    placeholder: 'Befehl suchen',
    none: 'Kein Befehl heißt so.',
  },
  help: {
    title: 'Tasten und Hilfe',
    text: 'Zeichnen Sie Linien von ganzer Länge; das Programm findet Balken, Pins und Achsen dafür. Alles lässt sich rückgängig machen.',
    pointer: 'Zeiger',
    pointerRows: [
      ['Klick', 'Punkt setzen oder auswählen'],
      ['Doppelklick', 'Kette von Linien auswählen'],
      ['Ziehen mit Umschalt', 'Mit einem Rahmen auswählen'],
      ['Ziehen mit der rechten Taste', 'Ansicht drehen'],
      ['Ziehen mit der mittleren Taste', 'Ansicht verschieben'],
      ['Rad', 'Vergrößern und verkleinern'],
      ['Ein Finger', 'Zeichnen'],
      ['Zwei Finger', 'Drehen und vergrößern'],
    ],
    drawing: 'Beim Zeichnen',
    drawingRows: [
      ['0–9', 'Länge tippen, Eingabe setzt den Punkt'],
      ['X Y Z', 'Achse sperren, noch einmal gibt sie frei'],
      ['Tab', 'Ebene drehen'],
      ['Pfeiltasten', 'Zeiger auf der Ebene bewegen'],
      ['Bild auf, Bild ab', 'Zeiger von der Ebene weg bewegen'],
      ['Eingabe', 'Punkt setzen'],
      ['Escape', 'Einen Schritt zurück'],
    ],
  },
  about: {
    title: 'Über Liftarm',
    text: 'Liftarm macht aus einer Strichskizze im Raum ein Technic-Modell, das sich bauen lässt: echte Teile, verbunden, ohne Zusammenstoß. Alles läuft in Ihrem Browser; nichts wird hochgeladen.',
    method:
      'Das Verfahren beruht auf „Computational LEGO Technic Design“ von Hao Xu, Ka-Hei Hui, Chi-Wing Fu und Hao Zhang, ACM Transactions on Graphics 38(6), 2019, und geht darüber hinaus.',
    trademark:
      'LEGO® ist eine Marke der LEGO Gruppe, die dieses Projekt weder fördert noch gutheißt.',
    sources:
      'Die Angaben zu den Teilen stammen aus der LDraw.org Parts Library (CC BY 4.0) und der LDCad Shadow Library von Roland Melkert und anderen (CC BY-SA 4.0).',
    licence: 'Lizenz: MIT.',
    allLicences: 'Die Lizenzen von allen',
    librariesTitle: 'Bibliotheken',
    libraries:
      'Preact, Preact Signals und three.js (MIT); im Rechner Eigen (MPL 2.0) und nlohmann/json (MIT).',
  },
};
