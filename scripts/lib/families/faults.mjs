// Faults planted into models, to see whether judges find them. Each takes a model and a random source and returns the
// model with one thing changed, or null where the model has nothing to change so.

const turns = {
  x: [1, 0, 0, 0, 0, -1, 0, 1, 0],
  y: [0, 0, 1, 0, 1, 0, -1, 0, 0],
  z: [0, -1, 0, 1, 0, 0, 0, 0, 1],
};

/** The product of two 3 by 3 matrices, by rows. */
function product(a, b) {
  return a.map((_, i) => {
    const [row, column] = [Math.floor(i / 3), i % 3];
    return [0, 1, 2].reduce((sum, k) => sum + a[3 * row + k] * b[3 * k + column], 0);
  });
}

/** A copy in which one part is as `change` says. */
function withPart(model, index, change) {
  const parts = model.parts.map((part, i) => (i === index ? { ...part, ...change(part) } : part));
  return { ...model, parts };
}

function anyPart(model, r) {
  return r.whole(0, model.parts.length - 1);
}

function shifted(by) {
  return (model, r) => {
    const axis = r.whole(0, 2);
    const sign = r.pick([-1, 1]);
    return withPart(model, anyPart(model, r), ({ position }) => ({
      position: position.map((x, i) => (i === axis ? x + sign * by : x)),
    }));
  };
}

/** @type {Record<string, (model: any, r: any) => any>} */
export const FAULTS = {
  'a part is left out': (model, r) => {
    const index = anyPart(model, r);
    return { ...model, parts: model.parts.filter((_, i) => i !== index) };
  },
  'a part is one module off': shifted(1),
  'a part is half a module off': shifted(0.5),
  'a part is 0.05 modules off': shifted(0.05),
  'a part is three modules off': shifted(3),
  'a part is turned by 90 degrees': (model, r) =>
    withPart(model, anyPart(model, r), ({ rotation }) => ({
      rotation: product(turns[r.pick(['x', 'y', 'z'])], rotation),
    })),
  'a part is mirrored': (model, r) =>
    withPart(model, anyPart(model, r), ({ rotation }) => ({
      rotation: rotation.map((x, i) => (i < 3 ? -x : x)),
    })),
  'a part is there twice': (model, r) => ({
    ...model,
    parts: [...model.parts, model.parts[anyPart(model, r)]],
  }),
  'a part is none of the catalogue': (model, r) =>
    withPart(model, anyPart(model, r), () => ({ part: '0' })),
  'a part is another one': (model, r) =>
    withPart(model, anyPart(model, r), () => ({
      part: r.pick(['2780', '3673', '43093', '32523', '32316', '32062', '6536', '87082']),
    })),
  'no part may be where one is': (model, r) => {
    const [x, y, z] = model.parts[anyPart(model, r)].position.map(Math.round);
    const keepOut = [{ min: [x, y, z], max: [x, y, z] }];
    return { ...model, sketch: { ...model.sketch, keepOut } };
  },
  'the ground is above the lowest part': (model, r) => {
    const lowest = Math.min(...model.parts.map(({ position }) => position[2]));
    return { ...model, sketch: { ...model.sketch, ground: lowest + r.whole(1, 3) } };
  },
  'the drawing has a line more': (model, r) => {
    const from = [0, 1, 2].map(() => r.whole(-4, 4));
    const to = from.map((x, i) => (i === 0 ? x + 5 : x));
    return { ...model, sketch: { ...model.sketch, lines: [...model.sketch.lines, { from, to }] } };
  },
  'a line must be met exactly': (model, r) => {
    const index = r.whole(0, model.sketch.lines.length - 1);
    const lines = model.sketch.lines.map((line, i) =>
      i === index ? { ...line, exact: true } : line,
    );
    return { ...model, sketch: { ...model.sketch, lines } };
  },
};
