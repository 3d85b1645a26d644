import { countGuests } from '../model/guests.ts';
import type { Model } from '../model/model.ts';
import type { AssemblyPlan, AssemblyStep } from './assembly-plan.ts';

/** Whether a part is one that the core does not know (model/guests.ts). */
export function isGuest(model: Model, index: number): boolean {
  return index >= model.parts.length - countGuests(model);
}

/**
 * A plan of the parts that are known, with the others at its end, from below upwards: nobody knows what they hold on to
 * nor what is in their way.
 */
export function withGuestsLast(plan: AssemblyPlan, model: Model): AssemblyPlan {
  const guests = [...model.parts.keys()].filter((index) => isGuest(model, index));
  const heightOf = (index: number) => model.parts[index]?.position[2] ?? 0;
  const steps = guests
    .sort((a, b) => heightOf(a) - heightOf(b) || a - b)
    .map(
      (index): AssemblyStep => ({
        group: 0,
        adds: [{ parts: [index], travel: [0, 0, 0], via: [], subgroup: null, forced: false }],
        stable: true,
      }),
    );
  const groups = plan.groups.map((group) =>
    group.id === 0 ? { ...group, parts: [...group.parts, ...guests] } : group,
  );
  return { ...plan, groups, steps: [...plan.steps, ...steps] };
}
