import { useEffect } from 'preact/hooks';
import type { Balance, MotionAnswer } from '../../model/motion.ts';
import { BalanceOverlay } from '../../view/overlays/balance-overlay.ts';
import { usePage } from '../page-context.ts';
import { formatNumber } from '../text/language.ts';
import type { CheckProps, CheckStatus, CheckView } from './check-registry.ts';
import { answerOf, motionStatus } from './motion-status.ts';
import { motionWords as words } from './motion-words.ts';
import { NumberList } from './number-list.tsx';
import './motion.css';

/** Of a unit vector: less along an axis is not worth a word. */
const SHARE = 0.35;

/** Whether the model stands, with the area it stands on and its centre of mass in the scene. */
export const BALANCE_CHECK: CheckView = {
  id: 'balance',
  title: words.balance,
  status: motionStatus(statusOf),
  component: BalanceCheck,
};

function statusOf({ balance }: MotionAnswer): CheckStatus {
  if (!balance) {
    return { state: 'none', number: '' };
  }
  return balance.stable
    ? { state: 'ok', number: `${words.stands}, ${formatNumber(balance.tippingAngle)}°` }
    : { state: 'bad', number: words.falls };
}

function BalanceCheck({ shown }: CheckProps) {
  const balance = answerOf(shown)?.balance;
  if (!balance) {
    return <p class="quiet">{words.unknown}</p>;
  }
  return <BalancePicture balance={balance} />;
}

/** A direction on the floor, by the axes that it has a share in: `+x`, `−y`, `+x −y`. */
export function towardsText([x, y]: Balance['direction']): string {
  const share = (value: number, axis: string) =>
    Math.abs(value) < SHARE ? [] : [`${value < 0 ? '−' : '+'}${axis}`];
  return [...share(x, 'x'), ...share(y, 'y')].join(' ');
}

function BalancePicture({ balance }: { readonly balance: Balance }) {
  const page = usePage();
  useEffect(() => page.view()?.addOverlay(new BalanceOverlay(balance)), [page, balance]);
  const rows: readonly (readonly [string, string])[] = [
    [words.centre, balance.centre.map((value) => formatNumber(value, 2)).join(', ')],
    [words.margin, words.modules(formatNumber(balance.margin, 2))],
    [words.towards, towardsText(balance.direction)],
    [words.tipping, `${formatNumber(balance.tippingAngle, 1)}°`],
  ];
  return (
    <div class="motion-check">
      <p class="quiet">{words.aboutBalance}</p>
      <NumberList rows={rows} />
    </div>
  );
}
