import type { LINKAGES_EN } from '../en/linkages.ts';
import type { Words } from '../language.ts';

export const LINKAGES_DE: Words<typeof LINKAGES_EN> = {
  intro:
    'Zeichnen Sie die Bahn, die ein Punkt nehmen soll: ziehen, oder Punkt für Punkt klicken. Zurück kommen sechs Maschinen aus echten Balken; jede dreht sich mit einer Kurbel.',
  canvas: 'Hier wird die Bahn gezeichnet; ein Kästchen ist ein Modul von 8 mm',
  kind: 'Wofür die Bahn ist',
  kinds: { any: 'Beliebige Bahn', foot: 'Fuß eines Läufers', line: 'Hin und her auf einer Linie' },
  closed: 'Geschlossen',
  plane: 'Ebene',
  planes: { x: 'von rechts gesehen', y: 'von vorn gesehen', z: 'von oben gesehen' },
  shapes: 'Anfangen mit',
  shape: { foot: 'Fuß', line: 'Linie', ellipse: 'Ellipse' },
  clear: 'Leeren',
  making: 'Alle Maschinen werden aufgezählt: {percent} %',
  looking: 'Es wird gesucht …',
  found: '{n} Maschinen, gefunden in {seconds} s. Nehmen Sie eine: Sie wird zu Ihrer Zeichnung.',
  none: 'Keine Maschine aus vier Gliedern zeichnet das. Versuchen Sie es kleiner oder runder.',
  failed: 'Das hat nicht geklappt: {message}',
  take: 'Maschine {n} nehmen: im Mittel {error} mm neben der Bahn',
  error: '{error} mm daneben, höchstens {largest} mm',
  links: 'Kurbel {crank}, Schwinge {rocker}, Koppel {coupler}, Drehpunkte {frame} entfernt',
  transmission: 'schiebt mit {angle}° oder besser',
};
