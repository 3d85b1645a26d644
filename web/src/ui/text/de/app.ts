import type { APP_EN } from '../en/app.ts';
import type { Words } from '../language.ts';

export const APP_DE: Words<typeof APP_EN> = {
  app: {
    name: 'Liftarm',
    tagline: 'Von der Strichskizze zum Technic-Modell, das sich bauen lässt',
    skip: 'Zur Zeichnung springen',
    drawing: 'Zeichnung',
    drawingHelp:
      'Dreidimensionale Zeichnung. Mit einem Zeichenwerkzeug bewegen die Pfeiltasten den Zeiger auf der Ebene, Bild auf und Bild ab bewegen ihn von ihr weg, Eingabe setzt einen Punkt, Escape geht einen Schritt zurück.',
    untitled: 'Ohne Namen',
    sketchName: 'Name der Skizze',
    menu: 'Menü',
    tools: 'Werkzeuge',
    panel: 'Ergebnis und Einstellungen',
    showPanel: 'Ergebnis und Einstellungen zeigen',
    hidePanel: 'Ergebnis und Einstellungen verbergen',
    close: 'Schließen',
    loading: 'Lädt …',
    noWebgl:
      'Dieser Browser kann nicht räumlich zeichnen (WebGL fehlt oder ist aus). Skizze und Ergebnis funktionieren trotzdem.',
  },
  rooms: {
    back: 'Zurück zur Zeichnung',
    solving: 'Das Modell wird gerade berechnet; gleich ist es hier.',
    failed:
      'Diese Seite ließ sich nicht laden. Prüfen Sie die Verbindung und versuchen Sie es noch einmal.',
  },
  counts: {
    line: ['Linie', 'Linien'],
    brick: ['Teil', 'Teile'],
  },
  groups: {
    file: 'Datei',
    edit: 'Bearbeiten',
    draw: 'Zeichnen',
    annotate: 'Auszeichnen',
    solve: 'Rechnen',
    view: 'Ansicht',
    help: 'Hilfe',
  },
};
