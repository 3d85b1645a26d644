export const PROOF_EN = {
  title: 'Fewest beams',
  proved: 'proved',
  atLeast: (least: string) => `at least ${least}`,
  nobody: (beams: string) => `Proved: nobody can do it with fewer than these ${beams} beams.`,
  gap: (beams: string, least: string) =>
    `This model has ${beams} beams; at least ${least} are needed.`,
  openGap: 'Nobody has proved more so far; whether fewer can be built is open.',
  prove: 'Prove it',
  stop: 'Stop the proof',
  loading: 'Loading the prover …',
  working: (done: string, pieces: string, leaves: string) =>
    `Proved ${done} of ${pieces} pieces, ${leaves} cases.`,
  failed: 'This could not be proved.',
  unknown: 'Known for models that were generated here.',
  about:
    'Counts every way in which the parts in use could cover the lines, whatever their layers, with no more axles along lines than this model has. Edges are left bare only next to corners that no single direction of holes serves.',
};
