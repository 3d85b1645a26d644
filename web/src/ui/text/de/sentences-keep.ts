import type { Sentences } from '../sentences.ts';

/** What the core and the readers say of what a sketch keeps (docs/keep.md). */
export const KEEP_DE: Sentences = [
  [
    'the part kept here goes past the end of its line',
    'das Teil, das hier bleiben soll, reicht über seine Linie hinaus',
  ],
  [
    'the holes of the part kept here cannot go along that axis on this line',
    'die Löcher des Teils, das hier bleiben soll, können auf dieser Linie nicht in dieser Achse liegen',
  ],
  [
    'the part kept here does not fit this place',
    'das Teil, das hier bleiben soll, passt nicht an diese Stelle',
  ],
  [
    'the part kept here is on a layer that its line may not have',
    'das Teil, das hier bleiben soll, liegt in einer Lage, die seine Linie nicht haben darf',
  ],
  [
    'another part is kept where this one is',
    'wo dieses Teil bleiben soll, soll schon ein anderes bleiben',
  ],
  [
    'no model was found that keeps part {part} on {line}; without that there is one',
    'mit Teil {part}, das auf {line} bleiben soll, wurde kein Modell gefunden; ohne das gibt es eines',
  ],
  [
    'no model was found without part {part} on {line}; without that there is one',
    'ohne Teil {part} auf {line} wurde kein Modell gefunden; mit ihm gibt es eines',
  ],
  [
    'no model was found with the layers that {line} may have; without that there is one',
    'mit den Lagen, die {line} haben darf, wurde kein Modell gefunden; ohne das gibt es eines',
  ],
  [
    'no model was found whose beams end where {line} is split; without that there is one',
    'es wurde kein Modell gefunden, dessen Balken enden, wo {line} geteilt ist; ohne das gibt es eines',
  ],
  [
    'no model was found with all that is kept; with nothing kept there is one',
    'mit allem, was bleiben soll, wurde kein Modell gefunden; ohne all das gibt es eines',
  ],
  [
    'the model has not all that is kept on this line',
    'das Modell hat nicht alles, was auf dieser Linie bleiben soll',
  ],
  [
    'method {name} knows no parts that are to stay; use the default method',
    'Methode {name} kennt keine Teile, die bleiben sollen; nehmen Sie die übliche',
  ],
  ['line {n} has an element already', 'für Linie {n} gibt es schon ein Element'],
  [
    'says nothing; expected parts, barred, layers or splits',
    'sagt nichts; erwartet werden parts, barred, layers oder splits',
  ],
  ['layer {n} is named twice', 'Lage {n} ist zweimal genannt'],
  ['a layer is named twice', 'eine Lage ist zweimal genannt'],
  [
    'expected an LDraw part number, such as "32524"',
    'erwartet wird eine LDraw-Teilenummer wie "32524"',
  ],
  ['{n} is not a whole number from {a} to {b}', '{n} ist keine ganze Zahl von {a} bis {b}'],
  ['should be a whole number from {a} to {b}', 'soll eine ganze Zahl von {a} bis {b} sein'],
  ['{n} is above to, which is {m}', '{n} liegt über to, das {m} ist'],
  ['should be at most to', 'soll höchstens to sein'],
  ['empty; leave it out', 'leer; lassen Sie es weg'],
  ['should be a list of 1 to {n}', 'soll eine Liste von 1 bis {n} sein'],
  ['should be a list of at most {n}', 'soll eine Liste von höchstens {n} sein'],
  ['should have part, at and colour', 'soll part, at und colour haben'],
];

/** What is expected where a member is missing or of another kind. */
export const KEEP_PHRASES_DE: Sentences = [
  [
    'how many modules off its line the part lies',
    'wie viele Module neben seiner Linie das Teil liegt',
  ],
  ['an LDraw part number', 'eine LDraw-Teilenummer'],
  ['a node of the line', 'ein Knoten der Linie'],
  ['an LDraw code', 'eine LDraw-Farbe'],
  ['the number of a line', 'die Nummer einer Linie'],
];
