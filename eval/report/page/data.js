'use strict';
// The results as the page's other parts see them, and small tools for the document.

const data = JSON.parse(document.getElementById('data').textContent);
const byId = (id) => document.getElementById(id);

// Colours by role: the graph and the discrete smoother keep theirs whatever else is shown. Dashes
// tell lines apart where colours cannot.
const preferredColours = {batch: 0, viterbi: 1, window: 2};
const dashes = [[], [6, 3], [2, 2], [8, 3, 2, 3], [4, 4], [1, 3], [10, 4], [3, 1]];

function styleOf(run, method) {
  const taken = new Set(run.methods.map((name) => preferredColours[name]));
  const free = [0, 1, 2, 3, 4, 5, 6, 7].filter((index) => !taken.has(index));
  const others = run.methods.filter((name) => preferredColours[name] === undefined);
  const index = preferredColours[method] ?? free[others.indexOf(method) % free.length];
  return {colour: `var(--c${index})`, dash: dashes[index]};
}

function methodLabel(method) {
  const roles = {viterbi: 'viterbi (HMM)', batch: 'batch (graph)', window: 'window (graph)'};
  return roles[method] ?? method;
}

function element(tag, attributes = {}, ...children) {
  const node = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
  node.append(...children);
  return node;
}

function svgElement(tag, attributes = {}, ...children) {
  const node = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
  node.append(...children);
  return node;
}

function fillSelect(select, options, value) {
  select.replaceChildren(...options.map(([key, text]) => element('option', {value: key}, text)));
  if (options.some(([key]) => key === String(value))) select.value = value;
}

// A short piece of a method's line.
function lineKey(style) {
  return svgElement('svg', {class: 'key', viewBox: '0 0 32 12', 'aria-hidden': 'true'},
      svgElement('line', {x1: 0, y1: 6, x2: 32, y2: 6, style: `stroke:${style.colour}`,
                          'stroke-dasharray': style.dash.join(' ')}));
}

const formatMetres = (value) => value === null || value === undefined ? '–' : value.toFixed(2);
const formatShare = (value) =>
    value === null || value === undefined ? '–' : `${(100 * value).toFixed(1)} %`;

// Errors of one walk's waypoints under a method; empty where it gave no trajectory.
const errorsOf = (walk, method) => walk.methods[method]?.errors_m ?? [];

// The waypoint errors behind a section of the summary, by method.
function sectionErrors(run, section) {
  const shared = run.walks.filter((walk) => run.methods.every((m) => errorsOf(walk, m).length > 0));
  const floor = section.startsWith('floor ') ?
      run.building.floors.find((item) => item.name === section.slice(6)) : undefined;
  const walks = section === 'all_walks' ? run.walks :
      section === 'covered' ?
      shared.filter((w) => w.survey_distance_m !== null && w.survey_distance_m < 3) : shared;
  const errors = {};
  for (const method of run.methods) {
    errors[method] = walks.flatMap((walk) => errorsOf(walk, method).filter(
        (_, i) => floor === undefined || walk.waypoints[i][3] === floor.number));
    errors[method].sort((a, b) => a - b);
  }
  return errors;
}
