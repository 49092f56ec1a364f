// Puts the study's page together.

const facts = JSON.parse(document.getElementById('data').textContent);
const root = document.documentElement;
const byId = id => document.getElementById(id);
let points = 0;

function addFigure(parent, id, wide) {
  const figure = element('figure', {class: `card chart${wide ? ' wide' : ''}`, id});
  parent.insertBefore(figure, parent.querySelector(':scope > .tables'));
  element('figcaption', {}, null, figure);
  element('div', {class: 'plot'}, null, figure);
  return figure;
}

function addChart(Chart, parent, id, spec, wide) {
  spec.series = spec.series.filter(s => s.x && s.y && s.y.some(finite));
  if (!parent || !spec.series.length) return;
  new Chart(addFigure(parent, id, wide), spec);
  for (const s of spec.series) points += s.y.filter(finite).length;
}

// --- response surfaces -------------------------------------------------------------------------------------------

function drawSurfaces(response, k, parent) {
  for (const grid of response.grids) {
    const [first, second] = [facts.factors[grid.first], facts.factors[grid.second]];
    const others = facts.factors.filter(f => f !== first && f !== second).map(f => `${f.name} = ${shortValue(f.centre)} ${f.unit}`);
    new SurfacePlot(addFigure(parent, `surface-${k}-${grid.first}-${grid.second}`), {
      caption: `${response.name} over ${first.name} and ${second.name}`, note: others.length ? `at ${others.join(', ')}` : '',
      response, grid, first, second, calibration: facts.calibration});
  }
  if (!response.line) return;
  const l = response.line, f = facts.factors[0];
  addChart(PointChart, parent, `line-${k}`, {
    caption: `${response.name} over ${f.name}`, note: 'the surface, its 95 % confidence band and the prediction band of a run',
    x: {label: f.name, unit: f.unit}, y: {label: response.name, unit: response.unit, bands: [-Infinity, Infinity]}, hover: 'nearest',
    marks: response.target === null ? [] : [{name: 'target', y: response.target, sd: response.sd}],
    series: [{name: 'prediction of a run', x: l.x, y: l.y, low: l.run_low, high: l.run_high, look: 'line', colour: '#8fa3b8', opacity: 0.16, width: 0.1},
             {name: 'surface', x: l.x, y: l.y, low: l.mean_low, high: l.mean_high, look: 'line', colour: palette[0], opacity: 0.16},
             {name: 'runs', x: response.runs.map(r => r.at[0]), y: response.runs.map(r => r.value), look: 'points', colour: '#1d2733'}]});
}

function drawPredicted(response, k, parent) {
  const from = runs => ({x: runs.map(r => r.foretold), y: runs.map(r => r.value), low: runs.map(r => r.low), high: runs.map(r => r.high)});
  const all = [...response.runs, ...response.validation].flatMap(r => [r.foretold, r.value]).filter(finite);
  const ends = [Math.min(...all), Math.max(...all)];
  addChart(PointChart, parent, `predicted-${k}`, {
    caption: 'Observed against predicted', note: 'bars: 95 % prediction interval',
    x: {label: `${response.name} predicted`, unit: response.unit}, y: {label: `${response.name} observed`, unit: response.unit}, hover: 'nearest',
    series: [{name: 'equal', x: ends, y: ends, colour: '#9aa4b0', dash: '5 3'},
             {name: 'runs', ...from(response.runs), look: 'points', colour: palette[0]},
             {name: 'validation runs', ...from(response.validation), look: 'hollow', colour: palette[1]}]});
}

function drawResponses() {
  facts.responses.forEach((response, k) => {
    const parent = byId(`surface-${k}`);
    drawSurfaces(response, k, parent);
    drawPredicted(response, k, parent);
    drawEffects(addFigure(parent, `effects-${k}`), 'Effects', response.unit, response.coefficients);
  });
}

// --- calibration -------------------------------------------------------------------------------------------------

/** The joint region alone, on its own scale: in the surfaces it is often a dot. */
function drawRegions() {
  const parent = byId('calibration-plots');
  if (!parent || !facts.calibration) return;
  for (const region of facts.calibration.regions.filter(r => r.lines.length)) {
    const [first, second] = [facts.factors[region.first], facts.factors[region.second]];
    const [a, b] = [facts.calibration.factors[region.first], facts.calibration.factors[region.second]];
    const power = powerOf(second);
    addChart(PointChart, parent, `region-${region.first}-${region.second}`, {
      caption: `Joint 95 % region of ${first.name} and ${second.name}`, note: 'enlarged; a line that stays open meets a bound', hover: 'nearest',
      x: {label: first.name, unit: first.unit}, y: {label: factorName(second, power), unit: ''},
      series: [...region.lines.map((line, k) => ({name: k ? `border, part ${k + 1}` : 'border of the region', x: line.map(p => p[0]),
                                                  y: line.map(p => p[1] / power), colour: '#111'})),
               {name: 'calibrated, 95 % interval of each alone', x: [a.low, a.high, null, a.value, a.value],
                y: [b.value / power, b.value / power, null, b.low / power, b.high / power], colour: palette[1]},
               {name: 'best', x: [a.value], y: [b.value / power], look: 'points', colour: palette[1]}]});
  }
}

// --- figure 6 ----------------------------------------------------------------------------------------------------

function drawTrends() {
  facts.trends.forEach((trend, k) => {
    const inner = [...trend.values, ...trend.forms.flatMap(f => f.y), trend.observed].filter(finite);
    const [low, high] = [Math.min(...inner), Math.max(...inner)], room = 0.35 * (high - low || 1);
    const shown = trend.forms.map((f, j) => ({name: f.name, x: f.x, y: f.y, low: f.low, high: f.high, look: 'line', colour: palette[j],
                                             opacity: 0.09}));
    addChart(PointChart, byId(`trend-${k}`), `trend-plot-${k}`, {
      caption: `${trend.response} against ${trend.factor}`, note: 'as figure 6a of the paper; bands: 95 % prediction intervals, each if its form were true',
      x: {label: trend.factor, unit: trend.factor_unit}, y: {label: trend.response, unit: trend.unit, bands: [low - room, high + room]}, hover: 'nearest',
      marks: trend.observed === null ? [] : [{name: 'measured', y: trend.observed, sd: null}],
      series: [...shown, {name: 'runs', x: trend.sizes, y: trend.values, look: 'points', colour: '#1d2733'}]}, true);
  });
}

function drawCost() {
  const c = facts.cost;
  if (!c) return;
  addChart(PointChart, byId('cost-plot'), 'cost-chart', {
    caption: `Processor time against ${c.factor}`, note: 'as figure 6b of the paper', hover: 'nearest',
    x: {label: c.factor, unit: c.unit, log: true}, y: {label: 'time of one processor', unit: 'h', log: true},
    series: [{name: 'power law, 95 % prediction of a run', x: c.x, y: c.y, low: c.low, high: c.high, look: 'line', colour: palette[0]},
             {name: 'runs', x: c.sizes, y: c.hours, look: 'points', colour: '#1d2733'},
             {name: 'foretold', x: c.at, y: c.foretold, low: c.foretold_low, high: c.foretold_high, look: 'hollow', colour: palette[1]}]}, true);
}

// --- figures 4 and 5 ---------------------------------------------------------------------------------------------

const dashes = ['', '7 3', '2 3', '9 3 2 3', '4 2 1 2'];

/** Few set-ups: a colour each. More: a colour for each level of the first factor, a dash for each of the second. */
function looksOf(setups) {
  if (setups.length <= palette.length) return setups.map((s, k) => ({colour: palette[k], dash: ''}));
  const levels = f => [...new Set(setups.map(s => s.factors[f]))].sort((a, b) => a - b);
  const [first, second] = [levels(0), levels(1)];
  return setups.map((s, k) => s.validation ? {colour: '#1d2733', dash: ''} : {
    colour: palette[(first.length > 1 ? first.indexOf(s.factors[0]) : k) % palette.length],
    dash: dashes[(second.length > 1 ? second.indexOf(s.factors[1]) : Math.floor(k / palette.length)) % dashes.length]});
}

/** Replicates of a set-up are one series with gaps, so that a legend of a large study can be read. */
function seriesOf(column) {
  const setups = new Map();
  for (const run of facts.curves.runs) {
    if (!run[column]) continue;
    if (!setups.has(run.setup)) setups.set(run.setup, {name: run.setup, factors: run.factors, validation: run.validation, x: [], y: [], width: 1.2});
    const one = setups.get(run.setup);
    if (one.x.length) { one.x.push(null); one.y.push(null); }
    one.x.push(...run.time);
    one.y.push(...run[column]);
  }
  const all = [...setups.values()], looks = looksOf(all);
  return all.map((s, k) => ({...s, ...looks[k]}));
}

function drawCurves() {
  const {runs, stages} = facts.curves;
  byId('no-curves').hidden = runs.length > 0;
  if (!runs.length) return;
  const time = {label: 'time', unit: 's'}, bands = stages.map(s => ({...s, name: s.name.replace(/_/g, ' ')}));
  const add = (id, column, caption, note, label, unit, more = []) => addChart(LineChart, byId('run-curves'), id, {
    caption, note, x: time, y: {label, unit, fromZero: column !== 'compact_height'}, bands, hover: 'nearest', series: [...seriesOf(column), ...more]}, true);
  const punch = runs.find(r => r.punch_gap);
  add('force-time', 'upper_punch_force', 'Punch force', 'figure 4a; drag to zoom, double click to see all', 'force', 'N');
  add('height-time', 'compact_height', 'Height of the compact', 'figure 4b', 'height', 'm',
      punch ? [{name: 'punch', x: punch.time, y: punch.punch_gap, colour: '#1d2733', dash: '8 3 2 3', width: 1.4}] : []);
  add('overlap-time', 'mean_overlap', 'Mean normal overlap', 'figure 4c', 'overlap', 'm');
}

const grainColours = [[214, 199, 168], [120, 150, 190], [170, 190, 140], [200, 150, 150]];

function pictureOf(pixels, width, height) {
  const canvas = document.createElement('canvas');
  canvas.width = width;
  canvas.height = height;
  const pen = canvas.getContext('2d'), picture = pen.createImageData(width, height);
  for (let k = 0; k < pixels.length; ++k) {
    const code = pixels.charCodeAt(k);
    if (!code) continue;
    const light = 0.35 + 0.65 * ((code & 63) - 1) / 62;
    picture.data.set([...grainColours[code >> 6].map(c => Math.round(c * light)), 255], 4 * k);
  }
  pen.putImageData(picture, 0, 0);
  return canvas.toDataURL();
}

function drawShapes() {
  const {runs, width, height, metres} = facts.shapes;
  byId('no-shapes').hidden = runs.length > 0;
  const quality = facts.responses.find(r => r.quantity === 'shape_quality');
  for (const run of runs) {
    const figure = element('figure', {}, null, byId('shapes'));
    const value = quality && [...quality.runs, ...quality.validation].find(r => r.run === run.run);
    const words = run.run + (value && finite(value.value) ? `, ${quality.name} ${value.value}` : '');
    element('img', {src: pictureOf(atob(run.pixels), width, height), alt: `The grains of ${run.run} at the end, from the front`}, null, figure);
    element('figcaption', {}, words, figure);
  }
  if (runs.length) element('p', {class: 'quiet'}, `A picture is ${(1e3 * metres).toFixed(1)} mm wide.`, byId('final-shapes'));
  root.dataset.shapes = runs.length;
}

drawResponses();
drawRegions();
drawTrends();
drawCost();
drawCurves();
drawShapes();
root.dataset.charts = chartCount;
root.dataset.points = points;
root.dataset.ready = '1';
