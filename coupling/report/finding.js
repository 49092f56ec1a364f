// Puts a diagnosis' page together: measured and simulated curves of every run, and what is left over.

const facts = JSON.parse(document.getElementById('data').textContent);
const root = document.documentElement;
let points = 0;

const measuredLook = {colour: '#1d2733', look: 'points'};
const before = {name: 'simulated', colour: palette[0], dash: '6 4'};
const after = {name: facts.extended, colour: palette[1]};

function addFigure(parent, id) {
  const figure = element('figure', {class: 'card chart', id}, null, parent);
  element('figcaption', {}, null, figure);
  element('div', {class: 'plot'}, null, figure);
  return figure;
}

function addChart(parent, id, spec) {
  spec.series = spec.series.filter(s => s.y && s.y.some(finite));
  if (!spec.series.length) return;
  new FindingChart(addFigure(parent, id), spec);
  for (const s of spec.series) points += s.y.filter(finite).length;
}

/** Points small enough for a few hundred of them, and a band that may hide what it is about never. */
class FindingChart extends PointChart {
  drawSeries(svg, s) {
    if (s.look !== 'points') { super.drawSeries(svg, s); return; }
    for (let k = 0; k < s.x.length; ++k)
      if (finite(s.x[k]) && finite(s.y[k]))
        element('circle', {cx: this.px(s.x[k]).toFixed(1), cy: this.py(s.y[k]).toFixed(1), r: 2.2, fill: s.colour}, null, svg);
  }
}

const axes = {gap: {label: 'gap between the punches', unit: 'm'}, time: {label: 'time', unit: 's'}, row: {label: 'reading', unit: ''}};

/** The one of them that the curve has, by preference. */
function axisOf(curve, wanted) {
  for (const name of [...wanted, 'row'])
    if (name === 'row' || curve[name].length) return name;
}
const placesOf = (curve, axis) => axis === 'row' ? curve.measured.map((_, k) => k + 1) : curve[axis];

/** What is left of a curve, in a unit that suits it: bands do not scale themselves. */
function drawRest(parent, curve, id) {
  const over = axisOf(curve, ['time']), x = placesOf(curve, over);
  const rest = list => curve.measured.map((m, k) => finite(m) && finite(list[k]) ? m - list[k] : null);
  const [first, second] = [rest(curve.calibrated), rest(curve.extended)];
  const unit = readableUnit(curve.unit, largestOf([first, second, curve.sd]));
  const shown = list => list.map(v => finite(v) ? v / unit.factor : null);
  const allowed = shown(curve.sd).map(s => finite(s) ? 1.96 * s : null);
  addChart(parent, id, {
    caption: 'Measured less simulated', note: 'grey: what the stated errors allow (95 %)', hover: 'nearest',
    x: axes[over], y: {label: 'difference', unit: unit.text, bands: [-Infinity, Infinity]},
    series: [{name: 'allowed', x, y: x.map(() => 0), low: allowed.map(v => finite(v) ? -v : null), high: allowed, look: 'line',
              colour: '#7b8693', opacity: 0.25, width: 0.6},
             {...before, x, y: shown(first)},
             ...(curve.extended.length ? [{...after, x, y: shown(second)}] : [])]});
}

function drawCurve(parent, curve, id) {
  const over = axisOf(curve, ['gap', 'time']), x = placesOf(curve, over);
  const quantity = curve.unit === 'N' ? 'force' : curve.unit === 'Pa' ? 'pressure' : 'value';
  addChart(parent, `${id}-overlay`, {
    caption: capitalised(curve.words), note: curve.run, hover: 'nearest', x: axes[over], y: {label: quantity, unit: curve.unit},
    series: [{name: 'measured', x, y: curve.measured, ...measuredLook},
             {...before, x, y: curve.calibrated},
             ...(curve.extended.length ? [{...after, x, y: curve.extended}] : [])]});
  drawRest(parent, curve, `${id}-rest`);
}

const capitalised = text => text.charAt(0).toUpperCase() + text.slice(1);

function drawRun(parent, run, curves, number) {
  const title = element('h3', {}, run, parent);
  element('small', {}, curves[0].held_out ? 'held out: not used to calibrate or to name' : 'used to calibrate and to name', title);
  const main = element('div', {class: 'charts'}, null, parent);
  drawCurve(main, curves[0], `run-${number}-0`);
  if (curves.length < 2) return;
  const more = element('details', {class: 'run-more'}, null, parent);
  element('summary', {}, `${curves.slice(1).map(c => capitalised(c.words)).join('; ')}`, more);
  const rest = element('div', {class: 'charts'}, null, more);
  curves.slice(1).forEach((curve, k) => drawCurve(rest, curve, `run-${number}-${k + 1}`));
}

const drawn = facts.curves.filter(c => c.measured.length > 1);
const runs = [...new Set(drawn.map(c => c.run))];
runs.forEach((run, number) => drawRun(document.getElementById('runs'), run, drawn.filter(c => c.run === run), number));
document.getElementById('no-curves').hidden = runs.length > 0;

root.dataset.charts = chartCount;
root.dataset.points = points;
root.dataset.ready = '1';
