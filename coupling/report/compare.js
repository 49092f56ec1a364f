'use strict';
// The curves of all sources over each other; data = [{label, record}].

const facts = JSON.parse(document.getElementById('data').textContent);
const root = document.documentElement;
let points = 0;

function addOverlay(id, caption, note, x, y, hover) {
  const series = [];
  for (const source of facts) {
    const find = name => (source.record.columns.find(c => c.name === name) || {values: null}).values;
    const [xs, ys] = [find(x.column), find(y.column)];
    // Dashes from the second on: curves that agree would hide each other.
    const dash = ['', '6 4', '2 3', '9 3 2 3'][facts.indexOf(source) % 4];
    if (xs && ys && ys.some(finite)) series.push({name: source.label, x: xs, y: ys, dash});
  }
  const figure = document.getElementById(id);
  if (!series.length) { figure.classList.add('missing'); return; }
  new LineChart(figure, {caption, note, x, y, series, hover});
  for (const s of series) points += s.y.filter(finite).length;
}

const time = {label: 'time', unit: 's', column: 'time'};
const gap = {label: 'gap between the punches', unit: 'm', column: 'punch_gap'};
const force = {label: 'force', unit: 'N', column: 'upper_punch_force', fromZero: true};
addOverlay('force-gap', 'Punch force over gap', 'upper punch', gap, force, 'nearest');
addOverlay('force-time', 'Punch force over time', 'upper punch', time, force, 'column');
addOverlay('height-time', 'Height of the compact', '', time, {label: 'height', unit: 'm', column: 'compact_height'}, 'column');
addOverlay('overlap-time', 'Mean normal overlap', '', time, {label: 'overlap', unit: 'm', column: 'mean_overlap', fromZero: true}, 'column');

root.dataset.charts = chartCount;
root.dataset.points = points;
root.dataset.ready = '1';
