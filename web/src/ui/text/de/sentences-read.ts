import type { Sentences } from '../sentences.ts';

// What the core says against a sketch, settings or a model that it cannot read.

const JSON_TEXT: Sentences = [
  [
    'line {line}, column {column}: not valid JSON: the text ends too early',
    'Zeile {line}, Spalte {column}: kein gültiges JSON: Der Text endet zu früh',
  ],
  [
    'line {line}, column {column}: not valid JSON: {word} is not a JSON number; coordinates must be finite numbers',
    'Zeile {line}, Spalte {column}: kein gültiges JSON: {word} ist keine Zahl in JSON; Koordinaten müssen endliche Zahlen sein',
  ],
  [
    'line {line}, column {column}: not valid JSON: {why}, near {word}',
    'Zeile {line}, Spalte {column}: kein gültiges JSON: {why}, bei {word}',
  ],
  ['unexpected text', 'unerwarteter Text'],
  ['unexpected {found}; expected {wanted}', 'unerwartet: {found}; erwartet: {wanted}'],
  ['unexpected {found}', 'unerwartet: {found}'],
  ['the number {n} is not finite', 'die Zahl {n} ist nicht endlich'],
  [
    "the number {n} is not finite: it is too large for a computer's numbers",
    'die Zahl {n} ist nicht endlich: Sie ist zu groß für die Zahlen eines Rechners',
  ],
  [
    'the key {key} stands twice in this object',
    'der Schlüssel {key} steht zweimal in diesem Objekt',
  ],
  ['binary values are not JSON', 'Binärwerte sind kein JSON'],
  ['the file holds more than {n} values', 'die Datei enthält mehr als {n} Werte'],
  [
    'more than {n} elements; at most {most} are read',
    'mehr als {n} Einträge; höchstens {most} werden gelesen',
  ],
  ['{n} elements; at most {most} are read', '{n} Einträge; höchstens {most} werden gelesen'],
  [
    'arrays and objects lie more than {n} deep inside each other',
    'Listen und Objekte liegen mehr als {n}-fach ineinander',
  ],
  ['this is not JSON: {why}', 'das ist kein JSON: {why}'],
  ['not valid JSON', 'kein gültiges JSON'],
];

const SKETCH: Sentences = [
  [
    'not a sketch: expected an object with format, version and lines',
    'keine Skizze: erwartet wird ein Objekt mit format, version und lines',
  ],
  [
    '{found} is not known; expected one of {wanted}',
    '{found} ist nicht bekannt; erwartet wird eins von {wanted}',
  ],
  ['{found} is not known; expected {wanted}', '{found} ist nicht bekannt; erwartet wird {wanted}'],
  [
    'expected two angles in degrees, such as [-180, 180]',
    'erwartet werden zwei Winkel in Grad, etwa [-180, 180]',
  ],
  [
    'expected an angle of at most 0 and one of at least 0',
    'erwartet werden ein Winkel von höchstens 0 und einer von mindestens 0',
  ],
  ['not a path; expected {wanted}', 'keine Bahn; erwartet wird {wanted}'],
  ['not known; expected {wanted}', 'nicht bekannt; erwartet wird {wanted}'],
  ['the path is shorter than 1 module', 'die Bahn ist kürzer als 1 Modul'],
  [
    'the path lies in no plane parallel to XY, YZ or ZX; make all points equal in x, y or z',
    'die Bahn liegt in keiner Ebene parallel zu XY, YZ oder ZX; alle Punkte müssen in x, y oder z gleich sein',
  ],
  ['{n} points; expected 2 to {most}', '{n} Punkte; erwartet werden 2 bis {most}'],
  ['{found} is no colour; expected {wanted}', '{found} ist keine Farbe; erwartet wird {wanted}'],
  ['{found} is no line; expected {wanted}', '{found} ist keine Linie; erwartet werden {wanted}'],
  ['longer than {n} bytes', 'länger als {n} Byte'],
  [
    'holds a line break or another control character',
    'enthält einen Zeilenumbruch oder ein anderes Steuerzeichen',
  ],
  ['empty; a sketch has at least one line', 'leer; eine Skizze hat mindestens eine Linie'],
  [
    'together {n} modules long; at most {most} are read',
    'zusammen {n} Module lang; höchstens {most} werden gelesen',
  ],
  [
    'cannot have length {n} together with the lines that it touches; it stays {off} off; nearest that close: {near}',
    'kann zusammen mit den Linien, die sie berührt, nicht {n} lang sein; es bleiben {off} Abstand; am nächsten schließen: {near}',
  ],
  [
    'cannot have length {n} together with the lines that it touches; it stays {off} off',
    'kann zusammen mit den Linien, die sie berührt, nicht {n} lang sein; es bleiben {off} Abstand',
  ],
  [
    'the file has {n} bytes; at most {most} are read',
    'die Datei hat {n} Byte; höchstens {most} werden gelesen',
  ],
  [
    'the file is empty; expected a sketch in JSON',
    'die Datei ist leer; erwartet wird eine Skizze in JSON',
  ],
  ['the file is empty', 'die Datei ist leer'],
  [
    'the file is larger than 8 MB, which is the limit',
    'die Datei ist größer als 8 MB; das ist die Grenze',
  ],
  [
    'from and to are the same point; a line is at least 1 module long',
    'from und to sind derselbe Punkt; eine Linie ist mindestens 1 Modul lang',
  ],
  [
    'the ends are the same point; a line is at least 1 module long',
    'beide Enden sind derselbe Punkt; eine Linie ist mindestens 1 Modul lang',
  ],
  [
    'length {n} is not a whole number of modules; nearest: {near}; with the whole drawing twice as large it would be {twice}',
    'die Länge {n} ist keine ganze Zahl von Modulen; am nächsten: {near}; doppelt so groß gezeichnet wäre sie {twice}',
  ],
  [
    'length {n} is not a whole number of modules; nearest: {near}',
    'die Länge {n} ist keine ganze Zahl von Modulen; am nächsten: {near}',
  ],
  [
    'runs {x} along x, {y} along y and {z} along z; a line must lie in a plane parallel to XY, YZ or ZX, so one of the three must be 0',
    'verläuft {x} entlang x, {y} entlang y und {z} entlang z; eine Linie muss in einer Ebene parallel zu XY, YZ oder ZX liegen, also muss eines davon 0 sein',
  ],
  [
    'the line lies in no plane parallel to XY, YZ or ZX; make its ends equal in x, y or z',
    'die Linie liegt in keiner Ebene parallel zu XY, YZ oder ZX; ihre Enden müssen in x, y oder z gleich sein',
  ],
  [
    '{axis} is not perpendicular to the line, which runs along {along}; expected {wanted}',
    '{axis} steht nicht senkrecht auf der Linie, die entlang {along} verläuft; erwartet wird {wanted}',
  ],
  [
    '{axis}, but line {n} overlaps it and says {other}; expected the same',
    '{axis}, aber Linie {n} liegt auf ihr und sagt {other}; erwartet wird dasselbe',
  ],
  [
    'lines cannot turn about two axes at {point}, this one and that of {other}, since no part has pin holes for both at one place; expected joints at two nodes',
    'Linien können sich bei {point} nicht um zwei Achsen drehen, diese und die von {other}, denn kein Teil hat dort Pinlöcher für beide; erwartet werden Gelenke an zwei Knoten',
  ],
  [
    'the lines are {n} modules long; what may be laid is listed for at most {most}',
    'die Linien sind {n} Module lang; was gelegt werden kann, wird für höchstens {most} aufgelistet',
  ],
  [
    '{axis} is not along x, y or z, and holes are; expected one of these',
    '{axis} verläuft nicht entlang x, y oder z wie die Löcher; erwartet wird eines davon',
  ],
  [
    'lines {n} and {m} lie on each other, so they cannot turn against each other',
    'die Linien {n} und {m} liegen aufeinander, können sich also nicht gegeneinander drehen',
  ],
  [
    'line {n} turns about itself, so it must be an axle, but {why}',
    'Linie {n} dreht sich um sich selbst und muss also eine Achse sein, aber {why}',
  ],
  [
    'it is {n} long and the longest axle reaches {m}',
    'sie ist {n} lang, und die längste Achse reicht {m} weit',
  ],
  [
    'it is {n} long, too short for one that stays in its holes',
    'sie ist {n} lang, zu kurz für eine, die in ihren Löchern bleibt',
  ],
  [
    'line {n}, which meets it at {point}, cannot have its holes along it',
    'Linie {n}, die sie bei {point} trifft, kann ihre Löcher nicht längs zu ihr haben',
  ],
  [
    'line {n}, which meets it at {point}, cannot have its holes along it because of {joint}',
    'Linie {n}, die sie bei {point} trifft, kann ihre Löcher wegen {joint} nicht längs zu ihr haben',
  ],
  ['line {n} has no node at {point}', 'Linie {n} hat keinen Knoten bei {point}'],
  [
    'line {n} stands in two groups; a line moves with one of them',
    'Linie {n} steht in zwei Gruppen; eine Linie bewegt sich mit einer davon',
  ],
  [
    "{point} is no node of any line; expected a point a whole number of modules from a line's end",
    '{point} ist kein Knoten einer Linie; erwartet wird ein Punkt, der eine ganze Zahl von Modulen vom Ende einer Linie entfernt ist',
  ],
  [
    'only line {n} has a node here; a joint needs two lines',
    'nur Linie {n} hat hier einen Knoten; ein Gelenk braucht zwei Linien',
  ],
  [
    'missing; {n} lines meet here ({lines}), so name the groups, such as [[0], [1, 2]]',
    'fehlt; {n} Linien treffen sich hier ({lines}), also sind die Gruppen zu nennen, etwa [[0], [1, 2]]',
  ],
  [
    'expected {few} to {many} groups of line numbers, such as [[0], [1, 2]], found {found}',
    'erwartet werden {few} bis {many} Gruppen von Liniennummern, etwa [[0], [1, 2]], gefunden wurde {found}',
  ],
  [
    'the joints name more than {n} lines together',
    'die Gelenke nennen zusammen mehr als {n} Linien',
  ],
  ['a shift must not be zero', 'eine Verschiebung darf nicht null sein'],
  [
    'expected at least one pair of line numbers',
    'erwartet wird mindestens ein Paar von Liniennummern',
  ],
  [
    'expected two line numbers: a line and its image',
    'erwartet werden zwei Liniennummern: eine Linie und ihr Bild',
  ],
  ['{low} is above {place}, which is {high}', '{low} liegt über {place}, nämlich {high}'],
];

const FIELDS: Sentences = [
  ['missing; expected {wanted}', 'fehlt; erwartet wird {wanted}'],
  [
    'expected an object in braces, found {found}',
    'erwartet wird ein Objekt in Klammern, gefunden wurde {found}',
  ],
  [
    'unknown key {key}, most likely {nearest}; known keys here: {known}',
    'unbekannter Schlüssel {key}, wohl {nearest}; hier bekannt: {known}',
  ],
  [
    'unknown key {key}; known keys here: {known}',
    'unbekannter Schlüssel {key}; hier bekannt: {known}',
  ],
  [
    'expected an array of {wanted}, found {found}',
    'erwartet wird eine Liste: {wanted}; gefunden wurde {found}',
  ],
  ['expected a number, found {found}', 'erwartet wird eine Zahl, gefunden wurde {found}'],
  ['expected a finite number', 'erwartet wird eine endliche Zahl'],
  [
    '{n} is outside the limit of {low} to {high}',
    '{n} liegt außerhalb der Grenzen von {low} bis {high}',
  ],
  [
    'expected three numbers [x, y, z], found {found}',
    'erwartet werden drei Zahlen [x, y, z], gefunden wurde {found}',
  ],
  [
    'a direction must not be zero; expected for example [0, 0, 1]',
    'eine Richtung darf nicht null sein; erwartet wird etwa [0, 0, 1]',
  ],
  [
    'expected true or false, found {found}',
    'erwartet wird true oder false, gefunden wurde {found}',
  ],
  [
    'expected a text in quotes, found {found}',
    'erwartet wird ein Text in Anführungszeichen, gefunden wurde {found}',
  ],
  [
    'expected "x", "y" or "z", found {found}',
    'erwartet wird "x", "y" oder "z", gefunden wurde {found}',
  ],
  [
    'expected the number of a line, found {found}',
    'erwartet wird die Nummer einer Linie, gefunden wurde {found}',
  ],
  [
    'there is no line {n}; lines are numbered 0 to {last}',
    'es gibt keine Linie {n}; Linien haben die Nummern 0 bis {last}',
  ],
  ['expected at least one line number', 'erwartet wird mindestens eine Liniennummer'],
  ['line {n} is named twice', 'Linie {n} ist zweimal genannt'],
  ['should be an object', 'muss ein Objekt sein'],
  ['should be a list', 'muss eine Liste sein'],
  ['{n} entries, at most {most} are allowed', '{n} Einträge, höchstens {most} sind erlaubt'],
  ['should be three numbers', 'müssen drei Zahlen sein'],
  ['should be a number', 'muss eine Zahl sein'],
  ['{n} is beyond the limit of {most} modules', '{n} liegt jenseits der Grenze von {most} Modulen'],
  ['should be a line number from 0 to {last}', 'muss eine Liniennummer von 0 bis {last} sein'],
  ['should be the number of a part, 0 to {last}', 'muss die Nummer eines Teils sein, 0 bis {last}'],
  ['should be two line numbers', 'müssen zwei Liniennummern sein'],
  [
    'should be two or more lists of line numbers',
    'müssen zwei oder mehr Listen von Liniennummern sein',
  ],
  ['should be true or false', 'muss true oder false sein'],
  ['should be "x", "y" or "z"', 'muss "x", "y" oder "z" sein'],
  ['should be "reflection" or "translation"', 'muss "reflection" oder "translation" sein'],
  ['should be "technic-sketch"', 'muss "technic-sketch" sein'],
  ['should be "hinge"', 'muss "hinge" sein'],
  [
    'should be two angles in degrees, such as [-180, 180]',
    'müssen zwei Winkel in Grad sein, etwa [-180, 180]',
  ],
  ['{key} is not known', '{key} ist nicht bekannt'],
  ['should be 1', 'muss 1 sein'],
  ['should be 1 or 2', 'muss 1 oder 2 sein'],
  ['should be one of {list}', 'muss eins von {list} sein'],
  [
    'should be an LDraw code from {low} to {high}',
    'muss eine LDraw-Nummer von {low} bis {high} sein',
  ],
];

const SETTINGS: Sentences = [
  [
    'a number from {low} to {high} is needed, not {value}',
    'nötig ist eine Zahl von {low} bis {high}, nicht {value}',
  ],
  ['0 or 1 is needed, not {value}', 'nötig ist 0 oder 1, nicht {value}'],
  ['a whole number is needed, not {value}', 'nötig ist eine ganze Zahl, nicht {value}'],
  [
    'a whole number from {low} to {high} is needed, not {value}',
    'nötig ist eine ganze Zahl von {low} bis {high}, nicht {value}',
  ],
  [
    'a whole number from {low} to {high} is needed',
    'nötig ist eine ganze Zahl von {low} bis {high}',
  ],
  ['no such key; known are {known}', 'diesen Schlüssel gibt es nicht; bekannt sind {known}'],
  [
    'no such key {key}; known are {known}',
    'den Schlüssel {key} gibt es nicht; bekannt sind {known}',
  ],
  ['no part {part} in the catalogue', 'im Katalog gibt es kein Teil {part}'],
  ['{part} is no pin, axle or connector', '{part} ist weder Pin noch Achse noch Verbinder'],
  [
    '2780 is needed, since joints in line are pinned with it',
    '2780 ist nötig, denn damit werden Balken in einer Linie verstiftet',
  ],
  [
    'at least 1 is needed, since joints in line are pinned with it',
    'mindestens 1 ist nötig, denn damit werden Balken in einer Linie verstiftet',
  ],
  ['{n} is no beam length; use {known}', '{n} ist keine Balkenlänge; möglich sind {known}'],
  [
    '{part} is no bent beam; use some of {known}',
    '{part} ist kein gebogener Balken; möglich sind {known}',
  ],
  ['{part} is no frame; use some of {known}', '{part} ist kein Rahmen; möglich sind {known}'],
  [
    'at least one beam length is needed, such as {example}',
    'nötig ist mindestens eine Balkenlänge, etwa {example}',
  ],
  [
    'no straight beam is left; own at least one kind',
    'es bleibt kein gerader Balken; mindestens eine Art muss vorhanden sein',
  ],
  ['{preset} is none of {known}', '{preset} ist keins von {known}'],
  [
    '{method} is unknown; use default or paper',
    '{method} ist unbekannt; möglich sind default und paper',
  ],
  ['a JSON object is needed, such as {example}', 'nötig ist ein JSON-Objekt, etwa {example}'],
  ['an object of keys and values is needed', 'nötig ist ein Objekt aus Schlüsseln und Werten'],
];

const MODEL: Sentences = [
  [
    'expected an object with format, version and parts',
    'erwartet wird ein Objekt mit format, version und parts',
  ],
  ['expected "liftarm-model"', 'erwartet wird "liftarm-model"'],
  ['expected 1', 'erwartet wird 1'],
  ['expected an array of placed parts', 'erwartet wird eine Liste von Teilen'],
  ['{n} parts; at most {most} are read', '{n} Teile; höchstens {most} werden gelesen'],
  ['expected an array of {n} numbers', 'erwartet wird eine Liste von {n} Zahlen'],
  ['expected a number', 'erwartet wird eine Zahl'],
  ['outside the limit of {low} to {high}', 'außerhalb der Grenzen von {low} bis {high}'],
  ['expected a whole number', 'erwartet wird eine ganze Zahl'],
  ['expected a text of at most {n} bytes', 'erwartet wird ein Text von höchstens {n} Byte'],
  ['expected an object in braces', 'erwartet wird ein Objekt in Klammern'],
  ['an LDraw part number such as "32316"', 'eine LDraw-Teilenummer wie "32316"'],
];

export const READ_DE: Sentences = [...JSON_TEXT, ...SKETCH, ...FIELDS, ...SETTINGS, ...MODEL];
