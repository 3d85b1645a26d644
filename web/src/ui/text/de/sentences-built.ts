import type { Sentences } from '../sentences.ts';

// How well a model is built.

export const BUILT_DE: Sentences = [
  ['Looks like the drawing', 'Sieht aus wie gezeichnet'],
  ['Stands on its base', 'Steht auf seinem Fuß'],
  ['Nothing moves but the joints', 'Nichts bewegt sich außer den Gelenken'],
  ['No head or arm holds nothing', 'Kein Kopf und kein Arm hält nichts'],
  ['Alike on both sides', 'Auf beiden Seiten gleich'],
  ['Few parts, all of use', 'Wenige Teile, alle von Nutzen'],
  [
    'beams lie {n} layers off their lines on average, nothing sticks out more than {m} modules',
    'Balken liegen im Mittel {n} Lagen neben ihren Linien, nichts steht weiter als {m} Module heraus',
  ],
  [
    'beams lie {n} layers off their lines on average, nothing sticks out more than 1 module',
    'Balken liegen im Mittel {n} Lagen neben ihren Linien, nichts steht weiter als 1 Modul heraus',
  ],
  ['no drawing to compare with', 'keine Zeichnung zum Vergleich'],
  [
    '{n} parts below the base, {m} of {k} feet in the air; it falls over where the drawing stands',
    '{n} Teile unter dem Fuß, {m} von {k} Füßen in der Luft; es kippt, wo die Zeichnung steht',
  ],
  [
    '{n} parts below the base, {m} of {k} feet in the air',
    '{n} Teile unter dem Fuß, {m} von {k} Füßen in der Luft',
  ],
  ['the drawing has no base to stand on', 'die Zeichnung hat nichts, worauf sie stehen könnte'],
  [
    '{n} freedoms beyond the joints, {m} of {k} beams turn about one line',
    '{n} Freiheiten außer den Gelenken, {m} von {k} Balken drehen sich um eine Linie',
  ],
  [
    '{n} of {m} heads sit in nothing, {k} of {l} connector arms hold nothing',
    '{n} von {m} Köpfen stecken in nichts, {k} von {l} Verbinderarmen halten nichts',
  ],
  [
    '{n} of {m} beams have their image on the other side; {k} of {l} symmetries of the drawing are kept',
    '{n} von {m} Balken haben ihr Gegenstück auf der anderen Seite; {k} von {l} Symmetrien der Zeichnung sind gewahrt',
  ],
  ['the drawing is not symmetric', 'die Zeichnung ist nicht symmetrisch'],
  ['{n} parts of {m} kinds, {k} without a use', '{n} Teile von {m} Sorten, {k} ohne Nutzen'],
  [
    'a head of {part} sits in nothing at ({at})',
    'ein Kopf von {part} steckt in nichts, bei ({at})',
  ],
  ['an arm of {part} holds nothing at ({at})', 'ein Arm von {part} hält nichts, bei ({at})'],
  ['{part} turns about one line at ({at})', '{part} dreht sich um eine Linie bei ({at})'],
  [
    '{part} and what hangs on it, {n} parts in all, move where no joint lets them',
    '{part} und was daran hängt, zusammen {n} Teile, bewegen sich, wo kein Gelenk es erlaubt',
  ],
  ['{part} lies {n} layers off its line', '{part} liegt {n} Lagen neben seiner Linie'],
  ['{part} lies below the base', '{part} liegt unter dem Fuß'],
  ['the foot at ({at}) is in the air', 'der Fuß bei ({at}) ist in der Luft'],
  [
    'its centre of mass is not above what it stands on',
    'sein Schwerpunkt liegt nicht über dem, worauf es steht',
  ],
  [
    '{part} has nothing like it on the other side',
    '{part} hat kein Gegenstück auf der anderen Seite',
  ],
  ['{part} at ({at}) joins nothing', '{part} bei ({at}) verbindet nichts'],
];
