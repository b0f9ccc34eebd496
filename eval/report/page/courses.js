'use strict';
// Slow states, residuals and the barometer over a walk's time, below its plan. All of them share the
// pointer, show the slider's moment, and a click moves the slider there.

// What uPlot calls a plugin: keeps a mark at the slider's moment.
function momentMark() {
  const mark = element('div', {class: 'moment'});
  const place = (chart) => {
    const at = chart.valToPos(state.time, 'x');
    mark.hidden = !(at >= 0 && at <= chart.over.clientWidth);
    mark.style.left = `${at}px`;
  };
  const open = (chart) => {
    chart.over.append(mark);
    chart.over.addEventListener('click', (event) => {
      stopPlaying();
      const left = event.clientX - chart.over.getBoundingClientRect().left;
      setTime(Math.max(0, chart.posToVal(left, 'x')));
    });
    chart.showMoment = () => place(chart);
    place(chart);
  };
  return {hooks: {ready: open, setScale: (chart) => mark.isConnected && place(chart),
                  setSize: (chart) => mark.isConnected && place(chart)}};
}

// One chart from the walk's begin to its end at `span`.
function courseChart(title, lines, span, bands = []) {
  const holder = element('div');
  byId('courses').append(element('figure', {class: 'course'},
      element('figcaption', {}, element('b', {}, title)), holder));
  drawChart(holder, lines, {
    title, height: 170, span: [0, span], bands, group: 'walk', plugins: [momentMark()],
    x: {name: 'time', format: (t) => `${+t.toFixed(1)} s`}, y: {format: formatDigits},
  });
}

// Lines that share a colour differ in their dashes.
const courseStyle = (i) => ({colour: `var(--c${i % 8})`, dash: dashes[(i + Math.floor(i / 8)) % 8]});

// A knot's value holds until the next one, the last to the walk's end.
function stateLines(knots, span) {
  const held = [...knots, [span, ...knots[knots.length - 1].slice(1)]];
  const dashed = {colour: 'var(--faint)', dash: [3, 3]};
  return [{points: held.map(([t, v]) => [t, v]), style: courseStyle(0), name: 'value'},
    {points: held.map(([t, v, s]) => [t, v + 2 * s]), style: dashed, faint: true, name: '+ 2 sigma'},
    {points: held.map(([t, v, s]) => [t, v - 2 * s]), style: dashed, faint: true, name: '- 2 sigma'}];
}

// By time; what was heard before the walk's first pose stands at its begin.
function pointsWithin(points, span) {
  return points.map(([t, v]) => [Math.min(Math.max(t, 0), span), v]).sort((a, b) => a[0] - b[0]);
}

function drawCourses(walk, span) {
  const result = walk.methods[byId('course-method').value] ?? {};
  for (const holder of byId('courses').querySelectorAll('figure > div')) closeChart(holder);
  byId('courses').replaceChildren();
  const residuals = Object.entries(result.residuals ?? {});
  if (residuals.length > 0) {
    courseChart('residuals, sigmas (1 is as modelled)', residuals.map(([name, points], i) =>
        ({name, points: pointsWithin(points, span), style: courseStyle(i)})), span);
  }
  const sigmas = [{series: [2, 3], fill: () => colourOf('var(--rule)') + '66'}];
  for (const [name, knots] of Object.entries(result.states ?? {})) {
    courseChart(name, stateLines(knots, span), span, sigmas);
  }
  if (walk.barometer) {
    courseChart('height by the barometer, m',
        [{name: 'height', points: pointsWithin(walk.barometer, span), style: courseStyle(0)}], span);
  }
}

// Offers the methods that have something to show on this walk.
function openCourses(walk, span) {
  const methods = Object.keys(walk.methods).filter(
      (m) => walk.methods[m].states || walk.methods[m].residuals);
  const kept = byId('course-method').value;
  byId('course-choice').hidden = methods.length === 0;
  fillSelect(byId('course-method'), methods.map((m) => [m, methodLabel(m)]),
      methods.includes(kept) ? kept : methods.includes('batch') ? 'batch' : methods[0]);
  drawCourses(walk, span);
}
