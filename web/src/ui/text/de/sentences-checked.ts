import type { Sentences } from '../sentences.ts';

// What the checks of a model say.

const CHECKS: Sentences = [
  [
    'Every part is a real one, neither mirrored nor bent',
    'Jedes Teil gibt es, und es ist weder gespiegelt noch verzerrt',
  ],
  [
    'No two parts share space, none lies in a forbidden place',
    'Keine zwei Teile teilen sich Raum, keins liegt an einem verbotenen Ort',
  ],
  [
    'Every head fits its hole, every part is held',
    'Jeder Kopf passt in sein Loch, jedes Teil wird gehalten',
  ],
  ['All parts hang together', 'Alle Teile hängen zusammen'],
  [
    'Every line of the sketch is there from end to end',
    'Jede Linie der Skizze ist von Ende zu Ende da',
  ],
  [
    'It can be taken apart, so it can be put together',
    'Es lässt sich zerlegen, also auch zusammenbauen',
  ],
  ['Every joint turns', 'Jedes Gelenk dreht sich'],
  ['{n} parts', '{n} Teile'],
  ['{n} heads in holes', '{n} Köpfe in Löchern'],
  ['pieces drawn: {n}, pieces built: {m}', 'gezeichnete Stücke: {n}, gebaute Stücke: {m}'],
  [
    'modules of line: {n}, bridged by connectors: {m}',
    'Module der Linien: {n}, davon überbrückt: {m}',
  ],
  [
    '{n} collisions, {m} parts in forbidden places',
    '{n} Kollisionen, {m} Teile an verbotenen Orten',
  ],
  [
    'moves: {n}, groups built apart: {m}, parts stuck: {k}',
    'Züge: {n}, einzeln gebaute Gruppen: {m}, festsitzende Teile: {k}',
  ],
  ['{n} of {m} joints turn', '{n} von {m} Gelenken drehen sich'],
  [
    '{n} of {m} joints turn, by at least {a} degrees',
    '{n} von {m} Gelenken drehen sich, um mindestens {a} Grad',
  ],
  ['no sketch in the file: nothing to cover', 'keine Skizze in der Datei: nichts zu bedecken'],
  ['not judged: more than {n} parts', 'nicht beurteilt: mehr als {n} Teile'],
  ['too many parts to be taken apart here', 'zu viele Teile, um sie hier zu zerlegen'],
];

const PROBLEMS: Sentences = [
  ['the model has no parts', 'das Modell hat keine Teile'],
  ['{part} is not a part of the catalogue', '{part} ist kein Teil des Katalogs'],
  [
    '{part} is mirrored, scaled or skewed: no real part is',
    '{part} ist gespiegelt, vergrößert oder verzerrt: Kein echtes Teil ist das',
  ],
  ['a round pin does not go into an axle hole', 'ein runder Pin geht nicht in ein Achsloch'],
  [
    'the cross of the axle is turned against the hole',
    'das Kreuz der Achse ist gegen das Loch verdreht',
  ],
  ['the head lies between the slots of the hole', 'der Kopf liegt zwischen den Plätzen des Lochs'],
  ['{male} in {female} at ({at}): {why}', '{male} in {female} bei ({at}): {why}'],
  [
    '{n} heads are in one hole of {part} at ({at})',
    '{n} Köpfe stecken in einem Loch von {part} bei ({at})',
  ],
  [
    '{part} is held by nothing but axles in round holes: it can slide off',
    '{part} wird nur von Achsen in runden Löchern gehalten: Es kann abrutschen',
  ],
  ['{part} is connected to nothing', '{part} ist mit nichts verbunden'],
  [
    '{a} and {b} take the same space near ({at})',
    '{a} und {b} nehmen denselben Raum ein, bei ({at})',
  ],
  [
    '{part} enters the keep-out box from {at} to {end}',
    '{part} ragt in den Sperrraum von {at} bis {end}',
  ],
  ['{part} lies below the ground', '{part} liegt unter dem Boden'],
  ["the model's sketch cannot be read: {why}", 'die Skizze des Modells ist nicht lesbar: {why}'],
  [
    'lines[{n}] is neither covered nor bridged from ({from}) to ({to})',
    'lines[{n}] ist von ({from}) bis ({to}) weder bedeckt noch überbrückt',
  ],
  [
    '{n} parts beside {part} at ({at}) are not connected to the rest',
    '{n} Teile bei {part}, ({at}), sind mit dem Rest nicht verbunden',
  ],
  [
    'connected part {n} of the sketch is no assembly of its own',
    'das zusammenhängende Stück {n} der Skizze ist keine eigene Baugruppe',
  ],
  [
    '{part} cannot leave the {n} parts that are locked together: at the least, {other} and {m} more parts are in its way',
    '{part} kommt aus den {n} ineinander verriegelten Teilen nicht heraus: Mindestens {other} und {m} weitere Teile sind im Weg',
  ],
  [
    '{part} cannot leave the {n} parts that are locked together: at the least, {other} is in its way',
    '{part} kommt aus den {n} ineinander verriegelten Teilen nicht heraus: Mindestens {other} ist im Weg',
  ],
  [
    'the lines that meet here could not all be joined',
    'die Linien, die sich hier treffen, ließen sich nicht alle verbinden',
  ],
  [
    'no parts were found that join the lines which meet at {at}, even with nothing else around: {lines}; without {some} the others can be joined',
    'es fanden sich keine Teile, die die Linien verbinden, die sich bei {at} treffen, auch wenn nichts sonst da ist: {lines}; ohne {some} lassen sich die anderen verbinden',
  ],
  [
    'no parts were found that join the lines which have nodes within {n} modules of {at}, even with nothing else around: {lines}; without {some} the others can be joined',
    'es fanden sich keine Teile, die die Linien verbinden, die Knoten innerhalb von {n} Modulen um {at} haben, auch wenn nichts sonst da ist: {lines}; ohne {some} lassen sich die anderen verbinden',
  ],
  [
    'no beams in use make up the {n} modules of the line from here: on an exact line they may neither overlap nor stick out',
    'keine Balken im Satz ergeben die {n} Module der Linie von hier: Auf einer genauen Linie dürfen sie weder überlappen noch überstehen',
  ],
  [
    'no beams in use make up the {n} modules of the line from here',
    'keine Balken im Satz ergeben die {n} Module der Linie von hier',
  ],
  [
    'the beams stacked here leave an empty layer',
    'die hier gestapelten Balken lassen eine Lage leer',
  ],
  [
    'more beams are stacked here than a pin can hold',
    'hier liegen mehr Balken aufeinander, als ein Pin halten kann',
  ],
  [
    'the model needs {n} of part {part}, of which you own {m}: {k} missing',
    'das Modell braucht {n}-mal Teil {part}, vorhanden sind {m}: {k} fehlen',
  ],
];

const MOTION: Sentences = [
  [
    '{range} It must turn from {from} to {to} degrees.',
    '{range} Es muss sich von {from} bis {to} Grad drehen.',
  ],
  ['Turns all the way round.', 'Dreht sich ganz herum.'],
  ['Turns from {from} to {to}.', 'Dreht sich von {from} bis {to}.'],
  ['{range} Pins with friction turn with it.', '{range} Pins mit Reibung drehen sich mit.'],
  [
    'An axle shifts in a pin hole: nothing turns.',
    'Eine Achse verschiebt sich in einem Pinloch: Nichts dreht sich.',
  ],
  [
    'Does not turn: the rest of the model holds it.',
    'Dreht sich nicht: Der Rest des Modells hält es fest.',
  ],
  [
    'Does not turn: it is stopped at once, at {from} and at {to}.',
    'Dreht sich nicht: Es stößt sofort an, bei {from} und bei {to}.',
  ],
  ['Does not turn: {why}.', 'Dreht sich nicht: {why}.'],
  ['bodies {a} and {b}: {what}', 'Körper {a} und {b}: {what}'],
  [
    'no beam covers the lines on one of its sides',
    'auf einer seiner Seiten bedeckt kein Balken die Linien',
  ],
  [
    '{a} and {b} on its sides are held together as one rigid body',
    '{a} und {b} auf seinen Seiten sind zu einem starren Körper verbunden',
  ],
  [
    '{a} and {b} on its sides are not connected',
    '{a} und {b} auf seinen Seiten hängen nicht zusammen',
  ],
  [
    '{a} and {b} on its sides move against each other, but not about its axis',
    '{a} und {b} auf seinen Seiten bewegen sich gegeneinander, aber nicht um seine Achse',
  ],
  [
    'the rest of the model holds its sides against each other',
    'der Rest des Modells hält seine Seiten gegeneinander fest',
  ],
  ['{angle} degrees ({a} meets {b})', '{angle} Grad ({a} trifft auf {b})'],
  ['{angle} degrees (dead point)', '{angle} Grad (Totpunkt)'],
  ['{angle} degrees', '{angle} Grad'],
  [
    'the model has no motion with the number {n}',
    'das Modell hat keine Bewegung mit der Nummer {n}',
  ],
  [
    'A line of {n} modules from ({from}) to ({to}) stops one of the free motions.',
    'Eine Linie von {n} Modulen von ({from}) bis ({to}) hält eine der freien Bewegungen auf.',
  ],
];

const STRESS: Sentences = [
  ['no part within {n} modules of ({at})', 'kein Teil näher als {n} Module bei ({at})'],
  ['expected "held", "free" or "locked"', 'erwartet wird "held", "free" oder "locked"'],
  [
    'These parts can move without resistance: {parts}; {advice}',
    'Diese Teile können sich ohne Widerstand bewegen: {parts}; {advice}',
  ],
  [
    'The model tips over or slides away: {parts}; {advice}',
    'Das Modell kippt um oder rutscht weg: {parts}; {advice}',
  ],
  [
    'brace it, or reckon with pins that friction holds',
    'bitte verstreben, oder mit Pins rechnen, die die Reibung hält',
  ],
  [
    'brace it, or reckon with all fits locked, pins without friction too',
    'bitte verstreben, oder alle Sitze fest rechnen, auch Pins ohne Reibung',
  ],
  ['something is not connected', 'etwas ist nicht verbunden'],
  ['{a}. Besides: {b}', '{a}. Außerdem: {b}'],
  [
    'It does not stand as drawn: it leans over by {n} degrees and rests so',
    'Es steht nicht wie gezeichnet: Es neigt sich um {n} Grad und ruht so',
  ],
  [
    'it moves by more than a tenth of its length, too far for these numbers to hold',
    'es bewegt sich um mehr als ein Zehntel seiner Länge, zu weit für diese Zahlen',
  ],
  [
    'friction alone holds {n} of its freedoms, and how stiff that is, is an assumption',
    'Reibung allein hält {n} seiner Freiheiten, und wie steif sie ist, ist eine Annahme',
  ],
  ['the model has no parts: nothing carries', 'das Modell hat keine Teile: Nichts trägt'],
  [
    'expected three numbers of at most {n} in magnitude',
    'erwartet werden drei Zahlen vom Betrag höchstens {n}',
  ],
  ['expected three numbers', 'erwartet werden drei Zahlen'],
  ['expected an array of at most {n} loads', 'erwartet wird eine Liste von höchstens {n} Lasten'],
  ['expected a number above 0, at most {n}', 'erwartet wird eine Zahl über 0, höchstens {n}'],
];

/** What reading a sketch changed, and what a person would want to know of it (core/sketch/sketch_notes). */
const NOTES: Sentences = [
  [
    '{end} was moved by {n}, from {a} to {b}, so that lines have whole lengths; {k} of {m} line ends were moved',
    '{end} wurde um {n} verschoben, von {a} nach {b}, damit Linien ganze Längen haben; {k} von {m} Linienenden wurden verschoben',
  ],
  [
    '{line} is {n} modules long as drawn; its length of {l} does not close with the lines that it touches, and {off} are left to the play of the pins; nearest that close: {near}',
    '{line} ist gezeichnet {n} Module lang; die Länge {l} schließt nicht mit den Linien, die sie berührt, und {off} bleiben dem Spiel der Pins; am nächsten schließen: {near}',
  ],
  [
    '{line} is {n} modules long as drawn; its length of {l} does not close with the lines that it touches, and {off} are left to the play of the pins',
    '{line} ist gezeichnet {n} Module lang; die Länge {l} schließt nicht mit den Linien, die sie berührt, und {off} bleiben dem Spiel der Pins',
  ],
  [
    '{a} and {b} come within {n} of each other at {at} and do not touch, so nothing joins them there; moving {c} by {shift} would',
    '{a} und {b} kommen sich bei {at} auf {n} nahe und berühren sich nicht, also verbindet sie dort nichts; {c} um {shift} zu verschieben, würde es',
  ],
  [
    '{a} and {b} cross at {at} between their nodes, where no pin can join them; moving {c} by {shift} would put nodes of both there',
    '{a} und {b} kreuzen sich bei {at} zwischen ihren Knoten, wo kein Pin sie verbinden kann; {c} um {shift} zu verschieben, brächte Knoten von beiden dorthin',
  ],
  [
    '{a} and {b} cross at {at} between their nodes, where no pin can join them',
    '{a} und {b} kreuzen sich bei {at} zwischen ihren Knoten, wo kein Pin sie verbinden kann',
  ],
  [
    'the sketch is {n} pieces that nothing joins; each is built on its own',
    'die Skizze besteht aus {n} Stücken, die nichts verbindet; jedes wird für sich gebaut',
  ],
  [
    'the piece of {a} is {n} from the piece of {b}, from node {p} to node {q}; a line between them, {l} long, would join them',
    'das Stück von {a} ist {n} vom Stück von {b} entfernt, von Knoten {p} bis Knoten {q}; eine Linie dazwischen, {l} lang, würde sie verbinden',
  ],
  [
    'the piece of {a} is {n} from the piece of {b}, from node {p} to node {q}; moving the one by {shift} would join them',
    'das Stück von {a} ist {n} vom Stück von {b} entfernt, von Knoten {p} bis Knoten {q}; das eine um {shift} zu verschieben, würde sie verbinden',
  ],
];

export const CHECKED_DE: Sentences = [...CHECKS, ...MOTION, ...STRESS, ...PROBLEMS, ...NOTES];
