// Plots as SVG text: Vega-Lite, which needs no page and draws the same on every machine.
import { parse, View } from 'vega';
import { compile } from 'vega-lite';

const SIZE = { width: 360, height: 260 };

/**
 * A line for each name of `series`.
 * @param {{x: number, y: number, series: string}[]} points
 * @param {{x: string, y: string, logarithmic?: boolean}} titles of the axes
 */
export function linePlot(points, { x, y, logarithmic = false }) {
  const scale = logarithmic ? { type: 'log' } : { zero: true };
  return {
    ...SIZE,
    data: { values: points },
    mark: { type: 'line', point: true },
    encoding: {
      x: { field: 'x', type: 'quantitative', title: x, scale },
      y: { field: 'y', type: 'quantitative', title: y, scale },
      color: { field: 'series', type: 'nominal', title: null, sort: null },
      shape: { field: 'series', type: 'nominal', title: null, sort: null },
    },
  };
}

/**
 * Bars side by side: a group for each x, in it a bar for each name of `series`.
 * @param {{x: string, y: number, series: string}[]} points
 */
export function barPlot(points, { x, y }) {
  return {
    height: SIZE.height,
    width: { step: 14 },
    data: { values: points },
    mark: 'bar',
    encoding: {
      x: { field: 'x', type: 'nominal', title: x, sort: null },
      xOffset: { field: 'series', type: 'nominal', sort: null },
      y: { field: 'y', type: 'quantitative', title: y },
      color: { field: 'series', type: 'nominal', title: null, sort: null },
    },
  };
}

/** @returns {Promise<string>} the SVG file of a specification. */
export async function svgOf(spec) {
  const compiled = compile({ background: 'white', ...spec }).spec;
  const view = new View(parse(compiled), { renderer: 'none' });
  const svg = await view.toSVG();
  view.finalize();
  return `${svg}\n`;
}
