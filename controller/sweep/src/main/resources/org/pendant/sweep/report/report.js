'use strict';
// Plots of a table of results. Everything is SVG; nothing is loaded from anywhere.
const data = JSON.parse(document.getElementById('data').textContent);
const columns = data.columns;
const rows = data.rows;
const place = name => columns.findIndex(each => each.name === name);
const numbers = columns.map((each, i) => i).filter(i => columns[i].number);
const parameters = numbers.filter(i => columns[i].parameter);
const ended = row => row[place('outcome')] === 'finished' || row[place('outcome')] === 'halted';
const brushes = new Map();
const passes = row => [...brushes].every(([i, [low, high]]) => row[i] !== null && row[i] >= low && row[i] <= high);

function node(name, attributes, parent) {
  const made = document.createElementNS('http://www.w3.org/2000/svg', name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  if (parent) parent.appendChild(made);
  return made;
}
function label(parent, x, y, text, anchor = 'middle', kind = '') {
  node('text', {x, y, 'text-anchor': anchor, class: kind}, parent).textContent = text;
}
function canvas(id, width, height) {
  const box = document.getElementById(id);
  box.replaceChildren();
  return node('svg', {viewBox: `0 0 ${width} ${height}`, role: 'img'}, box);
}
function range(i, among = rows) {
  let low = Infinity, high = -Infinity;
  for (const row of among) if (row[i] !== null) { low = Math.min(low, row[i]); high = Math.max(high, row[i]); }
  if (low > high) return [0, 1];
  return low === high ? [low - 0.5, high + 0.5] : [low, high];
}
const shown = value => value === null ? '' : Math.abs(value) >= 1e5 || (value !== 0 && Math.abs(value) < 1e-3)
  ? value.toExponential(2) : String(Number(value.toPrecision(4)));
const title = i => columns[i].name + (columns[i].unit ? ' (' + columns[i].unit + ')' : '');
const scale = ([low, high], from, to) => value => from + (value - low) / (high - low) * (to - from);
// viridis in eight steps
const STEPS = ['#440154', '#46327e', '#365c8d', '#277f8e', '#1fa187', '#4ac16d', '#a0da39', '#fde725'];
function colour(share) {
  const at = Math.max(0, Math.min(1, share)) * (STEPS.length - 1), i = Math.min(STEPS.length - 2, Math.floor(at));
  const mix = (a, b) => Math.round(parseInt(a, 16) + (parseInt(b, 16) - parseInt(a, 16)) * (at - i));
  return 'rgb(' + [1, 3, 5].map(k => mix(STEPS[i].slice(k, k + 2), STEPS[i + 1].slice(k, k + 2))).join(',') + ')';
}
function about(row) {
  return `run ${row[0]}: ${row[place('outcome')]}` + (row[place('reason')] ? ', ' + row[place('reason')] : '')
    + '\n' + [...parameters, place('duration')].map(i => `${columns[i].name} ${shown(row[i])}`).join(', ');
}
function tip(mark, row) { node('title', {}, mark).textContent = about(row); return mark; }

function choice(id, among, first) {
  const select = document.getElementById(id);
  for (const i of among) select.add(new Option(title(i), i, i === first, i === first));
  select.addEventListener('change', draw);
  return () => Number(select.value);
}
const standard = name => place(name) >= 0 ? place(name) : numbers[0];
const first = parameters[0] ?? numbers[0], second = parameters[1] ?? first;
const tint = choice('tint', numbers, standard('duration'));
const heatX = choice('heat-x', numbers, first), heatY = choice('heat-y', numbers, second), heatOf = choice('heat-of', numbers, standard('duration'));
const bars = choice('bars', numbers, standard('duration'));
const lessX = choice('less-x', numbers, standard('duration')), lessY = choice('less-y', numbers, standard('torque_share'));
const mapX = choice('map-x', numbers, standard('end_x')), mapY = choice('map-y', numbers, standard('end_y')), mapZ = choice('map-z', numbers, standard('end_z'));
let turned = 0.6, raised = 0.5, sorted = 0, upwards = true;

function parallel() {
  const axes = [...parameters, ...['duration', 'torque_share', 'speed_share', 'singularity', 'energy'].map(place).filter(i => i >= 0)];
  const width = 1160, height = 330, top = 40, bottom = height - 25;
  const svg = canvas('parallel', width, height);
  const x = k => axes.length < 2 ? width / 2 : 60 + k * (width - 120) / (axes.length - 1);
  const scales = axes.map(i => scale(range(i), bottom, top));
  const inks = scale(range(tint(), rows.filter(ended)), 0, 1);
  for (const row of rows) {
    let path = '', pen = 'M';
    axes.forEach((i, k) => { if (row[i] !== null) { path += `${pen}${x(k).toFixed(1)} ${scales[k](row[i]).toFixed(1)}`; pen = 'L'; } });
    if (!path) continue;
    const bad = !ended(row);
    const line = node('path', {d: path, class: 'row' + (bad ? ' bad' : '') + (passes(row) ? '' : ' faded')}, svg);
    if (!bad && row[tint()] !== null) line.setAttribute('stroke', colour(inks(row[tint()])));
    tip(line, row);
  }
  axes.forEach((i, k) => {
    const [low, high] = range(i);
    node('line', {x1: x(k), x2: x(k), y1: top, y2: bottom, class: 'axis'}, svg);
    label(svg, x(k), 14, title(i), 'middle', 'name');
    label(svg, x(k), 32, shown(high));
    label(svg, x(k), height - 8, shown(low));
    const brush = brushes.get(i);
    if (brush) node('rect', {x: x(k) - 8, width: 16, y: scales[k](brush[1]), height: Math.max(1, scales[k](brush[0]) - scales[k](brush[1])), class: 'brush'}, svg);
    const zone = node('rect', {x: x(k) - 14, width: 28, y: top, height: bottom - top, class: 'zone'}, svg);
    zone.addEventListener('pointerdown', event => {
      const value = at => low + (bottom - Math.max(top, Math.min(bottom, at))) / (bottom - top) * (high - low);
      const y = e => (e.clientY - svg.getBoundingClientRect().top) * height / svg.getBoundingClientRect().height;
      const from = y(event);
      window.addEventListener('pointerup', up => {
        const to = y(up);
        if (Math.abs(to - from) < 4) brushes.delete(i);
        else brushes.set(i, [value(from), value(to)].sort((a, b) => a - b));
        draw();
      }, {once: true});
    });
  });
}

function frame(svg, width, height, i, j, xs, ys) {
  node('rect', {x: 60, y: 12, width: width - 80, height: height - 57, class: 'frame'}, svg);
  label(svg, (width + 40) / 2, height - 6, title(i), 'middle', 'name');
  label(svg, 60, height - 28, shown(xs[0]), 'start');
  label(svg, width - 20, height - 28, shown(xs[1]), 'end');
  label(svg, 54, height - 46, shown(ys[0]), 'end');
  label(svg, 54, 24, shown(ys[1]), 'end');
  const name = node('text', {transform: `translate(16 ${height / 2}) rotate(-90)`, 'text-anchor': 'middle', class: 'name'}, svg);
  name.textContent = j;
}

function heat() {
  const width = 560, height = 400, i = heatX(), j = heatY(), of = heatOf();
  const svg = canvas('heat', width, height);
  const xs = range(i), ys = range(j);
  const count = k => Math.min(24, Math.max(1, new Set(rows.map(row => row[k])).size));
  const nx = count(i), ny = count(j);
  const cells = new Map();
  for (const row of rows) {
    if (row[i] === null || row[j] === null || !passes(row)) continue;
    const cx = Math.min(nx - 1, Math.floor((row[i] - xs[0]) / (xs[1] - xs[0]) * nx));
    const cy = Math.min(ny - 1, Math.floor((row[j] - ys[0]) / (ys[1] - ys[0]) * ny));
    const cell = cells.get(cy * nx + cx) ?? {sum: 0, count: 0, bad: 0, all: 0};
    cell.all++;
    if (!ended(row)) cell.bad++;
    else if (row[of] !== null) { cell.sum += row[of]; cell.count++; }
    cells.set(cy * nx + cx, cell);
  }
  const means = [...cells.values()].filter(c => c.count).map(c => c.sum / c.count);
  const low = Math.min(...means), high = Math.max(...means);
  const w = (width - 80) / nx, h = (height - 57) / ny;
  for (const [key, cell] of cells) {
    const cx = key % nx, cy = Math.floor(key / nx);
    const mean = cell.count ? cell.sum / cell.count : null;
    const box = {x: 60 + cx * w, y: height - 45 - (cy + 1) * h, width: w + 0.5, height: h + 0.5};
    const mark = node('rect', {...box, fill: mean === null ? 'var(--bad)' : colour(high > low ? (mean - low) / (high - low) : 0.5)}, svg);
    node('title', {}, mark).textContent = `${cell.all} runs, ${cell.bad} did not end` + (mean === null ? '' : `, mean ${columns[of].name} ${shown(mean)}`);
    if (cell.bad && mean !== null) {
      const size = Math.sqrt(cell.bad / cell.all);
      node('rect', {x: box.x, y: box.y + h * (1 - size), width: w * size, height: h * size, fill: 'var(--bad)'}, svg);
    }
  }
  frame(svg, width, height, i, title(j), xs, ys);
  document.getElementById('heat-range').textContent = means.length ? `mean ${title(of)}: ${shown(low)} (dark) to ${shown(high)} (light); red: runs that did not end` : 'red: runs that did not end';
}

function histogram() {
  const width = 560, height = 400, i = bars(), count = 30;
  const svg = canvas('histogram', width, height);
  const [low, high] = range(i);
  const good = new Array(count).fill(0), bad = new Array(count).fill(0);
  for (const row of rows) if (row[i] !== null && passes(row)) (ended(row) ? good : bad)[Math.min(count - 1, Math.floor((row[i] - low) / (high - low) * count))]++;
  const most = Math.max(1, ...good.map((each, k) => each + bad[k])), w = (width - 80) / count, unit = (height - 57) / most;
  for (let k = 0; k < count; k++) {
    const x = 60 + k * w + 0.5, base = height - 45;
    const bar = node('rect', {x, y: base - good[k] * unit, width: w - 1, height: good[k] * unit, class: 'bar'}, svg);
    node('title', {}, bar).textContent = `${shown(low + k * (high - low) / count)} to ${shown(low + (k + 1) * (high - low) / count)}: ${good[k]} runs, ${bad[k]} more did not end`;
    node('rect', {x, y: base - (good[k] + bad[k]) * unit, width: w - 1, height: bad[k] * unit, fill: 'var(--bad)'}, svg);
  }
  frame(svg, width, height, i, 'runs', [low, high], [0, most]);
}

function pareto() {
  const width = 560, height = 400, i = lessX(), j = lessY();
  const svg = canvas('pareto', width, height);
  const there = rows.filter(row => ended(row) && row[i] !== null && row[j] !== null && passes(row));
  const xs = range(i, there), ys = range(j, there);
  const x = scale(xs, 60, width - 20), y = scale(ys, height - 45, 12), inks = scale(range(tint(), rows.filter(ended)), 0, 1);
  for (const row of there) tip(node('circle', {cx: x(row[i]), cy: y(row[j]), r: 3, fill: row[tint()] === null ? 'var(--dim)' : colour(inks(row[tint()]))}, svg), row);
  let best = Infinity, path = '';
  const front = [...there].sort((a, b) => a[i] - b[i] || a[j] - b[j]).filter(row => row[j] < best && ((best = row[j]), true));
  front.forEach((row, k) => { path += (k ? `L${x(row[i])} ${y(front[k - 1][j])}L` : 'M') + `${x(row[i])} ${y(row[j])}`; });
  if (path) node('path', {d: path, class: 'front'}, svg);
  frame(svg, width, height, i, title(j), xs, ys);
  document.getElementById('front').textContent = 'No other run is better in both: ' + (front.slice(0, 12).map(row => 'run ' + row[0]).join(', ') || 'none') + (front.length > 12 ? ', ...' : '');
}

function reach() {
  const width = 560, height = 400, axes = [mapX(), mapY(), mapZ()];
  const svg = canvas('reach', width, height);
  svg.classList.add('turn');
  const ranges = axes.map(i => range(i)), size = Math.max(...ranges.map(([low, high]) => high - low));
  const middle = ranges.map(([low, high]) => (low + high) / 2);
  const project = ([a, b, c]) => {
    const u = a * Math.cos(turned) - b * Math.sin(turned), v = a * Math.sin(turned) + b * Math.cos(turned);
    return [width / 2 + u * 300, height / 2 + (v * Math.sin(raised) - c * Math.cos(raised)) * 300, v * Math.cos(raised) + c * Math.sin(raised)];
  };
  const corner = k => project(ranges.map(([low, high], a) => ((k >> a & 1 ? high : low) - middle[a]) / size));
  for (let k = 0; k < 8; k++) for (let a = 0; a < 3; a++) if (!(k >> a & 1)) {
    const [x1, y1] = corner(k), [x2, y2] = corner(k | 1 << a);
    node('line', {x1, y1, x2, y2, class: 'axis'}, svg);
    if (k === 0) label(svg, (x1 + x2) / 2, (y1 + y2) / 2, title(axes[a]), 'middle', 'name');
  }
  const inks = scale(range(tint(), rows.filter(ended)), 0, 1);
  rows.filter(row => axes.every(i => row[i] !== null) && passes(row))
    .map(row => ({row, at: project(axes.map((i, a) => (row[i] - middle[a]) / size))}))
    .sort((one, other) => one.at[2] - other.at[2])
    .forEach(({row, at}) => {
      const mark = node('circle', {cx: at[0], cy: at[1], r: 3.5, class: ended(row) ? '' : 'bad'}, svg);
      if (ended(row) && row[tint()] !== null) mark.setAttribute('fill', colour(inks(row[tint()])));
      tip(mark, row);
    });
}
document.getElementById('reach').addEventListener('pointermove', event => {
  if (!event.buttons) return;
  turned += event.movementX * 0.01;
  raised = Math.max(-1.5, Math.min(1.5, raised + event.movementY * 0.01));
  reach();
});

function table() {
  const shownColumns = [0, ...columns.map((each, i) => i).filter(i => columns[i].parameter), place('outcome'), place('line'),
    ...['duration', 'torque_share', 'speed_share', 'singularity', 'plane', 'force', 'energy'].map(place).filter(i => i >= 0), place('reason')];
  const head = document.createElement('tr'), body = document.createElement('tbody');
  const cell = (row, kind, text, number) => { const made = document.createElement(kind); made.textContent = text; if (!number) made.className = 'text'; row.appendChild(made); return made; };
  for (const i of shownColumns) {
    const made = cell(head, 'th', title(i) + (i === sorted ? (upwards ? ' ▲' : ' ▼') : ''), columns[i].number);
    made.title = columns[i].description;
    made.addEventListener('click', () => { upwards = i === sorted ? !upwards : true; sorted = i; table(); });
  }
  cell(head, 'th', 'look at it', false);
  const order = (a, b) => a === b ? 0 : a === null ? 1 : b === null ? -1 : a < b ? -1 : 1;
  const all = rows.filter(passes).sort((a, b) => order(a[sorted], b[sorted]) * (upwards ? 1 : -1));
  for (const row of all.slice(0, 500)) {
    const line = body.appendChild(document.createElement('tr'));
    for (const i of shownColumns) cell(line, 'td', columns[i].number ? shown(row[i]) : row[i], columns[i].number);
    const command = document.createElement('code');
    command.textContent = data.kept.includes(row[0]) ? `pendant open ${data.folder}/kept/${row[0]}.rec` : `pendant sweep open ${data.folder} ${row[0]}`;
    cell(line, 'td', '', false).appendChild(command);
  }
  const made = document.createElement('table');
  made.createTHead().appendChild(head);
  made.appendChild(body);
  document.getElementById('table').replaceChildren(made);
  document.getElementById('count').textContent = `${all.length} of ${rows.length} runs pass the ranges` + (all.length > 500 ? '; the first 500 are shown' : '');
}
function draw() { parallel(); heat(); histogram(); pareto(); reach(); table(); }
draw();
