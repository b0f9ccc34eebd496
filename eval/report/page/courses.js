'use strict';
// Slow states, residuals and the barometer over a walk's time, below its plan.

const courseSize = {width: 640, height: 120, left: 56, top: 8, right: 12, bottom: 22};

// One chart: lines of [seconds, value], between the given moments.
function courseChart(title, lines, span) {
  const {width, height, left, top, right, bottom} = courseSize;
  const box = {width: width - left - right, height: height - top - bottom};
  const values = lines.flatMap((line) => line.points.map((point) => point[1]));
  let low = Math.min(...values), high = Math.max(...values);
  if (high - low < 1e-9) { low -= Math.abs(low) * 0.05 + 1e-3; high += Math.abs(high) * 0.05 + 1e-3; }
  const x = (t) => left + box.width * (Math.min(Math.max(t, 0), span) / span);
  const y = (v) => top + box.height * (high - v) / (high - low);
  const svg = svgElement('svg', {viewBox: `0 0 ${width} ${height}`, role: 'img',
      'aria-label': title, 'data-time': `0 ${span} ${left} ${box.width} ${top} ${box.height}`});
  const step = roundStep(high - low, 3);
  for (let v = Math.ceil(low / step) * step; v <= high; v += step) {
    svg.append(svgElement('line', {class: 'axis', x1: left, x2: left + box.width, y1: y(v), y2: y(v)}),
        svgElement('text', {x: left - 6, y: y(v) + 4, 'text-anchor': 'end'}, String(+v.toPrecision(3))));
  }
  for (let t = 0; t <= span; t += roundStep(span, 8)) {
    svg.append(svgElement('text', {x: x(t), y: height - 6, 'text-anchor': 'middle'}, `${+t.toPrecision(4)} s`));
  }
  for (const {points, style, faint} of lines) {
    const d = points.map(([t, v], i) => `${i === 0 ? 'M' : 'L'}${x(t).toFixed(1)} ${y(v).toFixed(1)}`).join('');
    svg.append(svgElement('path', {class: 'line', d, 'stroke-width': faint ? 1 : 1.8,
        'stroke-dasharray': style.dash.join(' '), style: `stroke:${style.colour}`}));
  }
  const keys = lines.filter((line) => line.name).map((line) =>
      element('span', {}, lineKey(line.style), ` ${line.name}`));
  return element('figure', {class: 'course'}, element('figcaption', {}, element('b', {}, title), ...keys), svg);
}

const courseStyle = (i) => ({colour: `var(--c${i % 8})`, dash: dashes[i % 8]});

// A knot's value holds until the next one, the last to the walk's end.
function stateLines(knots, span) {
  const held = [...knots, [span, ...knots[knots.length - 1].slice(1)]];
  const dashed = {colour: 'var(--faint)', dash: [3, 3]};
  return [{points: held.map(([t, v]) => [t, v]), style: courseStyle(0), name: 'value'},
    {points: held.map(([t, v, s]) => [t, v - 2 * s]), style: dashed, faint: true, name: '± 2 sigma'},
    {points: held.map(([t, v, s]) => [t, v + 2 * s]), style: dashed, faint: true}];
}

function drawCourses(walk, span) {
  const result = walk.methods[byId('course-method').value] ?? {};
  const charts = [];
  const residuals = Object.entries(result.residuals ?? {});
  if (residuals.length > 0) {
    charts.push(courseChart('residuals, sigmas (1 is as modelled)', residuals.map(([name, points], i) =>
        ({name, points: [...points].sort((a, b) => a[0] - b[0]), style: courseStyle(i)})), span));
  }
  for (const [name, knots] of Object.entries(result.states ?? {})) {
    charts.push(courseChart(name, stateLines(knots, span), span));
  }
  if (walk.barometer) {
    charts.push(courseChart('height by the barometer, m', [{points: walk.barometer, style: courseStyle(0)}], span));
  }
  byId('courses').replaceChildren(...charts);
}

// Offers the methods that have something to show on this walk.
function openCourses(walk, span) {
  const methods = Object.keys(walk.methods).filter((m) => walk.methods[m].states || walk.methods[m].residuals);
  const kept = byId('course-method').value;
  byId('course-choice').hidden = methods.length === 0;
  fillSelect(byId('course-method'), methods.map((m) => [m, methodLabel(m)]),
      methods.includes(kept) ? kept : methods.includes('batch') ? 'batch' : methods[0]);
  drawCourses(walk, span);
}
