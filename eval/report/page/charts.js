'use strict';
// Charts in the page's colours that keys can use as well as a pointer, drawn by uPlot: dragging
// zooms, a double click shows all again, and the legend tells the values under the pointer.

const charts = new Map();  // by the element that holds it
const printWidth = 660;    // CSS pixels that fit on paper of any size

// A canvas knows no style sheet: the colour behind a custom property, as the theme has it now.
function colourOf(text) {
  const name = /^var\((.*)\)$/.exec(text);
  return name ? getComputedStyle(document.documentElement).getPropertyValue(name[1]).trim() : text;
}

function chartAxis(label, format, size) {
  const faint = () => colourOf('var(--faint)'), rule = () => colourOf('var(--rule)');
  return {label, labelSize: label ? 20 : 0, size, stroke: faint, grid: {stroke: rule, width: 1},
          ticks: {stroke: rule, width: 1, size: 4}, values: (_, ticks) => ticks.map(format)};
}

// Values of each line at the abscissae of all and at `more`; undefined where a line has no point.
function alignLines(lines, more) {
  const columns = lines.map((line) => [line.points.map((p) => p[0]), line.points.map((p) => p[1])]);
  return uPlot.join([...columns, [more]]);
}

function chartSeries(line, format) {
  const dash = line.style.dash;
  return {label: line.name, stroke: () => colourOf(line.style.colour), width: line.faint ? 1 : 2, dash,
          paths: line.stepped ? uPlot.paths.stepped({align: 1}) : undefined, points: {show: false},
          value: (_, v) => v === null || v === undefined ? '–' : format(v)};
}

// A key's frame tells dashes apart as far as frames can.
function borderOf(line) {
  const [stroke] = line.style.dash;
  return stroke === undefined ? 'solid' : stroke <= 2 ? 'dotted' : 'dashed';
}

// The legend's entries switch lines on and off; they must take the keyboard's focus for that.
function openLegend(chart) {
  chart.root.querySelectorAll('.u-legend .u-series').forEach((row, i) => {
    if (i === 0) return;  // the abscissa
    const key = row.querySelector('th');
    key.tabIndex = 0;
    key.setAttribute('role', 'button');
    key.addEventListener('keydown', (event) => {
      if (event.key !== 'Enter' && event.key !== ' ') return;
      event.preventDefault();
      chart.setSeries(i, {show: !chart.series[i].show});
    });
  });
}

function closeChart(holder) {
  charts.get(holder)?.destroy();
  charts.delete(holder);
}

const formatDigits = (value) => String(+value.toPrecision(4));

// Draws `lines` ({name, points: [[x, y]] with rising x, style, faint, stepped}) in `holder`, in place
// of what was there. `options`: title; height; x and y ({label, name, format}); span ([low, high]) of x
// at least; group, whose charts share the pointer; bands and plugins as uPlot has them.
function drawChart(holder, lines, options) {
  closeChart(holder);
  const {x, y, group} = options;
  const chart = new uPlot({
    width: Math.max(200, holder.clientWidth), height: options.height,
    scales: {x: {time: false}},
    axes: [chartAxis(x.label, x.format, 28), chartAxis(y.label, y.format, 56)],
    series: [{label: x.name, value: (_, v) => v === null || v === undefined ? '–' : x.format(v)},
             ...lines.map((line) => chartSeries(line, y.format))],
    bands: options.bands ?? [], plugins: options.plugins ?? [],
    legend: {markers: {dash: (_, i) => borderOf(lines[i - 1])}},
    cursor: group ? {sync: {key: group, scales: ['x', null]}} : {},
  }, alignLines(lines, options.span ?? []), holder);
  chart.root.querySelector('canvas').setAttribute('role', 'img');
  chart.root.querySelector('canvas').setAttribute('aria-label', options.title);
  openLegend(chart);
  charts.set(holder, chart);
  return chart;
}

function resizeCharts(widest = Infinity) {
  for (const [holder, chart] of charts) {
    chart.setSize({width: Math.max(200, Math.min(widest, holder.clientWidth)), height: chart.height});
  }
}
