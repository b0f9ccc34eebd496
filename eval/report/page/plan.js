'use strict';
// One walk on its floor plan.

const ellipseScale = Math.sqrt(5.991464547);  // chi-square with two degrees of freedom, 95 %

// Index of the last pose at or before `time`, at least 0.
function poseAt(track, time) {
  let low = 0, high = track.t.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (track.t[middle] <= time) low = middle; else high = middle - 1;
  }
  return low;
}

// Position linear in time between poses, clamped at the ends.
function positionAt(track, time) {
  const i = poseAt(track, time);
  const j = Math.min(i + 1, track.t.length - 1);
  const span = track.t[j] - track.t[i];
  const u = span > 0 ? Math.min(1, Math.max(0, (time - track.t[i]) / span)) : 0;
  return [track.x[i] + u * (track.x[j] - track.x[i]), track.y[i] + u * (track.y[j] - track.y[i])];
}

function ellipse(track, i, style, now) {
  const xx = track.xx[i], xy = track.xy[i], yy = track.yy[i];
  if (xx === null || xy === null || yy === null) return null;
  const middle = (xx + yy) / 2, spread = Math.hypot((xx - yy) / 2, xy);
  const angle = 0.5 * Math.atan2(2 * xy, xx - yy) * 180 / Math.PI;
  return svgElement('ellipse', {
    class: now ? 'ellipse now' : 'ellipse', 'vector-effect': 'non-scaling-stroke',
    rx: ellipseScale * Math.sqrt(Math.max(0, middle + spread)),
    ry: ellipseScale * Math.sqrt(Math.max(0, middle - spread)),
    transform: `translate(${track.x[i]} ${track.y[i]}) rotate(${angle})`,
    style: `fill:${style.colour};stroke:${style.colour}`,
  });
}

// The building-frame rectangle to show, with a margin.
function extentOf(floor, walk, tracks, whole) {
  const xs = [], ys = [];
  const add = (x, y) => { xs.push(x); ys.push(y); };
  if (whole && floor) {
    add(...floor.min_corner_m);
    add(...floor.max_corner_m);
  }
  for (const point of walk.waypoints) if (!floor || point[3] === floor.number) add(point[1], point[2]);
  for (const track of tracks) {
    track.x.forEach((x, i) => { if (!floor || track.floor[i] === floor.number) add(x, track.y[i]); });
  }
  if (xs.length === 0) return {x: -10, y: -10, width: 20, height: 20};
  const low = [Math.min(...xs), Math.min(...ys)], high = [Math.max(...xs), Math.max(...ys)];
  const margin = whole ? 1 : 4;
  return {x: low[0] - margin, y: low[1] - margin, width: high[0] - low[0] + 2 * margin,
          height: high[1] - low[1] + 2 * margin};
}

const ringPath = (rings) => rings.map((ring) => `M${ring.map((p) => p.join(' ')).join('L')}Z`).join('');

function drawFloor(group, floor) {
  if (!floor) return;
  if (floor.image) {
    const [x0, y0] = floor.image.min_corner_m, [x1, y1] = floor.image.max_corner_m;
    // Image rows run downwards: flip back what the group flips.
    group.append(svgElement('image', {class: 'plan-image', href: floor.image.data, width: x1 - x0,
        height: y1 - y0, preserveAspectRatio: 'none', transform: `translate(${x0} ${y1}) scale(1 -1)`}));
    return;
  }
  group.append(svgElement('path', {class: 'obstacle', d: ringPath(floor.obstacles_m)}));
  const [x0, y0] = floor.min_corner_m, [x1, y1] = floor.max_corner_m;
  const box = [[[x0, y0], [x1, y0], [x1, y1], [x0, y1]]];
  group.append(svgElement('path', {class: 'outline', 'vector-effect': 'non-scaling-stroke',
      'fill-rule': 'evenodd', d: ringPath(floor.outline_m.length > 0 ? floor.outline_m : box)}));
}

function polyline(points, style, width) {
  return svgElement('path', {class: 'line', 'vector-effect': 'non-scaling-stroke', 'stroke-width': width,
      'stroke-dasharray': style.dash.join(' '), style: `stroke:${style.colour}`,
      d: points.map((p, i) => `${i > 0 ? 'L' : 'M'}${p[0]} ${p[1]}`).join('')});
}

// Runs of a track on one floor.
function stretches(track, floor) {
  const runs = [];
  let open = null;
  track.t.forEach((_, i) => {
    if (floor && track.floor[i] !== floor.number) { open = null; return; }
    if (open === null) runs.push(open = []);
    open.push([track.x[i], track.y[i]]);
  });
  return runs;
}

function drawTruth(group, walk, floor, radius) {
  const style = {colour: 'var(--ink)', dash: [2, 4]};
  const here = walk.waypoints.filter((point) => !floor || point[3] === floor.number);
  group.append(polyline(here.map((point) => [point[1], point[2]]), style, 1.5));
  for (const point of here) {
    group.append(svgElement('circle', {cx: point[1], cy: point[2], r: radius, style: 'fill:var(--ink)'},
        svgElement('title', {}, `waypoint at ${point[0].toFixed(1)} s`)));
  }
}

// Draws a method's path, 95 % ellipses about every three seconds and its place at `time`.
function drawTrack(group, track, style, view) {
  if (view.ellipses) {
    let last = -Infinity;
    track.t.forEach((t, i) => {
      if (t - last < 3 || (view.floor && track.floor[i] !== view.floor.number)) return;
      last = t;
      group.append(ellipse(track, i, style, false) ?? '');
    });
  }
  for (const points of stretches(track, view.floor)) group.append(polyline(points, style, 2.5));
  const now = poseAt(track, view.time);
  if (view.floor && track.floor[now] !== view.floor.number) return;
  if (view.ellipses) group.append(ellipse(track, now, style, true) ?? '');
  const [x, y] = positionAt(track, view.time);
  group.append(svgElement('circle', {cx: x, cy: y, r: 1.6 * view.radius,
      'vector-effect': 'non-scaling-stroke', 'stroke-width': 2,
      style: `fill:${style.colour};stroke:var(--paper)`}));
}

// A round step that divides `span` into at most `count` parts.
function roundStep(span, count) {
  const raw = span / count;
  const power = 10 ** Math.floor(Math.log10(raw));
  return power * [1, 2, 5, 10].find((factor) => factor * power >= raw);
}

function drawScale(svg, rect, metresPerPixel) {
  const length = roundStep(rect.width * metresPerPixel, 5);
  const pixels = length / metresPerPixel;
  svg.append(svgElement('path', {d: `M12 ${rect.height - 14}h${pixels}`, style: 'stroke:var(--ink)',
                                 'stroke-width': 3}),
      svgElement('text', {x: 12, y: rect.height - 22}, `${length} m`));
}

// `view`: floor (or undefined), whole, time in s, truth and ellipses (shown or not), methods.
function drawPlan(run, walk, view) {
  const svg = byId('plan');
  const rect = svg.getBoundingClientRect();
  svg.setAttribute('viewBox', `0 0 ${rect.width} ${rect.height}`);
  const tracks = view.methods.map((method) => walk.methods[method]?.track).filter(Boolean);
  const extent = extentOf(view.floor, walk, tracks, view.whole);
  const scale = Math.min(rect.width / extent.width, rect.height / extent.height);
  view.radius = 4 / scale;
  const left = (rect.width - scale * extent.width) / 2 - scale * extent.x;
  const bottom = (rect.height + scale * extent.height) / 2 + scale * extent.y;
  const group = svgElement('g', {transform: `translate(${left} ${bottom}) scale(${scale} ${-scale})`});
  drawFloor(group, view.floor);
  for (const method of view.methods) {
    const track = walk.methods[method]?.track;
    if (track && track.t.length > 0) drawTrack(group, track, styleOf(run, method), view);
  }
  if (view.truth) drawTruth(group, walk, view.floor, view.radius);
  svg.replaceChildren(group);
  drawScale(svg, rect, 1 / scale);
}
