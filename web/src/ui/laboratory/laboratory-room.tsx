import { useEffect, useState } from 'preact/hooks';
import { Segmented } from '../controls.tsx';
import { BrickAwayView } from './brick-away-view.tsx';
import { ContestView } from './contest/contest-view.tsx';
import { LAB_KEYS, setInAddress, textInAddress } from './lab-address.ts';
import { laboratoryWords as words } from './laboratory-words.ts';
import { ProposalsView } from './proposals-view.tsx';
import { RaceView } from './race-view.tsx';
import './laboratory.css';
import '../alternatives/alternatives.css';

const TABS = ['race', 'bricks', 'weights', 'contest'] as const;
type Tab = (typeof TABS)[number];

/** What the paper's evaluation does, live: methods that race, bricks that are taken away, weights. */
export function LaboratoryRoom({ close }: { readonly close: () => void }) {
  const [tab, setTab] = useState<Tab>(
    () => TABS.find((one) => one === textInAddress(LAB_KEYS.tab)) ?? 'race',
  );
  useEffect(
    () => () => {
      setInAddress(LAB_KEYS.tab, null);
      setInAddress(LAB_KEYS.race, null);
    },
    [],
  );
  const go = (next: Tab) => {
    setTab(next);
    setInAddress(LAB_KEYS.tab, next === 'race' ? null : next);
  };
  return (
    <div class="laboratory">
      <Segmented
        name="lab-tab"
        legend={words.tabsLabel}
        choices={TABS.map((value) => ({ value, label: words.tabs[value] }))}
        value={tab}
        onChange={go}
      />
      {tab === 'race' ? <RaceView /> : null}
      {tab === 'bricks' ? <BrickAwayView /> : null}
      {tab === 'contest' ? <ContestView close={close} /> : null}
      {tab === 'weights' ? <ProposalsView close={close} /> : null}
    </div>
  );
}
