import type { CONTEST_EN } from '../en/contest.ts';
import type { Words } from '../language.ts';

export const CONTEST_DE: Words<typeof CONTEST_EN> = {
  intro:
    'Die Klasse gibt Links ab. Fügen Sie sie hier ein, einen in jede Zeile: Name, Link und das Ergebnis, das dabei stehen soll. Jedes Modell wird auf diesem Rechner noch einmal erzeugt und gewertet; nichts verlässt ihn.',
  kind: 'Was zählt',
  kinds: { beams: 'Die wenigsten Balken', bridge: 'Die günstigste Brücke' },
  beamsText:
    'Für die Zeichnung auf dieser Seite: Wer bedeckt sie mit den wenigsten Balken? Es zählt nur, was sich bauen lässt.',
  beamsNeeds:
    'Zeichnen Sie zuerst die Aufgabe: Abgaben werden mit der Zeichnung auf dieser Seite verglichen.',
  prove: 'Wie wenige können es sein?',
  proving: 'Wird bewiesen…',
  proved: 'Mit weniger als {n} Balken kann es niemand.',
  bridgeText:
    'Ein Lastwagen von {weight} N rollt über die Fahrbahn. Es zählt, was überall hält; ein Gramm kostet {price}.',
  deckFrom: 'Die Fahrbahn beginnt bei',
  deckTo: 'und endet bei',
  coordinate: '{axis} ihres {end}s',
  begin: 'Anfang',
  end: 'Ende',
  front: 'Vorderachse, N',
  rear: 'Hinterachse, N',
  safety: 'Sicherheit',
  badDeck: 'Diese Regeln gehen nicht: {message}',
  entries: 'Abgaben',
  example: 'Anna  https://…#s2.…  24',
  judge: 'Alle werten',
  stop: 'Anhalten',
  ready: 'Abgaben: {n}',
  judging: 'Bisher gewertet: {n} von {all}',
  over: 'Gewertet: {n}',
  stopped: 'Angehalten nach {n} von {all}',
  ranking: 'Rangliste',
  place: 'Platz',
  name: 'Name',
  score: 'Ergebnis',
  claimed: 'Angabe',
  note: 'Anmerkung',
  open: 'Das Modell von {name} öffnen',
  wrong: 'Gibt {claimed} an, hat {score}',
  wrongNone: 'Gibt {claimed} an, hat kein Ergebnis',
  faults: {
    broken: 'Der Link ist beschädigt',
    otherDrawing: 'Eine andere Zeichnung',
    refused: 'Lässt sich nicht erzeugen: {detail}',
    notBuildable: 'Nicht baubar',
    folds: 'Faltet sich mit dem Lastwagen bei {detail}',
    tooWeak: 'Bricht mit dem Lastwagen bei {detail}',
    failed: 'Ließ sich nicht werten: {detail}',
  },
  saveCsv: 'Als CSV speichern',
};
