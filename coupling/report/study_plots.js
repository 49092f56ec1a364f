// Plots of a study beside plain lines: points with error bars, bands, logarithmic axes, intervals of coefficients.

/** Round numbers on a logarithmic axis: decades; 1, 2, 5 where they are few. */
function logTicks(low, high) {
  const list = [];
  const decades = Math.log10(high / low), digits = decades > 3 ? [1] : decades > 0.8 ? [1, 2, 5] : [1, 1.5, 2, 3, 4, 5, 6, 7, 8, 9];
  for (let power = Math.floor(Math.log10(low)); power <= Math.log10(high); ++power)
    for (const digit of digits) {
      const value = digit * 10 ** power;
      if (value >= low * 0.9999 && value <= high * 1.0001) list.push({value, text: value >= 1e4 ? value.toExponential().replace('+', '') : String(+value.toPrecision(2))});
    }
  return list;
}

/**
 * A LineChart whose series may also be points or bands, on axes that may be logarithmic:
 *   series: [{..., look: 'line' | 'points' | 'hollow', low: [], high: []}]; a line with low and high has a band, points have bars
 *   x, y: {..., log: true}; y: {bands: [low, high]}: how far the axis follows them
 */
class PointChart extends LineChart {
  isLog(axis) { return this.spec[axis].log; }
  ticksOf(axis, n) { return this.isLog(axis) ? logTicks(...this[axis]) : super.ticksOf(axis, n); }

  findRanges() {
    super.findRanges();
    for (const axis of ['x', 'y']) {
      if (axis === 'x' && this.zoom) continue;
      const values = this.series.filter(s => s.shown).flatMap(s => [
        ...s[axis], ...(axis === 'y' && s.look && s.look !== 'line' ? [...(s.low || []), ...(s.high || [])] : [])]);
      if (axis === 'y') values.push(...this.marks.flatMap(m => [m.y]));
      const good = values.filter(v => finite(v) && (!this.isLog(axis) || v > 0));
      if (!good.length) continue;
      let low = Math.min(...good), high = Math.max(...good);
      if (this.isLog(axis)) { this[axis] = [low / 1.15, high * 1.15]; continue; }
      const pad = 0.05 * (high - low || Math.abs(high) || 1);
      this[axis] = [low - pad, high + pad];
    }
    const bands = this.spec.y.bands;  // bands may ask for so much, and no more
    if (bands && !this.zoom) {
      const asked = this.series.filter(s => s.shown && s.look === 'line').flatMap(s => [...s.low, ...s.high]).filter(finite);
      this.y = [Math.min(this.y[0], Math.max(bands[0], Math.min(...asked))), Math.max(this.y[1], Math.min(bands[1], Math.max(...asked)))];
    }
  }

  share(axis, v) {
    const [low, high] = this[axis];
    return this.isLog(axis) ? Math.log(v / low) / Math.log(high / low) : (v - low) / (high - low);
  }
  px(v) { return this.frame.left + this.share('x', v) * (this.frame.right - this.frame.left); }
  py(v) { return this.frame.bottom - this.share('y', v) * (this.frame.bottom - this.frame.top); }
  valueAt(p) {
    if (!this.isLog('x')) return super.valueAt(p);
    return this.x[0] * (this.x[1] / this.x[0]) ** ((p - this.frame.left) / (this.frame.right - this.frame.left));
  }

  drawSeries(svg, s) {
    if (!s.look || s.look === 'line') {
      if (s.low) this.drawBand(svg, s);
      super.drawSeries(svg, s);
      return;
    }
    for (let k = 0; k < s.x.length; ++k) {
      if (!finite(s.x[k]) || !finite(s.y[k])) continue;
      const x = this.px(s.x[k]);
      if (s.low && finite(s.low[k]) && finite(s.high[k]))
        element('path', {d: `M${x} ${this.py(s.low[k])}V${this.py(s.high[k])}`, stroke: s.colour, 'stroke-width': 1.2,
                         'stroke-opacity': 0.55}, null, svg);
      element('circle', {cx: x, cy: this.py(s.y[k]), r: 4, fill: s.look === 'hollow' ? '#fff' : s.colour,
                         stroke: s.look === 'hollow' ? s.colour : '#fff', 'stroke-width': s.look === 'hollow' ? 1.8 : 0.8}, null, svg);
    }
  }

  drawBand(svg, s) {
    const there = [], back = [];
    const inside = v => Math.min(this.frame.bottom + 400, Math.max(this.frame.top - 400, v));
    for (let k = 0; k < s.x.length; ++k) {
      if (!finite(s.low[k]) || !finite(s.high[k])) continue;
      const low = this.isLog('y') && s.low[k] <= 0 ? this.y[0] : s.low[k];
      there.push(`${this.px(s.x[k]).toFixed(1)} ${inside(this.py(s.high[k])).toFixed(1)}`);
      back.unshift(`${this.px(s.x[k]).toFixed(1)} ${inside(this.py(low)).toFixed(1)}`);
    }
    if (there.length > 1)
      element('path', {d: `M${[...there, ...back].join('L')}Z`, fill: s.colour, 'fill-opacity': s.opacity || 0.12, stroke: 'none'}, null, svg);
  }
}

/** Coefficients of coded terms with their 95 % intervals, one row each; zero is the line that matters. */
function drawEffects(figure, caption, unit, coefficients) {
  const title = figure.querySelector('figcaption');
  title.textContent = caption;
  element('small', {}, 'change of the response by half a factor\u2019s range, 95 % interval', title);
  const note = element('div', {class: 'surface-note'}, 'Filled: told from zero (p < 0.05).');
  figure.insertBefore(note, figure.querySelector('.plot'));
  const width = 560, height = 330, left = 110, right = width - 16, top = 10, bottom = height - 44;
  const known = coefficients.filter(c => c.term !== 'intercept' && finite(c.value));
  const ends = known.flatMap(c => [c.value, c.low, c.high]).filter(finite);
  let low = Math.min(0, ...ends), high = Math.max(0, ...ends);
  if (low === high) { low -= 1; high += 1; }
  const pad = 0.05 * (high - low);
  low -= pad; high += pad;
  const px = v => left + (v - low) / (high - low) * (right - left);
  const row = k => top + (k + 0.5) * (bottom - top) / known.length;
  const svg = element('svg', {viewBox: `0 0 ${width} ${height}`, role: 'img',
                              'aria-label': `${caption}: ${known.map(c => `${c.term} ${readable(c.value)}`).join(', ')}`});
  for (const t of ticks(low, high, 6)) {
    element('line', {x1: px(t.value), x2: px(t.value), y1: top, y2: bottom, stroke: '#e4e8ed'}, null, svg);
    element('text', {x: px(t.value), y: bottom + 17, 'text-anchor': 'middle'}, t.text, svg);
  }
  element('line', {x1: px(0), x2: px(0), y1: top, y2: bottom, stroke: '#1d2733'}, null, svg);
  known.forEach((c, k) => {
    const y = row(k), isTold = finite(c.p) && c.p < 0.05;
    element('text', {x: left - 10, y: y + 4, 'text-anchor': 'end', class: 'axis-name'}, c.term, svg);
    if (finite(c.low)) element('path', {d: `M${px(c.low)} ${y}H${px(c.high)}M${px(c.low)} ${y - 5}v10M${px(c.high)} ${y - 5}v10`,
                                        stroke: palette[0], 'stroke-width': 1.6, fill: 'none'}, null, svg);
    element('circle', {cx: px(c.value), cy: y, r: 4.5, fill: isTold ? palette[0] : '#fff', stroke: palette[0], 'stroke-width': 1.6}, null, svg);
  });
  element('text', {x: (left + right) / 2, y: bottom + 36, 'text-anchor': 'middle', class: 'axis-name'},
          `coefficient${unit ? ` [${unit}]` : ''}`, svg);
  figure.querySelector('.plot').append(svg);
  ++chartCount;
}
