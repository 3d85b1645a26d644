// What must come of the drawings and models of ../shared/cases, by the table beside them. A sketch that is not named here
// is built; a model gets a verdict.

/** @typedef {{ ends: 'buildable' | 'not buildable' | 'refused', says?: RegExp }} CaseRow */

const NO_PARTS = /no parts were found that join the lines/;
const RIGID = /are held together as one rigid body/;
const APART = /pieces/;

/** @type {Readonly<Record<string, CaseRow>>} */
export const SKETCH_ROWS = {
  // A line that turns about itself and carries another joint.
  m11_pan_tilt: { ends: 'refused', says: /turns about itself.+because of joints\[1\]/ },
  x5_pan_tilt_small: { ends: 'refused', says: /turns about itself.+because of joints\[1\]/ },
  x8_tilt_at_axle_end: { ends: 'refused', says: /cannot turn about two axes.+joints\[0\]/ },
  k08_cardan: { ends: 'refused', says: /cannot turn about two axes.+joints\[0\]/ },
  k11_gate: { ends: 'refused', says: /turns about itself, so it must be an axle, but line 4/ },
  k12_wrist: { ends: 'refused', says: /turns about itself, so it must be an axle, but line 1/ },
  // Lengths and places that are none.
  m06_folding_x_at_half: { ends: 'refused', says: /is no node of any line/ },
  s15_45_7_10: { ends: 'refused', says: /length 9\.8995 is not a whole number/ },
  s24_6_17p5_18p5: {
    ends: 'refused',
    says: /with the whole drawing twice as large it would be 35/,
  },
  // More at a place than parts join.
  h_jcrash: { ends: 'not buildable', says: NO_PARTS },
  p_fail_ball_simp: { ends: 'not buildable', says: NO_PARTS },
  p_fail_wheel_6edges_1: { ends: 'not buildable', says: NO_PARTS },
  p_us_BOCFinal2: { ends: 'not buildable', says: NO_PARTS },
  p_us_wheel: { ends: 'not buildable', says: NO_PARTS },
  s32_pyramid: { ends: 'not buildable', says: NO_PARTS },
  // Drawn so that braces keep their joints from turning.
  m09_umbrella: { ends: 'not buildable', says: RIGID },
  s07c_jansen_two_joints: { ends: 'not buildable', says: RIGID },
  m12_wishbone: { ends: 'not buildable', says: RIGID },
  // Built, and said that it is in pieces.
  s20_half_cross: { ends: 'buildable', says: APART },
  s21_half_offset_parallel: { ends: 'buildable', says: APART },
  s39_two_pieces: { ends: 'buildable', says: APART },
};
