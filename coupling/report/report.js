'use strict';
// Puts the page together: the record's columns into charts, the grains into the picture.

const facts = JSON.parse(document.getElementById('data').textContent);
const root = document.documentElement;

const columns = new Map(facts.record.columns.map(c => [c.name, c]));
const values = name => columns.has(name) ? columns.get(name).values : null;
const hasNumbers = name => columns.has(name) && columns.get(name).values.some(finite);
/** Words that a person would use for a column's name. */
const words = name => name.replace(/_/g, ' ');

function bandsOfStages() {
  const time = values('time');
  if (!time) return [];
  return facts.record.stages.map((s, k, all) => ({
    name: words(s.name), from: k ? time[all[k - 1].last] : time[s.first], to: time[s.last]}));
}

const observedMarks = name => facts.observed.filter(o => o.name === name && finite(o.value))
    .map(o => ({name: `observed ${words(name)}${o.source ? ` (${o.source})` : ''}`, y: o.value, sd: o.sd}));

let points = 0;
function addChart(id, spec) {
  const figure = document.getElementById(id);
  spec.series = spec.series.filter(s => s.x && s.y && s.y.some(finite));
  if (!spec.series.length) { figure.classList.add('missing'); return; }
  new LineChart(figure, spec);
  for (const s of spec.series) points += s.y.filter(finite).length;
}

/** A chart of some columns over time with the stages as bands. */
function addTimeChart(id, caption, note, label, names, options = {}) {
  const present = names.filter(([column]) => hasNumbers(column));
  addChart(id, {
    caption, note, x: {label: 'time', unit: 's'},
    y: {label, unit: present.length ? columns.get(present[0][0]).unit : '', fromZero: options.fromZero ?? true},
    series: present.map(([column, name, look]) => ({name: name || words(column), x: values('time'), y: values(column), ...look})),
    bands: bandsOfStages(), marks: options.marks || []});
}

/** Force over gap falls into the way down, to the smallest gap, and the way back. */
function splitAtSmallestGap() {
  const gap = values('punch_gap'), force = values('upper_punch_force');
  if (!gap || !force) return [];
  let turn = -1;
  gap.forEach((v, k) => { if (finite(v) && (turn < 0 || v < gap[turn])) turn = k; });
  if (turn < 0) return [];
  return [{name: 'loading', x: gap.slice(0, turn + 1), y: force.slice(0, turn + 1)},
          {name: 'unloading and after', x: gap.slice(turn), y: force.slice(turn)}];
}

function drawCharts() {
  addTimeChart('force-time', 'Punch force over time', 'as Figure 4a of the paper', 'force',
               [['upper_punch_force', 'upper punch'], ['lower_punch_force', 'lower punch']], {marks: observedMarks('max_force')});
  addChart('force-gap', {
    caption: 'Punch force over gap', note: 'upper punch', x: {label: 'gap between the punches', unit: 'm'},
    y: {label: 'force', unit: 'N', fromZero: true}, series: splitAtSmallestGap(), hover: 'nearest',
    marks: observedMarks('max_force')});
  addTimeChart('height-time', 'Height of the compact, path of the punch', 'as Figure 4b', 'height',
               [['bed_height', 'between the punch faces', {colour: '#b9c3ce'}],
                ['punch_gap', 'punch as commanded', {colour: '#1d2733', dash: '8 3 2 3'}], ['compact_height', 'compact', {colour: palette[0]}]],
               {fromZero: false, marks: observedMarks('compact_height')});
  addTimeChart('overlap-time', 'Mean normal overlap', 'as Figure 4c', 'overlap', [['mean_overlap', 'mean over all contacts']]);
  addTimeChart('wall-force', 'Axial force on the die wall', '', 'force', [['wall_axial_force', 'friction and cohesion of the wall']]);
  addTimeChart('wall-pressure', 'Radial pressure on the die wall', '', 'pressure', [['wall_radial_pressure', 'mean over the wall in contact']]);
  const energies = facts.record.columns.filter(c => c.unit === 'J').map(c => [c.name, words(c.name)]);
  addTimeChart('energy', 'Energy ledger', 'every entry of the balance', 'energy', energies);
}

const colourings = {stress: ['mean stress of a grain', 'Pa'], overlap: ['mean overlap of a grain', 'm'],
                    radius: ['grain radius', 'm'], component: ['component', '']};

function drawBar(box, bar, title, si) {
  box.replaceChildren();
  if (bar.keys) {
    element('div', {class: 'title'}, title, box);
    for (const key of bar.keys) {
      const row = element('div', {class: 'key'}, null, box);
      element('i', {}, null, row).style.background = key.colour;
      row.append(key.text);
    }
    return;
  }
  const unit = readableUnit(si, Math.max(...bar.range.map(Math.abs)));
  element('div', {class: 'title'}, `${title} [${unit.text}]`, box);
  const scale = element('div', {class: 'scale'}, null, box);
  const stops = Array.from({length: 10}, (_, k) => '#' + viridisAt(k / 9).getHexString());
  element('div', {class: 'ramp'}, null, scale).style.background = `linear-gradient(to top, ${stops.join(',')})`;
  const [low, high] = bar.range.map(v => v / unit.factor);
  for (const t of ticks(low, high, 5))
    element('span', {}, t.text, scale).style.bottom = `${100 * (t.value - low) / (high - low)}%`;
}

function describeGrain(view, g) {
  const show = (name, label) => {
    const unit = readableUnit(colourings[name][1], Math.abs(view.values[name][g]));
    return `${label} ${readable(view.values[name][g] / unit.factor)} ${unit.text}`;
  };
  return [facts.components[view.component[g]] || 'grain', show('radius', 'radius'), show('overlap', 'mean overlap'),
          show('stress', 'stress')].join(', ');
}

function connectKeys(view) {
  const canvas = view.canvas;
  canvas.addEventListener('keydown', event => {
    const act = {ArrowLeft: () => view.turn(-0.1, 0), ArrowRight: () => view.turn(0.1, 0), ArrowUp: () => view.turn(0, 0.1),
                 ArrowDown: () => view.turn(0, -0.1), '+': () => view.zoom(0.9), '-': () => view.zoom(1 / 0.9)}[event.key];
    if (!act) return;
    event.preventDefault();
    act();
  });
  canvas.addEventListener('focus', () => { view.controls.enableZoom = true; });
  canvas.addEventListener('blur', () => { view.controls.enableZoom = false; });
}

function connectControls(view) {
  const find = id => document.getElementById('compact-' + id);
  const canvas = view.canvas, note = find('note');
  const colour = () => drawBar(find('bar'), view.colourBy(find('colour').value), ...colourings[find('colour').value]);
  const cut = () => {
    view.cut(find('axis').value, find('cut').value / 100);
    find('cut').setAttribute('aria-valuetext', `${find('cut').value} per cent`);
  };
  find('colour').addEventListener('change', colour);
  find('axis').addEventListener('change', cut);
  find('cut').addEventListener('input', cut);
  find('tools').addEventListener('change', event => { view.tools.visible = event.target.checked; view.render(); });
  find('reset').addEventListener('click', () => {
    find('cut').value = 0;
    note.textContent = '';
    cut();
    view.reset();
  });
  connectKeys(view);
  canvas.addEventListener('pointerdown', event => { canvas.focus(); view.pressedAt = [event.clientX, event.clientY]; });
  canvas.addEventListener('pointerup', event => {
    const [x, y] = view.pressedAt || [NaN, NaN];
    if (!(Math.hypot(event.clientX - x, event.clientY - y) < 4)) return;
    const box = canvas.getBoundingClientRect();
    const g = view.grainAt((event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height);
    note.textContent = g < 0 ? '' : describeGrain(view, g);
  });
  colour();
}

function drawCompact() {
  const note = document.getElementById('compact-note');
  if (!facts.grains.shown) { note.textContent = 'This run kept no grains to show.'; return null; }
  try {
    const view = new CompactView(document.getElementById('compact-canvas'), facts);
    connectControls(view);
    if (facts.grains.shown < facts.grains.of) note.textContent = `${facts.grains.shown} of ${facts.grains.of} grains are drawn.`;
    root.dataset.grains = view.n;
    return view;
  } catch (problem) {
    note.textContent = problem.message;
    return null;
  }
}

/** The tools at the largest force, cut open. */
function drawStressedTools() {
  if (!facts.stressed) return null;
  try {
    const view = new StressedView(document.getElementById('tools-canvas'), facts.stressed);
    connectKeys(view);
    view.canvas.addEventListener('pointerdown', () => view.canvas.focus());
    drawBar(document.getElementById('tools-bar'), view.bar, 'von Mises stress', 'Pa');
    root.dataset.stressed = view.triangles;
    return view;
  } catch (problem) {
    document.getElementById('tools-note').textContent = problem.message;
    return null;
  }
}

drawCharts();
const stressedView = drawStressedTools();
const compactView = drawCompact();
root.dataset.charts = chartCount;
root.dataset.points = points;
root.dataset.ready = '1';
