import type { AxisName, Vec3 } from '../../../geometry/vec.ts';
import type { BridgeContest } from '../../../model/contest/bridge.ts';
import { fillWords } from '../../../tools/tool-words.ts';
import { contestWords as words } from './contest-words.ts';

const AXES: readonly AxisName[] = ['x', 'y', 'z'];

/** Where the deck is, what rolls over it, and how safe it must be. */
export function BridgeRules(props: {
  readonly rules: BridgeContest;
  readonly onChange: (rules: BridgeContest) => void;
}) {
  const { rules, onChange } = props;
  const { deck, truck, safety, pricePerGram } = rules;
  const [front = 0, rear = 0] = truck.forces;
  const load = (forces: readonly number[]) => onChange({ ...rules, truck: { ...truck, forces } });
  return (
    <>
      <p class="quiet">
        {fillWords(words.bridgeText, { weight: front + rear, price: pricePerGram })}
      </p>
      <div class="lab-row">
        <PointFields
          legend={words.deckFrom}
          end={words.begin}
          value={deck.from}
          onChange={(from) => onChange({ ...rules, deck: { ...deck, from } })}
        />
        <PointFields
          legend={words.deckTo}
          end={words.end}
          value={deck.to}
          onChange={(to) => onChange({ ...rules, deck: { ...deck, to } })}
        />
      </div>
      <div class="lab-row">
        <NumberField label={words.front} value={front} onChange={(n) => load([n, rear])} />
        <NumberField label={words.rear} value={rear} onChange={(n) => load([front, n])} />
        <NumberField
          label={words.safety}
          value={safety}
          onChange={(n) => onChange({ ...rules, safety: n })}
        />
      </div>
    </>
  );
}

function PointFields(props: {
  readonly legend: string;
  readonly end: string;
  readonly value: Vec3;
  readonly onChange: (value: Vec3) => void;
}) {
  const { legend, end, value, onChange } = props;
  return (
    <fieldset class="contest-point">
      <legend>{legend}</legend>
      {AXES.map((axis, i) => (
        <input
          key={axis}
          type="number"
          step="any"
          aria-label={fillWords(words.coordinate, { axis, end })}
          value={value[i]}
          onInput={({ currentTarget }) => {
            const typed = currentTarget.valueAsNumber;
            if (Number.isFinite(typed)) {
              const [x, y, z] = value.map((old, k) => (k === i ? typed : old));
              onChange([x ?? 0, y ?? 0, z ?? 0]);
            }
          }}
        />
      ))}
    </fieldset>
  );
}

function NumberField(props: {
  readonly label: string;
  readonly value: number;
  readonly onChange: (value: number) => void;
}) {
  const { label, value, onChange } = props;
  return (
    <label class="lab-seed">
      <span>{label}</span>
      <input
        type="number"
        min={0}
        step="any"
        value={value}
        onInput={({ currentTarget }) => {
          const typed = currentTarget.valueAsNumber;
          if (typed >= 0) {
            onChange(typed);
          }
        }}
      />
    </label>
  );
}
