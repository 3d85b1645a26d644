import { useEffect, useRef, useState } from 'preact/hooks';
import { shortages } from '../model/brick-set.ts';
import { fillWords } from '../tools/tool-words.ts';
import { CheckPanel } from './check-panel.tsx';
import { ColoursSection } from './colours-section.tsx';
import { CommandButton, Section } from './controls.tsx';
import { Icon } from './icon.tsx';
import { LayoutList } from './layout-list.tsx';
import { MovePanel } from './move-panel.tsx';
import type { PartRow, ResultState } from './page.ts';
import { usePage } from './page-context.ts';
import { placeOf } from './places.ts';
import { ProgressChart } from './progress-chart.tsx';
import { ResultSection } from './result-section.tsx';
import { SettingsSection } from './settings-section.tsx';
import { SymmetrySection } from './sketch-section.tsx';
import { SearchUnderWay, SolveSection } from './solve-section.tsx';
import { plural, text } from './text.ts';
import { VerdictCard } from './verdict-card.tsx';

/** A shorter search is over before anybody has read its figures: the panel would only flicker. */
const LONG_MS = 1200;

/** The right side: the verdict, and what belongs to the place that is open. A sheet on a phone. */
export function Panel() {
  const { panelOpen, room } = usePage();
  const place = placeOf(room.value);
  return (
    <aside
      class={panelOpen.value ? 'panel open' : 'panel'}
      aria-label={text.app.panel}
      data-place={place}
    >
      <button
        type="button"
        class="panel-handle narrow-only"
        aria-expanded={panelOpen.value}
        aria-label={panelOpen.value ? text.app.hidePanel : text.app.showPanel}
        onClick={() => {
          panelOpen.value = !panelOpen.value;
        }}
      >
        <Icon name="chevron" />
      </button>
      <div class="panel-body">
        <h2 class="visually-hidden">{text.app.panel}</h2>
        <VerdictCard />
        <SolveSection />
        {place === 'check' ? <CheckPanel /> : null}
        {place === 'move' ? <MovePanel /> : null}
        {place !== 'check' && place !== 'move' ? <DrawPanel /> : null}
      </div>
    </aside>
  );
}

/** Beside the drawing: search, figures, parts, downloads and settings. */
function DrawPanel() {
  const { phase } = usePage().solve.value;
  const shown = useLastResult();
  const long = useLongSearch(phase === 'solving');
  return (
    <>
      {long ? <SearchUnderWay /> : null}
      {shown && !long ? <ResultSection result={shown} /> : null}
      {shown && !long ? <Alternatives /> : null}
      {shown && !long ? <Parts result={shown} /> : null}
      {shown && !long ? <Downloads /> : null}
      <SearchChart />
      <SymmetrySection />
      <ColoursSection />
      <SettingsSection />
    </>
  );
}

/** The result that is finished; while a search is under way, the one before it. */
function useLastResult(): ResultState | null {
  const { result, solve } = usePage();
  const last = useRef<ResultState | null>(null);
  const shown = result.value;
  if (shown?.final) {
    last.current = shown;
  } else if (solve.value.phase !== 'solving') {
    last.current = null;
  }
  return last.current;
}

/** Whether a search has been under way for so long that its course is worth watching. */
function useLongSearch(solving: boolean): boolean {
  const [long, setLong] = useState(false);
  useEffect(() => {
    const timer = solving ? setTimeout(() => setLong(true), LONG_MS) : undefined;
    return () => {
      clearTimeout(timer);
      setLong(false);
    };
  }, [solving]);
  return long && solving;
}

/** The course of the last search, for those who want to see it. */
function SearchChart() {
  const { chart, phase } = usePage().solve.value;
  if (phase === 'solving' || chart.length < 2) {
    return null;
  }
  return (
    <Section title={text.solve.search}>
      <ProgressChart points={chart} />
      <LayoutList />
    </Section>
  );
}

function Alternatives() {
  return (
    <section class="alternatives-open">
      <CommandButton id="alternatives" words={text.result.alternatives} class="secondary wide" />
    </section>
  );
}

function Downloads() {
  return (
    <section class="downloads" aria-label={text.result.downloads}>
      <CommandButton id="saveMpd" words={text.result.mpd} class="secondary" />
      <CommandButton id="saveModel" words={text.result.model} class="secondary" />
      <CommandButton id="saveParts" words={text.result.csv} class="secondary" />
      <CommandButton id="savePicture" words={text.result.picture} class="secondary" />
    </section>
  );
}

function Parts({ result }: { readonly result: ResultState }) {
  const short = shortages(result.rows, usePage().preferences.value.owned);
  return (
    <Section title={text.result.parts} note={plural(result.bricks, 'brick')} open={true}>
      <table class="parts">
        <thead class="visually-hidden">
          <tr>
            <th scope="col">{text.result.count}</th>
            <th scope="col">{text.result.colour}</th>
            <th scope="col">{text.result.part}</th>
          </tr>
        </thead>
        <tbody>
          {result.rows.map((row) => (
            <PartLine key={`${row.part}/${row.color}`} row={row} short={short.get(row.part) ?? 0} />
          ))}
        </tbody>
      </table>
    </Section>
  );
}

function PartLine(props: { readonly row: PartRow; readonly short: number }) {
  const { row, short } = props;
  const page = usePage();
  const hovered = page.hoveredPart.value === row.part;
  const point = (kind: PartRow | null) => {
    page.listedPart.value = kind && { part: kind.part, color: kind.color };
  };
  return (
    <tr
      class={hovered ? 'hovered' : ''}
      onPointerEnter={() => point(row)}
      onPointerLeave={() => point(null)}
    >
      <td class="count">{row.count}×</td>
      <td>
        <span class="swatch" style={{ background: row.swatch }} title={row.colourName} />
        <span class="visually-hidden">{row.colourName}</span>
      </td>
      <td>
        <button
          type="button"
          class="part-name"
          title={text.part.toggle}
          onFocus={() => point(row)}
          onBlur={() => point(null)}
          onClick={() => page.toggleKind(row)}
        >
          {row.name} <span class="quiet">{row.part}</span>
        </button>
        {short > 0 ? (
          <strong class="short">{fillWords(text.bricks.short, { n: short })}</strong>
        ) : null}
      </td>
    </tr>
  );
}
