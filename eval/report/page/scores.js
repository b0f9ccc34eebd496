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

// The share of waypoints within each distance, as [metres, share] of the sorted errors.
function cdfPoints(sorted) {
  const points = [[0, 0]];
  sorted.forEach((error, i) => {
    const share = (i + 1) / sorted.length;
    if (points[points.length - 1][0] === error) points[points.length - 1][1] = share;
    else points.push([error, share]);
  });
  return points;
}

function drawCdf(run, name) {
  const holder = byId('cdf');
  const errors = sectionErrors(run, name);
  const shown = run.methods.filter((method) => errors[method].length > 0);
  holder.parentElement.hidden = shown.length === 0;
  closeChart(holder);
  if (shown.length === 0) return;
  const lines = shown.map((method) => ({
    name: `${methodLabel(method)} (n = ${errors[method].length})`, points: cdfPoints(errors[method]),
    style: styleOf(run, method), stepped: true}));
  const chart = drawChart(holder, lines, {
    title: 'Share of waypoints within a distance, by method',
    height: Math.max(240, Math.min(380, holder.clientWidth * 0.5)),
    x: {label: 'error, m', name: 'within', format: (metres) => `${+metres.toFixed(2)} m`},
    y: {format: (share) => `${+(100 * share).toFixed(1)} %`},
  });
  // To the largest 90th percentile: beyond it the tails of the worst would squeeze the rest.
  const limit = Math.max(0.5, ...shown.map((m) => errors[m][Math.floor(0.9 * (errors[m].length - 1))]));
  chart.setScale('x', {min: 0, max: limit});
}
