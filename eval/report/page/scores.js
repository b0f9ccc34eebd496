'use strict';
// The score table and the distribution of errors.

const scoreColumns = [
  ['walks', 'walks', String], ['n', 'n', String], ['mean_m', 'mean m', formatMetres],
  ['mean_interval_m', '95 % interval', (v) => v ? v.map(formatMetres).join(' – ') : '–'],
  ['median_m', 'median m', formatMetres], ['p75_m', 'p75 m', formatMetres],
  ['p90_m', 'p90 m', formatMetres], ['p95_m', 'p95 m', formatMetres],
  ['max_m', 'max m', formatMetres], ['rmse_m', 'RMSE m', formatMetres],
  ['floor_accuracy', 'floor', formatShare],
  ['coverage95', 'in 95 %', formatShare],
];
const smallerIsBetter = new Set(['mean_m', 'median_m', 'p75_m', 'p90_m', 'p95_m', 'max_m', 'rmse_m']);
const scoreState = {column: 'mean_m', descending: false};

const sectionNotes = {
  pooled: 'walks on which every method gave a trajectory',
  covered: 'of those, walks less than 3 m from where somebody surveyed',
  all_walks: 'every walk; a missing output counts at the map’s centroid (not in the curve)',
};

function sortValue(row, column) {
  const value = row[column];
  return Array.isArray(value) ? value[0] : value;
}

function sortedRows(section) {
  const rows = Object.entries(section).map(([method, row]) => ({method, ...row}));
  const sign = scoreState.descending ? -1 : 1;
  rows.sort((a, b) => {
    const left = sortValue(a, scoreState.column), right = sortValue(b, scoreState.column);
    if (left === null || right === null) return (left === null) - (right === null);
    return left < right ? -sign : left > right ? sign : 0;
  });
  return rows;
}

function headerCell(column, text, redraw) {
  const button = element('button', {type: 'button'}, text);
  const cell = element('th', {scope: 'col'}, button);
  if (column === scoreState.column) {
    cell.setAttribute('aria-sort', scoreState.descending ? 'descending' : 'ascending');
  }
  button.addEventListener('click', () => {
    scoreState.descending = column === scoreState.column && !scoreState.descending;
    scoreState.column = column;
    redraw();
    byId('score-table').querySelector('th[aria-sort] button').focus();
  });
  return cell;
}

function drawScoreTable(run, name) {
  const section = run.summary.sections[name];
  const redraw = () => drawScoreTable(run, name);
  const head = element('tr', {}, headerCell('method', 'method', redraw));
  for (const [column, text] of scoreColumns) head.append(headerCell(column, text, redraw));
  const rows = sortedRows(section);
  const best = {};
  for (const column of smallerIsBetter) {
    const values = rows.map((row) => row[column]).filter((v) => typeof v === 'number');
    best[column] = Math.min(...values);
  }
  const body = element('tbody');
  for (const row of rows) {
    const line = element('tr', {}, element('td', {}, lineKey(styleOf(run, row.method)),
                                           ` ${methodLabel(row.method)}`));
    for (const [column, , format] of scoreColumns) {
      const wins = smallerIsBetter.has(column) && row[column] === best[column];
      line.append(element('td', wins ? {class: 'best'} : {}, format(row[column])));
    }
    body.append(line);
  }
  byId('score-table').replaceChildren(element('thead', {}, head), body);
  byId('selection-note').textContent = sectionNotes[name] ?? '';
}

// A round step that divides `span` into at most `count` parts.
function roundStep(span, count) {
  const raw = span / count;
  const power = 10 ** Math.floor(Math.log10(raw));
  return power * [1, 2, 5, 10].find((factor) => factor * power >= raw);
}

function drawAxes(svg, box, limit) {
  const step = roundStep(limit, box.width < 500 ? 5 : 10);
  for (let x = 0; x <= limit + 1e-9; x += step) {
    const at = box.left + box.width * x / limit;
    svg.append(svgElement('line', {class: 'axis', x1: at, x2: at, y1: box.top,
                                   y2: box.top + box.height}),
        svgElement('text', {x: at, y: box.top + box.height + 16, 'text-anchor': 'middle'},
            String(Math.round(x * 10) / 10)));
  }
  for (const share of [0, 0.25, 0.5, 0.75, 1]) {
    const at = box.top + box.height * (1 - share);
    svg.append(svgElement('line', {class: 'axis', x1: box.left, x2: box.left + box.width, y1: at,
                                   y2: at}),
        svgElement('text', {x: box.left - 6, y: at + 4, 'text-anchor': 'end'}, `${100 * share} %`));
  }
  svg.append(svgElement('text', {x: box.left + box.width / 2, y: box.top + box.height + 34,
                                 'text-anchor': 'middle'}, 'error, m'));
}

function drawCdf(run, name) {
  const svg = byId('cdf');
  const {width, height} = svg.getBoundingClientRect();
  svg.setAttribute('viewBox', `0 0 ${width} ${height}`);
  svg.replaceChildren();
  const box = {left: 52, top: 12, width: width - 72, height: height - 58};
  const errors = sectionErrors(run, name);
  const shown = run.methods.filter((method) => errors[method].length > 0);
  byId('cdf').parentElement.hidden = shown.length === 0;
  if (shown.length === 0) return;
  // To the largest 90th percentile: beyond it the tails of the worst would squeeze the rest.
  const limit = Math.max(0.5, ...shown.map((m) => errors[m][Math.floor(0.9 * (errors[m].length - 1))]));
  drawAxes(svg, box, limit);
  for (const method of shown) {
    const style = styleOf(run, method);
    let path = `M${box.left} ${box.top + box.height}`;
    errors[method].forEach((error, i) => {
      if (error > limit) return;
      const x = box.left + box.width * error / limit;
      path += `H${x.toFixed(1)}V${(box.top + box.height * (1 - (i + 1) / errors[method].length)).toFixed(1)}`;
    });
    svg.append(svgElement('path', {class: 'line', d: path, 'stroke-width': 2,
                                   'stroke-dasharray': style.dash.join(' '),
                                   style: `stroke:${style.colour}`}));
  }
  byId('cdf-legend').replaceChildren(...shown.map((method) => element('span', {},
      lineKey(styleOf(run, method)), ` ${methodLabel(method)} (n = ${errors[method].length})`)));
}
