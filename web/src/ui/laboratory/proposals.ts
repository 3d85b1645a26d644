import type { Candidate } from '../alternatives/alternatives.ts';

// Four proposals for one drawing, each with what it weighs more than the others, and five sliders that turn all of them.

/** What can be weighed: terms of the objective (core/objective/term.h). */
export const WEIGHED = ['beams', 'connections', 'layers', 'overhang', 'hinges'] as const;
export type Weighed = (typeof WEIGHED)[number];

/** How many times its usual weight each has, as powers of two. */
export type Turns = Readonly<Record<Weighed, number>>;

export const NO_TURNS: Turns = Object.freeze({
  beams: 0,
  connections: 0,
  layers: 0,
  overhang: 0,
  hinges: 0,
});

/** Sliders go so far to both sides. */
export const MOST_TURNS = 3;

export const PROPOSALS = ['simple', 'stiff', 'cheap', 'faithful'] as const;
export type ProposalId = (typeof PROPOSALS)[number];

interface Proposal {
  readonly preset: string;
  /** In units of one connecting part, as the presets of core/objective/objective.cpp. */
  readonly weights: Readonly<Record<Weighed, number>>;
}

const TABLE: Readonly<Record<ProposalId, Proposal>> = {
  simple: {
    preset: 'simple',
    weights: { beams: 10, connections: 1, layers: 0.02, overhang: 2, hinges: 3 },
  },
  stiff: {
    preset: 'simple-rigid',
    weights: { beams: 10, connections: 0.5, layers: 0.02, overhang: 2, hinges: 16 },
  },
  cheap: {
    preset: 'simple',
    weights: { beams: 10, connections: 4, layers: 0.02, overhang: 1, hinges: 1 },
  },
  faithful: {
    preset: 'faithful',
    weights: { beams: 4, connections: 1, layers: 0.5, overhang: 6, hinges: 3 },
  },
};

/** The proposals as what alternatives are searched with. */
export function proposalCandidates(seed: number): (Candidate & { readonly id: ProposalId })[] {
  return PROPOSALS.map((id) => ({ id, preset: TABLE[id].preset, seed }));
}

/** The weights of a proposal, as lines of the advanced settings: a model that is taken keeps them. */
export function weightsText(id: ProposalId, turns: Turns): string {
  return WEIGHED.map(
    (term) =>
      `weights.${term}=${Number((TABLE[id].weights[term] * 2 ** turns[term]).toPrecision(4))}`,
  ).join('\n');
}

/** Settings of a person with weights of ours in place of theirs. */
export function withWeights(advanced: string, weights: string): string {
  const others = advanced
    .split('\n')
    .filter((row) => !WEIGHED.some((term) => row.trim().startsWith(`weights.${term}`)));
  return [...others, weights].join('\n').trim();
}
