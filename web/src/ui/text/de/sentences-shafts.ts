import type { Sentences } from '../sentences.ts';

/** What the core and the readers say of shafts and the gears between them (docs/shafts.md). */
export const SHAFTS_DE: Sentences = [
  [
    'the ends are the same point; a shaft is at least 1 module long',
    'die Enden sind derselbe Punkt; eine Welle ist mindestens 1 Modul lang',
  ],
  ['a shaft is parallel to x, y or z', 'eine Welle liegt parallel zu x, y oder z'],
  [
    '{n} modules long; the longest axle reaches over {m}',
    '{n} Module lang; die längste Achse reicht über {m}',
  ],
  [
    '{n} is not on the lattice; shafts lie on whole modules',
    '{n} liegt nicht im Raster; Wellen liegen auf ganzen Modulen',
  ],
  ['couples a shaft with itself', 'koppelt eine Welle mit sich selbst'],
  [
    'expected the number of a shaft; there are {n}, from 0',
    'erwartet wird die Nummer einer Welle; es gibt {n}, von 0 an',
  ],
  ['{n}; expected 0.001 to 1000', '{n}; erwartet wird 0,001 bis 1000'],
  ['{n}; expected 0 to 50 per cent', '{n}; erwartet wird 0 bis 50 Prozent'],
  ['should be a number from {a} to {b}', 'soll eine Zahl von {a} bis {b} sein'],
  ['runs into {line} at {place}', 'läuft bei {place} in {line}'],
  [
    '{line} and {other} meet at {place}; a shaft needs a hole of one line',
    '{line} und {other} treffen sich bei {place}; eine Welle braucht ein Loch einer einzigen Linie',
  ],
  [
    '{line} can have no hole along it at {place}',
    '{line} kann bei {place} kein Loch in ihrer Richtung haben',
  ],
  [
    'runs in the holes of {n} lines; it needs two at least, each at one of its nodes',
    'läuft in den Löchern von {n} Linien; sie braucht mindestens zwei, jede an einem ihrer Knoten',
  ],
  ['meets {shaft}', 'trifft auf {shaft}'],
  ['{a} and {b} are coupled already', '{a} und {b} sind schon gekoppelt'],
  [
    '{a} and {b} are not side by side; gears couple parallel shafts',
    '{a} und {b} liegen nicht nebeneinander; Zahnräder koppeln parallele Wellen',
  ],
  [
    '{a} and {b} have no room for gears between two bearings of both',
    '{a} und {b} haben zwischen zwei gemeinsamen Lagern keinen Platz für Zahnräder',
  ],
  [
    'no gears couple {a} and {b} with ratio {r} within {t} %; more lines beside them give shafts in between their bearings',
    'keine Zahnräder koppeln {a} und {b} im Verhältnis {r} auf {t} % genau; weitere Linien daneben geben Zwischenwellen ihre Lager',
  ],
  [
    'nothing can keep it from sliding: it needs a free module on either side of one of its lines',
    'nichts kann sie am Verschieben hindern: Sie braucht auf beiden Seiten einer ihrer Linien ein freies Modul',
  ],
  [
    'a shaft between others at {place} cannot be kept from sliding: it needs a free module on either side of its line',
    'eine Zwischenwelle bei {place} ist nicht am Verschieben zu hindern: Sie braucht auf beiden Seiten ihrer Linie ein freies Modul',
  ],
  [
    'Does not turn: its gears ask one shaft for two speeds.',
    'Dreht sich nicht: Die Zahnräder verlangen von einer Welle zwei Drehzahlen.',
  ],
  [
    'Does not turn: two gears are too near to pass each other and do not mesh.',
    'Dreht sich nicht: Zwei Zahnräder sind zu nah, um aneinander vorbeizukommen, und greifen nicht ineinander.',
  ],
  [
    'Does not turn: more than its bearings holds one of its shafts.',
    'Dreht sich nicht: Mehr als ihre Lager hält eine der Wellen.',
  ],
  ['{joints}; {n} of {m} drives turn', '{joints}; {n} von {m} Antrieben drehen sich'],
  [
    'a line is in the way of what turns at its end',
    'eine Linie ist dem im Weg, was sich an ihrem Ende dreht',
  ],
  [
    'no axle is long enough for what turns at its ends',
    'keine Achse ist lang genug für das, was sich an ihren Enden dreht',
  ],
  ['no crank sits at its end', 'an ihrem Ende sitzt keine Kurbel'],
  ['no wheel sits at its end', 'an ihrem Ende sitzt kein Rad'],
  ['expected "crank" or "wheel"', 'erwartet wird "crank" oder "wheel"'],
  ['no axle lies along it', 'in ihr liegt keine Achse'],
  ['its axle runs in fewer than two holes', 'ihre Achse läuft in weniger als zwei Löchern'],
  ['its axle can slide out', 'ihre Achse kann herausrutschen'],
  ['no gears couple its shafts', 'keine Zahnräder koppeln seine Wellen'],
  ['its ratio is {r}, not {s} within {t} %', 'sein Verhältnis ist {r} statt {s} auf {t} % genau'],
  [
    '{a} and {b} bind: other gears ask their shafts for another ratio',
    '{a} und {b} klemmen: Andere Zahnräder verlangen von ihren Wellen ein anderes Verhältnis',
  ],
  [
    '{a} and {b} are too near to pass each other and do not mesh',
    '{a} und {b} sind zu nah, um aneinander vorbeizukommen, und greifen nicht ineinander',
  ],
  ['{part}: its shaft can slide', '{part}: Seine Welle kann sich verschieben'],
  ['{part}: its shaft cannot turn', '{part}: Seine Welle kann sich nicht drehen'],
  [
    '{a} and {b} run into each other when the shafts turn',
    '{a} und {b} stoßen aneinander, wenn sich die Wellen drehen',
  ],
  [
    'method {name} knows no shafts; use the default method',
    'Methode {name} kennt keine Wellen; nehmen Sie die übliche',
  ],
];

/** What is expected where a member is missing or of another kind. */
export const SHAFTS_PHRASES_DE: Sentences = [
  ['the number of a shaft', 'die Nummer einer Welle'],
  [
    'turns of the first shaft for one of the second',
    'Umdrehungen der ersten Welle für eine der zweiten',
  ],
];
