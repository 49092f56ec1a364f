'use strict';
// Line charts in SVG: they print as lines, not pixels, and a screen reader can name them. Every text is set as text,
// never as markup, because names come from a case that anybody may have written.

const palette = ['#1f5f99', '#c9561b', '#3f7f3b', '#8a4f9e', '#8a6d00', '#b03a5b', '#3a8a94', '#5b6470'];
const prefixes = [[1e9, 'G'], [1e6, 'M'], [1e3, 'k'], [1, ''], [1e-3, 'm'], [1e-6, 'µ'], [1e-9, 'n']];
const takesPrefix = new Set(['N', 'm', 'Pa', 'J', 'W', 's']);

/** The unit in which the largest of the numbers reads between 1 and 1000: {factor, text}. */
function readableUnit(unit, largest) {
  if (!takesPrefix.has(unit) || !(largest > 0)) return {factor: 1, text: unit === '1' ? '' : unit};
  const noLarge = unit === 'm' || unit === 's';  // nobody says kilometre of a press
  const [factor, prefix] = prefixes.find(([f]) => largest >= 0.9995 * f && !(noLarge && f > 1)) || prefixes.at(-1);
  return {factor, text: prefix + unit};
}

const finite = v => v !== null && Number.isFinite(v);
function largestOf(lists) {
  let largest = 0;
  for (const list of lists) for (const v of list) if (finite(v) && Math.abs(v) > largest) largest = Math.abs(v);
  return largest;
}

/** Four significant digits, without an exponent where one can read it without. */
function readable(value) {
  if (!finite(value)) return 'none';
  if (value === 0) return '0';
  const size = Math.abs(value);
  if (size < 1e-3 || size >= 1e6) return value.toExponential(2);
  return value.toPrecision(Math.max(4, Math.ceil(Math.log10(size)))).replace(/^-/, '\u2212');
}

/** Round numbers in [low, high], about `n` of them. */
function ticks(low, high, n) {
  const raw = (high - low) / n;
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = power * [1, 2, 5, 10].find(s => s * power >= raw * 0.999);
  const digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  const list = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k)
    list.push({value: k * step, text: (k * step).toFixed(digits).replace(/^-(?=.*[1-9])/, '\u2212').replace(/^-/, '')});
  return list;
}

function element(name, attributes = {}, text = null, parent = null) {
  const isSvg = ['svg', 'g', 'path', 'line', 'rect', 'text', 'circle', 'clipPath', 'defs'].includes(name);
  const node = isSvg ? document.createElementNS('http://www.w3.org/2000/svg', name) : document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
  if (text !== null) node.textContent = text;
  if (parent) parent.append(node);
  return node;
}

let chartCount = 0;

/**
 * A chart in a <figure class="chart"> with a figcaption and a .plot.
 *   spec = {caption, note, x: {label, unit}, y: {label, unit, fromZero}, hover: 'column' | 'nearest',
 *           series: [{name, x: [], y: [], dash, colour, width}], bands: [{name, from, to}], marks: [{name, y, sd}]}
 * Values are SI; the chart picks readable units. Drag to zoom, double click to see all.
 */
class LineChart {
  constructor(figure, spec) {
    this.spec = spec;
    this.id = ++chartCount;
    this.plot = figure.querySelector('.plot');
    this.wide = figure.classList.contains('wide');
    this.unitX = readableUnit(spec.x.unit, largestOf(spec.series.map(s => s.x)));
    this.unitY = readableUnit(spec.y.unit, largestOf(spec.series.map(s => s.y)));
    const scaled = (list, unit) => list.map(v => finite(v) ? v / unit.factor : null);
    this.series = spec.series.map((s, k) => ({
      ...s, x: scaled(s.x, this.unitX), y: scaled(s.y, this.unitY), colour: s.colour || palette[k % palette.length],
      dash: s.dash ?? (k >= palette.length ? '5 3' : ''), shown: true}));
    this.bands = (spec.bands || []).map(b => ({...b, from: b.from / this.unitX.factor, to: b.to / this.unitX.factor}))
        .filter(b => b.to > b.from);  // a release takes no time
    // A mark far above the curves would flatten them; it is in the table all the same.
    const reach = 2 * largestOf(this.series.map(s => s.y));
    this.marks = (spec.marks || []).map(m => ({...m, y: m.y / this.unitY.factor, sd: m.sd / this.unitY.factor}))
        .filter(m => Math.abs(m.y) <= reach);
    const caption = figure.querySelector('figcaption');
    caption.textContent = spec.caption;
    if (spec.note) element('small', {}, spec.note, caption);
    this.addLegend(figure);
    this.width = this.wide ? 1160 : 560;
    this.height = 330;
    this.frame = {left: 62, right: this.width - 10, top: 24, bottom: this.height - 44};
    this.tip = element('div', {class: 'tip', hidden: ''}, null, this.plot);
    this.zoom = null;
    this.draw();
  }

  addLegend(figure) {
    const legend = element('div', {class: 'legend'});
    figure.insertBefore(legend, this.plot);
    for (const s of this.series) {
      const button = element('button', {type: 'button', 'aria-pressed': 'true'}, null, legend);
      const swatch = element('svg', {viewBox: '0 0 22 8', 'aria-hidden': 'true'}, null, button);
      element('line', {x1: 0, x2: 22, y1: 4, y2: 4, stroke: s.colour, 'stroke-width': 2.5, 'stroke-dasharray': s.dash}, null, swatch);
      button.append(s.name);
      button.addEventListener('click', () => {
        s.shown = !s.shown;
        button.setAttribute('aria-pressed', String(s.shown));
        this.draw();
      });
    }
  }

  /** Ranges of what is shown: x first (the zoom), then y of the points inside it. */
  findRanges() {
    const shown = this.series.filter(s => s.shown);
    const span = (list, pad) => {
      let low = Infinity, high = -Infinity;
      for (const v of list) if (finite(v)) { low = Math.min(low, v); high = Math.max(high, v); }
      if (!(low <= high)) return [0, 1];
      if (low === high) { low -= Math.abs(low) / 10 || 1; high += Math.abs(high) / 10 || 1; }
      return [low - pad * (high - low), high + pad * (high - low)];
    };
    this.x = this.zoom || span(shown.flatMap(s => s.x.filter((v, k) => finite(s.y[k]))), 0);
    const inside = shown.flatMap(s => s.y.filter((v, k) => s.x[k] >= this.x[0] && s.x[k] <= this.x[1]));
    if (!this.zoom) for (const m of this.marks) inside.push(m.y + (m.sd || 0), m.y - (m.sd || 0));
    if (this.spec.y.fromZero && !this.zoom) inside.push(0);
    this.y = span(inside, 0.04);
    if (this.spec.y.fromZero && !this.zoom && inside.every(v => !finite(v) || v >= 0)) this.y[0] = 0;
  }

  px(v) { return this.frame.left + (v - this.x[0]) / (this.x[1] - this.x[0]) * (this.frame.right - this.frame.left); }
  py(v) { return this.frame.bottom - (v - this.y[0]) / (this.y[1] - this.y[0]) * (this.frame.bottom - this.frame.top); }

  ticksOf(axis, n) { return ticks(...this[axis], n); }
  /** The x under a pixel: what px() makes a pixel of. */
  valueAt(p) { return this.x[0] + (p - this.frame.left) / (this.frame.right - this.frame.left) * (this.x[1] - this.x[0]); }

  draw() {
    this.findRanges();
    const label = `${this.spec.caption}: ${this.series.map(s => s.name).join(', ')}; ${this.axisName('y')} over ${this.axisName('x')}`;
    const svg = element('svg', {viewBox: `0 0 ${this.width} ${this.height}`, role: 'img', tabindex: 0, 'aria-label': label});
    const {left, right, top, bottom} = this.frame;
    const clip = element('clipPath', {id: `clip-${this.id}`}, null, element('defs', {}, null, svg));
    element('rect', {x: left, y: top, width: right - left, height: bottom - top}, null, clip);
    this.drawBands(svg);
    this.drawAxes(svg);
    const lines = element('g', {'clip-path': `url(#clip-${this.id})`, fill: 'none'}, null, svg);
    this.drawMarks(lines);
    for (const s of this.series) if (s.shown) this.drawSeries(lines, s);
    this.cursor = element('g', {'pointer-events': 'none'}, null, svg);
    if (this.svg) this.svg.replaceWith(svg); else this.plot.prepend(svg);
    this.svg = svg;
    this.listen();
  }

  axisName(axis) {
    const unit = (axis === 'x' ? this.unitX : this.unitY).text;
    return this.spec[axis].label + (unit ? ` [${unit}]` : '');
  }

  drawBands(svg) {
    const {left, right, top, bottom} = this.frame;
    this.bands.forEach((band, k) => {
      const from = Math.max(left, this.px(band.from)), to = Math.min(right, this.px(band.to));
      if (to <= from) return;
      if (k % 2) element('rect', {x: from, y: top, width: to - from, height: bottom - top, fill: '#f2f4f7'}, null, svg);
      if (to - from > 6.5 * band.name.length)
        element('text', {x: (from + to) / 2, y: top - 7, 'text-anchor': 'middle', 'font-size': 11}, band.name, svg);
    });
  }

  drawAxes(svg) {
    const {left, right, top, bottom} = this.frame;
    for (const t of this.ticksOf('y', 5)) {
      element('line', {x1: left, x2: right, y1: this.py(t.value), y2: this.py(t.value), stroke: '#e4e8ed'}, null, svg);
      element('text', {x: left - 7, y: this.py(t.value) + 4, 'text-anchor': 'end'}, t.text, svg);
    }
    for (const t of this.ticksOf('x', this.wide ? 12 : 6)) {
      element('line', {x1: this.px(t.value), x2: this.px(t.value), y1: bottom, y2: bottom + 4, stroke: '#9aa4b0'}, null, svg);
      element('text', {x: this.px(t.value), y: bottom + 17, 'text-anchor': 'middle'}, t.text, svg);
    }
    element('line', {x1: left, x2: right, y1: bottom, y2: bottom, stroke: '#9aa4b0'}, null, svg);
    element('text', {x: (left + right) / 2, y: bottom + 36, 'text-anchor': 'middle', class: 'axis-name'}, this.axisName('x'), svg);
    element('text', {transform: `translate(14 ${(top + bottom) / 2}) rotate(-90)`, 'text-anchor': 'middle', class: 'axis-name'},
            this.axisName('y'), svg);
  }

  /** An observed value: a dashed line with a band of one standard uncertainty to either side. */
  drawMarks(svg) {
    const {left, right} = this.frame;
    for (const m of this.marks) {
      const y = this.py(m.y);
      if (finite(m.sd) && m.sd > 0)
        element('rect', {x: left, width: right - left, y: this.py(m.y + m.sd), height: this.py(m.y - m.sd) - this.py(m.y + m.sd),
                         fill: '#1d27331a'}, null, svg);
      element('line', {x1: left, x2: right, y1: y, y2: y, stroke: '#1d2733', 'stroke-dasharray': '2 3'}, null, svg);
      const above = y - 5 > this.frame.top + 12;
      element('text', {x: right - 4, y: above ? y - 5 : y + 14, 'text-anchor': 'end', 'font-size': 11}, m.name, svg);
    }
  }

  drawSeries(svg, s) {
    let path = '', pen = 'M';
    for (let k = 0; k < s.x.length; ++k) {
      if (!finite(s.x[k]) || !finite(s.y[k])) { pen = 'M'; continue; }
      path += `${pen}${this.px(s.x[k]).toFixed(1)} ${this.py(s.y[k]).toFixed(1)}`;
      pen = 'L';
    }
    element('path', {d: path, stroke: s.colour, 'stroke-width': s.width || 1.8, 'stroke-linejoin': 'round', 'stroke-dasharray': s.dash}, null, svg);
  }

  listen() {
    const at = event => {
      const box = this.svg.getBoundingClientRect();
      return [(event.clientX - box.left) * this.width / box.width, (event.clientY - box.top) * this.height / box.height];
    };
    this.svg.addEventListener('pointerdown', event => { this.dragFrom = at(event)[0]; });
    this.svg.addEventListener('pointermove', event => {
      const [x, y] = at(event);
      if (event.buttons === 1 && this.dragFrom !== undefined) this.showDrag(x);
      else this.showNearest(x, y);
    });
    this.svg.addEventListener('pointerup', event => this.endDrag(at(event)[0]));
    this.svg.addEventListener('pointerleave', () => this.hideCursor());
    this.svg.addEventListener('dblclick', () => { this.zoom = null; this.draw(); });
    this.svg.addEventListener('keydown', event => {
      const step = {ArrowLeft: -1, ArrowRight: 1}[event.key];
      if (!step) return;
      event.preventDefault();
      this.stepCursor(step);
    });
    this.svg.addEventListener('blur', () => this.hideCursor());
  }

  hideCursor() {
    this.cursor.replaceChildren();
    this.tip.hidden = true;
    this.dragFrom = undefined;
  }

  showDrag(x) {
    this.cursor.replaceChildren();
    this.tip.hidden = true;
    const {top, bottom} = this.frame;
    element('rect', {x: Math.min(x, this.dragFrom), width: Math.abs(x - this.dragFrom), y: top, height: bottom - top,
                     fill: '#1f5f9922'}, null, this.cursor);
  }

  endDrag(x) {
    const from = this.dragFrom;
    this.dragFrom = undefined;
    if (from === undefined || Math.abs(x - from) < 8) return;
    const clamp = v => Math.min(this.x[1], Math.max(this.x[0], v));
    this.zoom = [clamp(this.valueAt(Math.min(x, from))), clamp(this.valueAt(Math.max(x, from)))];
    this.tip.hidden = true;
    this.draw();
  }

  stepCursor(step) {
    const s = this.series.find(one => one.shown);
    if (!s) return;
    this.row = Math.min(s.x.length - 1, Math.max(0, (this.row ?? -1) + step));
    if (finite(s.x[this.row]) && finite(s.y[this.row])) this.showNearest(this.px(s.x[this.row]), this.py(s.y[this.row]));
  }

  /** 'column': the value of every series at the nearest x. 'nearest': the one point nearest to the pointer. */
  showNearest(x, y) {
    const isColumn = this.spec.hover !== 'nearest';
    let hits = [];
    for (const s of this.series) {
      if (!s.shown) continue;
      let best = null;
      for (let k = 0; k < s.x.length; ++k) {
        if (!finite(s.x[k]) || !finite(s.y[k])) continue;
        const distance = Math.hypot(this.px(s.x[k]) - x, isColumn ? 0 : this.py(s.y[k]) - y);
        if (!best || distance < best.distance) best = {s, k, distance};
      }
      if (best) hits.push(best);
    }
    hits.sort((a, b) => a.distance - b.distance);
    if (!isColumn) hits = hits.slice(0, 1);
    if (hits.length) this.showTip(hits); else this.hideCursor();
  }

  showTip(hits) {
    const first = hits[0], atX = this.px(first.s.x[first.k]);
    this.cursor.replaceChildren();
    this.tip.replaceChildren();
    const {top, bottom} = this.frame;
    element('line', {x1: atX, x2: atX, y1: top, y2: bottom, stroke: '#566272', 'stroke-dasharray': '2 2'}, null, this.cursor);
    element('div', {}, `${this.spec.x.label} ${readable(first.s.x[first.k])} ${this.unitX.text}`, this.tip);
    for (const {s, k} of this.series.flatMap(s => hits.filter(h => h.s === s))) {
      element('circle', {cx: this.px(s.x[k]), cy: this.py(s.y[k]), r: 4, fill: s.colour, stroke: '#fff'}, null, this.cursor);
      const row = element('div', {}, null, this.tip);
      element('i', {}, null, row).style.background = s.colour;
      row.append(`${s.name} ${readable(s.y[k])} ${this.unitY.text}`);
    }
    this.tip.hidden = false;
    const box = this.plot.getBoundingClientRect(), fraction = atX / this.width;
    const left = fraction < 0.5 ? fraction * box.width + 12 : fraction * box.width - this.tip.offsetWidth - 12;
    this.tip.style.transform = `translate(${Math.max(0, left)}px, 18px)`;
  }
}
