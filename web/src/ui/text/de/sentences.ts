import type { Sentences } from '../sentences.ts';
import { BUILT_DE } from './sentences-built.ts';
import { CHECKED_DE } from './sentences-checked.ts';
import { KEEP_DE, KEEP_PHRASES_DE } from './sentences-keep.ts';
import { READ_DE } from './sentences-read.ts';
import { SHAFTS_DE, SHAFTS_PHRASES_DE } from './sentences-shafts.ts';

const FILES: Sentences = [
  [
    'the list has more than {n} rows, which is the limit',
    'die Liste hat mehr als {n} Zeilen; das ist die Grenze',
  ],
  [
    'no row has a part number and a count, such as "32524,8"',
    'keine Zeile hat eine Teilenummer und eine Anzahl wie "32524,8"',
  ],
  [
    'the file holds no parts (lines that begin with "1")',
    'die Datei enthält keine Teile (Zeilen, die mit "1" beginnen)',
  ],
  ['more than {n} submodels, which is the limit', 'mehr als {n} Untermodelle; das ist die Grenze'],
  [
    'line {n}: a part needs a colour, twelve numbers and a file name',
    'Zeile {n}: Ein Teil braucht eine Farbe, zwölf Zahlen und einen Dateinamen',
  ],
  [
    '{file}: submodels are nested more than {n} deep',
    '{file}: Untermodelle liegen mehr als {n}-fach ineinander',
  ],
  [
    'submodels and parts are more than {n}, which is the limit',
    'Untermodelle und Teile sind mehr als {n}; das ist die Grenze',
  ],
  ['{file}: the submodel holds itself', '{file}: Das Untermodell enthält sich selbst'],
  [
    '{file} stands there more than once; the first counts',
    '{file} steht mehr als einmal da; das erste zählt',
  ],
  [
    'parts that are not known here are not judged: {parts}',
    'Teile, die hier unbekannt sind, werden nicht beurteilt: {parts}',
  ],
  ['the archive holds no model (.ldr or .mpd)', 'das Archiv enthält kein Modell (.ldr oder .mpd)'],
  [
    'the archive is closed with a password that is not known here',
    'das Archiv ist mit einem Passwort verschlossen, das hier nicht bekannt ist',
  ],
  [
    'the model in the archive is larger than 32 MB, which is the limit',
    'das Modell im Archiv ist größer als 32 MB; das ist die Grenze',
  ],
  ['the archive is damaged', 'das Archiv ist beschädigt'],
  [
    'what stands in another file is left out: {file}',
    'was in einer anderen Datei steht, fehlt: {file}',
  ],
  ['line {n}: a decimal comma; write {number}', 'Zeile {n}: ein Dezimalkomma; {number} schreiben'],
  ['line {n}: "v" should have three numbers', 'Zeile {n}: "v" braucht drei Zahlen'],
  [
    'a vertex lies more than {n} modules from the origin',
    'eine Ecke liegt mehr als {n} Module vom Ursprung entfernt',
  ],
  [
    'its numbers were taken for {unit}; a module is 8 mm',
    'ihre Zahlen wurden als {unit} verstanden; ein Modul ist 8 mm',
  ],
  ['it was turned so that its Y is up', 'sie wurde so gedreht, dass ihr Y oben ist'],
  [
    'more than {n} rows with all submodels in place, which is the limit',
    'mehr als {n} Zeilen mit allen Untermodellen am Platz; das ist die Grenze',
  ],
  ['more than {n} parts, which is the limit', 'mehr als {n} Teile; das ist die Grenze'],
  ['more than {n} lines, which is the limit', 'mehr als {n} Linien; das ist die Grenze'],
  [
    'the file holds no line segments (records that begin with "l")',
    'die Datei enthält keine Strecken (Einträge, die mit "l" beginnen)',
  ],
  [
    'the file has {n} rows, at most {most} are allowed',
    'die Datei hat {n} Zeilen, höchstens {most} sind erlaubt',
  ],
  [
    '{place}: a surface; only line segments (v and l) can be read',
    '{place}: eine Fläche; nur Strecken (v und l) können gelesen werden',
  ],
  [
    '{place}: "l" should name at least two vertices',
    '{place}: "l" muss mindestens zwei Ecken nennen',
  ],
  ['{place}: there is no vertex {n}', '{place}: Es gibt keine Ecke {n}'],
];

const LINKS: Sentences = [
  [
    'A link holds at most {n} lines. Send the sketch file instead.',
    'Ein Link fasst höchstens {n} Linien. Bitte stattdessen die Skizzendatei senden.',
  ],
  [
    'This sketch is too large for a link. Send the sketch file instead.',
    'Diese Skizze ist für einen Link zu groß. Bitte stattdessen die Skizzendatei senden.',
  ],
  [
    'This link was made by a newer version of this page. Reload the page and try again.',
    'Diesen Link hat eine neuere Fassung dieser Seite gemacht. Bitte die Seite neu laden und es noch einmal versuchen.',
  ],
  [
    'This link is damaged: a part of it is missing or changed.',
    'Dieser Link ist beschädigt: Ein Stück fehlt oder wurde verändert.',
  ],
];

const INSIDE: Sentences = [
  ['the building sequence is unreadable', 'die Baufolge ist nicht lesbar'],
  ['the solver stopped unexpectedly', 'die Suche ist unerwartet stehen geblieben'],
  ['the solver could not be loaded', 'die Suche konnte nicht geladen werden'],
  [
    'should be a list of shafts with at and parts',
    'muss eine Liste von Wellen mit at und parts sein',
  ],
  ['a shaft meshes with no other', 'eine Welle greift in keine andere'],
  ['the train is locked', 'das Getriebe klemmt'],
];

/** Phrases that stand inside sentences. */
export const PHRASES_DE: Sentences = [
  ['millimetres', 'Millimeter'],
  ['centimetres', 'Zentimeter'],
  ['metres', 'Meter'],
  ['inches', 'Zoll'],
  ['LDraw units', 'LDraw-Einheiten'],
  ['an object', 'ein Objekt'],
  ['an array', 'eine Liste'],
  ['an array of {n}', 'eine Liste von {n}'],
  ['the text {text}', 'der Text {text}'],
  ['the number {n}', 'die Zahl {n}'],
  ['something else', 'etwas anderes'],
  ['lines', 'Linien'],
  ['1 module ({mm} mm)', '1 Modul ({mm} mm)'],
  ['{n} modules ({mm} mm)', '{n} Module ({mm} mm)'],
  ['{a} by {b} (length {n})', '{a} mal {b} (Länge {n})'],
  ['{n} numbers', '{n} Zahlen'],
  ['line numbers', 'Liniennummern'],
  ['an LDraw code from {low} to {high}', 'eine LDraw-Nummer von {low} bis {high}'],
  ['numbers from {low} to {high}', 'Nummern von {low} bis {high}'],
  ['one of {list}', 'eins von {list}'],
  ['part {n} ({name})', 'Teil {n} ({name})'],
  ['row {n}', 'Zeile {n}'],
  ['line {n}', 'Zeile {n}'],
  ['{list} and {n} more', '{list} und {n} weitere'],
  ['{a} and {b}', '{a} und {b}'],
  ['{a} or {b}', '{a} oder {b}'],
  ['three numbers [x, y, z]', 'drei Zahlen [x, y, z]'],
  ['three numbers', 'drei Zahlen'],
  ['groups of line numbers', 'Gruppen von Liniennummern'],
  ['two angles in degrees', 'zwei Winkel in Grad'],
  ['points', 'Punkte'],
  ['an array of points', 'eine Liste von Punkten'],
  ['pairs of line numbers', 'Paare von Liniennummern'],
  ['pairs of line numbers, such as [[0, 1]]', 'Paare von Liniennummern, etwa [[0, 1]]'],
  ['a direction [x, y, z]', 'eine Richtung [x, y, z]'],
  ['a shift [x, y, z]', 'eine Verschiebung [x, y, z]'],
  ['a number of modules', 'eine Zahl von Modulen'],
  ['an array of lines', 'eine Liste von Linien'],
  ['objects', 'Objekten'],
  ['layers', 'Lagen'],
  ['nodes', 'Knoten'],
  ...KEEP_PHRASES_DE,
  ...SHAFTS_PHRASES_DE,
];

/**
 * What the core and the readers of files say, in German. Where two forms fit, the first is taken: the longer
 * one stands above.
 */
export const SENTENCES_DE: Sentences = [
  ...KEEP_DE,
  ...SHAFTS_DE,
  ...READ_DE,
  ...CHECKED_DE,
  ...BUILT_DE,
  ...FILES,
  ...LINKS,
  ...INSIDE,
];
