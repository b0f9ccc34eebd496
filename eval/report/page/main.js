'use strict';
// Puts the parts together and answers the controls.

const state = {run: data.runs[0], walk: null, time: 0, timer: null, hidden: new Set()};

function chooseTheme(dark) {
  document.documentElement.dataset.theme = dark ? 'dark' : 'light';
  byId('theme').textContent = dark ? 'Light' : 'Dark';
}

const isDark = () => document.documentElement.dataset.theme === 'dark';

// Charts take their colours and keys when they are drawn.
function redrawCharts() {
  drawSection();
  if (state.walk) drawCourses(state.walk, Number(byId('time').max));
}

function currentView() {
  const floor = state.run.building.floors.find((item) => String(item.number) === byId('floor').value);
  return {floor, whole: byId('extent').value === 'floor', time: state.time,
          truth: !state.hidden.has('truth'), ellipses: !state.hidden.has('ellipses'),
          methods: state.run.methods.filter((method) => !state.hidden.has(`method ${method}`))};
}

function redrawPlan() {
  byId('clock').textContent = `${state.time.toFixed(1)} s of ${Number(byId('time').max).toFixed(1)} s`;
  if (state.walk) drawPlan(state.run, state.walk, currentView());
}

function drawSection() {
  const name = byId('selection').value;
  if (!state.run.summary) return;
  drawScoreTable(state.run, name);
  drawCdf(state.run, name);
}

function stopPlaying() {
  clearInterval(state.timer);
  state.timer = null;
  byId('play').textContent = 'Play';
}

function setTime(time) {
  state.time = time;
  byId('time').value = time;
  const tracks = currentView().methods.map((m) => state.walk.methods[m]?.track).filter(Boolean);
  // The floor follows the walk, as the first shown method sees it.
  if (tracks.length > 0 && tracks[0].t.length > 0) {
    byId('floor').value = String(tracks[0].floor[poseAt(tracks[0], time)]);
  }
  markTime(time);
  redrawPlan();
}

// The moment that the slider shows, on every figure over time.
function markTime(time) {
  for (const chart of charts.values()) chart.showMoment?.();
  for (const svg of document.querySelectorAll('svg[data-time]')) {
    const [low, high, left, width, top, height] = svg.dataset.time.split(' ').map(Number);
    const x = left + width * (time - low) / (high - low);
    svg.querySelector('.moment')?.remove();
    svg.append(svgElement('path', {class: 'moment', stroke: 'currentColor', 'stroke-width': 1.5,
                                   d: `M${x.toFixed(1)} ${top}v${height}`}));
  }
}

// Walks four times as fast as the walker did.
function togglePlaying() {
  if (state.timer !== null) return stopPlaying();
  if (state.time >= Number(byId('time').max)) state.time = 0;
  byId('play').textContent = 'Stop';
  state.timer = setInterval(() => {
    const end = Number(byId('time').max);
    setTime(Math.min(end, state.time + 0.4));
    if (state.time >= end) stopPlaying();
  }, 100);
}

function drawWalkTable(walk) {
  const names = ['method', 'status', 'waypoints', 'mean m', 'max m'];
  const head = element('tr', {}, ...names.map((name) => element('th', {scope: 'col'}, name)));
  const body = element('tbody');
  const messages = [];
  for (const method of state.run.methods) {
    const result = walk.methods[method];
    if (!result) continue;
    const errors = result.errors_m;
    const mean = errors.length > 0 ? errors.reduce((a, b) => a + b, 0) / errors.length : null;
    body.append(element('tr', {}, element('td', {}, lineKey(styleOf(state.run, method)),
                                          ` ${methodLabel(method)}`),
        element('td', {}, result.status ?? ''), element('td', {}, String(errors.length)),
        element('td', {}, formatMetres(mean)),
        element('td', {}, formatMetres(errors.length > 0 ? Math.max(...errors) : null))));
    for (const message of result.messages) messages.push(element('li', {}, `${method}: ${message}`));
  }
  byId('walk-table').replaceChildren(element('thead', {}, head), body);
  byId('messages').replaceChildren(...messages);
}

function openWalk(index) {
  stopPlaying();
  const walk = state.run.walks[index];
  state.walk = walk;
  byId('walk').value = String(index);
  byId('previous').disabled = index === 0;
  byId('next').disabled = index + 1 === state.run.walks.length;
  const ends = Object.values(walk.methods).flatMap((result) => result.track ? result.track.t.slice(-1) : []);
  byId('time').max = Math.max(0.1, ...ends, ...walk.waypoints.map((point) => point[0]));
  const floors = state.run.building.floors;
  fillSelect(byId('floor'), floors.map((floor) => [String(floor.number), floor.name]),
      walk.waypoints.length > 0 ? walk.waypoints[0][3] : floors[0]?.number);
  drawWalkTable(walk);
  openCourses(walk, Number(byId('time').max));
  setTime(0);
}

function layerBox(key, label, shown, style) {
  const box = element('input', {type: 'checkbox'});
  box.checked = shown;
  if (!shown) state.hidden.add(key);
  box.addEventListener('change', () => {
    if (box.checked) state.hidden.delete(key); else state.hidden.add(key);
    redrawPlan();
  });
  return element('label', {}, box, ...(style ? [lineKey(style)] : []), label);
}

// At first: truth, the discrete smoother and one graph, so that the picture stays readable.
function drawLayers() {
  state.hidden.clear();
  const {methods} = state.run;
  const wanted = methods.filter((m) => m === 'viterbi' || m === 'batch' ||
                                       (m === 'window' && !methods.includes('batch')));
  const shown = new Set(wanted.length > 0 ? wanted : methods.slice(0, 2));
  byId('layers').replaceChildren(
      layerBox('truth', 'truth', true, {colour: 'var(--ink)', dash: [2, 4]}),
      ...methods.map((method) => layerBox(`method ${method}`, methodLabel(method), shown.has(method),
          styleOf(state.run, method))),
      layerBox('ellipses', '95 % ellipses', true));
}

// Drawn by walkgraph itself, as in the files beside the page.
function drawFigures() {
  const {figures, notes} = state.run;
  byId('notes').replaceChildren(...(notes ?? []).map((note) => element('li', {}, note)));
  byId('figures').hidden = figures.length === 0;
  byId('figure-list').replaceChildren(...figures.map((svg) => {
    const figure = element('figure', {class: 'plot'});
    figure.innerHTML = svg;
    return figure;
  }));
}

function openRun(index) {
  state.run = data.runs[index];
  byId('run-name').textContent = `${state.run.building.name} – ${state.run.walks.length} walks`;
  byId('scores').hidden = !state.run.summary;
  if (state.run.summary) {
    const names = Object.keys(state.run.summary.sections);
    fillSelect(byId('selection'), names.map((name) => [name, name.replace('_', ' ')]), names[0]);
    drawSection();
  }
  drawFigures();
  byId('walks').hidden = state.run.walks.length === 0;
  fillSelect(byId('walk'), state.run.walks.map((walk, i) => [String(i), walk.walk]), '0');
  drawLayers();
  if (state.run.walks.length > 0) openWalk(0);
}

// Paper is light, and narrower than most screens.
function printLight() {
  let dark = false;
  window.addEventListener('beforeprint', () => {
    dark = isDark();
    chooseTheme(false);
    redrawCharts();
    resizeCharts(printWidth);
  });
  window.addEventListener('afterprint', () => {
    chooseTheme(dark);
    redrawCharts();
  });
}

function start() {
  chooseTheme(matchMedia('(prefers-color-scheme: dark)').matches);
  byId('theme').addEventListener('click', () => { chooseTheme(!isDark()); redrawCharts(); });
  byId('run-choice').hidden = data.runs.length < 2;
  fillSelect(byId('run'), data.runs.map((run, i) => [String(i), run.name]), '0');
  byId('run').addEventListener('change', () => openRun(Number(byId('run').value)));
  byId('selection').addEventListener('change', drawSection);
  byId('walk').addEventListener('change', () => openWalk(Number(byId('walk').value)));
  byId('previous').addEventListener('click', () => openWalk(Number(byId('walk').value) - 1));
  byId('next').addEventListener('click', () => openWalk(Number(byId('walk').value) + 1));
  byId('course-method').addEventListener('change', () => drawCourses(state.walk, Number(byId('time').max)));
  byId('floor').addEventListener('change', redrawPlan);
  byId('extent').addEventListener('change', redrawPlan);
  byId('time').addEventListener('input', () => { stopPlaying(); setTime(Number(byId('time').value)); });
  byId('play').addEventListener('click', togglePlaying);
  window.addEventListener('resize', () => { resizeCharts(); redrawPlan(); });
  printLight();
  openRun(0);
}

start();
