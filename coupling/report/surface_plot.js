// A response surface over two factors: colours and contour lines, the runs with their values, the target's line, the
// calibrated point with its intervals and the border of the joint 95 % region.

const lowColour = [246, 250, 253], highColour = [96, 158, 209];

function mixed(share) {
  const t = Math.min(1, Math.max(0, share));
  return lowColour.map((c, k) => Math.round(c + t * (highColour[k] - c)));
}

/** The crossing of a contour with each cell: [[x, y, x, y]] in cell units, by marching squares on triangles. */
function contourSegments(grid, n, level) {
  const segments = [];
  const triangle = corners => {
    const ends = [];
    for (let k = 0; k < 3; ++k) {
      const [a, b] = [corners[k], corners[(k + 1) % 3]];
      if ((a[2] < level) === (b[2] < level)) continue;
      const t = (level - a[2]) / (b[2] - a[2]);
      ends.push([a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])]);
    }
    if (ends.length === 2) segments.push([...ends[0], ...ends[1]]);
  };
  for (let j = 0; j + 1 < n; ++j)
    for (let i = 0; i + 1 < n; ++i) {
      const at = (a, b) => [a, b, grid[b * n + a]];
      triangle([at(i, j), at(i + 1, j), at(i + 1, j + 1)]);
      triangle([at(i, j), at(i + 1, j + 1), at(i, j + 1)]);
    }
  return segments;
}

class SurfacePlot {
  /** spec = {caption, note, response, grid, first, second: factors, calibration} */
  constructor(figure, spec) {
    this.spec = spec;
    this.figure = figure;
    const caption = figure.querySelector('figcaption');
    caption.textContent = spec.caption;
    if (spec.note) element('small', {}, spec.note, caption);
    this.plot = figure.querySelector('.plot');
    this.plot.classList.add('square');
    const note = element('div', {class: 'surface-note'});
    note.textContent = 'Dots: means of the runs' + (spec.note ? ' over the other factors' : '') + (spec.response.target !== null ? '; red: the target' : '') +
        (spec.calibration ? '; black: calibrated, 95 % intervals and region' : '');
    figure.insertBefore(note, this.plot);
    this.width = 560;
    this.height = 460;
    this.frame = {left: 66, right: 470, top: 12, bottom: 412};
    const values = spec.grid.values.filter(finite);
    this.low = Math.min(...values);
    this.high = Math.max(...values);
    if (this.low === this.high) { this.low -= 0.5; this.high += 0.5; }
    this.tip = element('div', {class: 'tip', hidden: ''}, null, this.plot);
    this.draw();
    ++chartCount;
  }

  share(axis, v) { const f = this.spec[axis]; return (v - f.low) / (f.high - f.low); }
  px(v) { return this.frame.left + this.share('first', v) * (this.frame.right - this.frame.left); }
  py(v) { return this.frame.bottom - this.share('second', v) * (this.frame.bottom - this.frame.top); }

  draw() {
    const {response, first, second} = this.spec;
    const label = `${this.spec.caption}: from ${readable(this.low)} to ${readable(this.high)} ${response.unit}`;
    const svg = element('svg', {viewBox: `0 0 ${this.width} ${this.height}`, role: 'img', 'aria-label': label});
    const {left, right, top, bottom} = this.frame;
    const clip = element('clipPath', {id: `surface-clip-${chartCount}`}, null, element('defs', {}, null, svg));
    element('rect', {x: left, y: top, width: right - left, height: bottom - top}, null, clip);
    this.drawColours(svg);
    const inside = element('g', {'clip-path': `url(#surface-clip-${chartCount})`, fill: 'none'}, null, svg);
    this.drawContours(inside);
    this.drawAxes(svg, first, second);
    this.drawRuns(svg);
    this.drawCalibration(inside, svg);
    this.drawBar(svg);
    this.plot.prepend(svg);
    this.svg = svg;
    svg.addEventListener('pointermove', event => this.showValue(event));
    svg.addEventListener('pointerleave', () => { this.tip.hidden = true; });
  }

  drawColours(svg) {
    const n = this.spec.grid.n;
    const canvas = document.createElement('canvas');
    canvas.width = canvas.height = n;
    const pen = canvas.getContext('2d'), picture = pen.createImageData(n, n);
    this.spec.grid.values.forEach((v, k) => {
      const column = k % n, row = n - 1 - Math.floor(k / n);
      picture.data.set([...mixed((v - this.low) / (this.high - this.low)), 255], 4 * (row * n + column));
    });
    pen.putImageData(picture, 0, 0);
    const {left, right, top, bottom} = this.frame;
    // Nodes lie in the middle of the picture's pixels: half a pixel hangs over on each side.
    const w = (right - left) * n / (n - 1), h = (bottom - top) * n / (n - 1);
    const image = document.createElementNS('http://www.w3.org/2000/svg', 'image');
    for (const [key, value] of Object.entries({x: left - (w - right + left) / 2, y: top - (h - bottom + top) / 2, width: w, height: h,
                                               preserveAspectRatio: 'none', href: canvas.toDataURL(),
                                               'clip-path': `url(#surface-clip-${chartCount})`}))
      image.setAttribute(key, value);
    svg.append(image);
  }

  /** A path of the level's line, and the middle of one of its pieces for a label. */
  lineAt(level) {
    const n = this.spec.grid.n, {left, right, top, bottom} = this.frame;
    const x = i => left + i / (n - 1) * (right - left), y = j => bottom - j / (n - 1) * (bottom - top);
    const segments = contourSegments(this.spec.grid.values, n, level);
    const d = segments.map(([a, b, c, e]) => `M${x(a).toFixed(1)} ${y(b).toFixed(1)}L${x(c).toFixed(1)} ${y(e).toFixed(1)}`).join('');
    const away = s => Math.abs((s[0] + s[2]) / 2 / (n - 1) - 0.5) + Math.abs((s[1] + s[3]) / 2 / (n - 1) - 0.24);
    const margin = 0.06 * (n - 1);  // a label at the rim would be cut off
    const best = segments.filter(s => s[0] > margin && s[0] < n - 1 - margin && s[1] > margin && s[1] < n - 1 - margin)
        .reduce((a, s) => !a || away(s) < away(a) ? s : a, null);
    return {d, label: best && [x((best[0] + best[2]) / 2), y((best[1] + best[3]) / 2)]};
  }

  drawContours(svg) {
    for (const t of ticks(this.low, this.high, 8)) {
      const line = this.lineAt(t.value);
      if (!line.d) continue;
      element('path', {d: line.d, stroke: '#4c6f90', 'stroke-width': 0.8, 'stroke-opacity': 0.7}, null, svg);
      if (line.label) element('text', {x: line.label[0], y: line.label[1] + 4, 'text-anchor': 'middle', class: 'value'}, t.text, svg);
    }
    const target = this.spec.response.target;
    if (target === null || !(target > this.low && target < this.high)) return;
    element('path', {d: this.lineAt(target).d, stroke: '#b02a2a', 'stroke-width': 2.4}, null, svg);
  }

  drawAxes(svg, first, second) {
    const {left, right, top, bottom} = this.frame;
    const across = powerOf(first), up = powerOf(second);
    for (const t of ticks(first.low / across, first.high / across, 6)) {
      const x = this.px(t.value * across);
      element('line', {x1: x, x2: x, y1: bottom, y2: bottom + 4, stroke: '#9aa4b0'}, null, svg);
      element('text', {x, y: bottom + 17, 'text-anchor': 'middle'}, t.text, svg);
    }
    for (const t of ticks(second.low / up, second.high / up, 6)) {
      const y = this.py(t.value * up);
      element('line', {x1: left - 4, x2: left, y1: y, y2: y, stroke: '#9aa4b0'}, null, svg);
      element('text', {x: left - 7, y: y + 4, 'text-anchor': 'end'}, t.text, svg);
    }
    element('rect', {x: left, y: top, width: right - left, height: bottom - top, fill: 'none', stroke: '#9aa4b0'}, null, svg);
    element('text', {x: (left + right) / 2, y: bottom + 36, 'text-anchor': 'middle', class: 'axis-name'}, factorName(first, across), svg);
    element('text', {transform: `translate(14 ${(top + bottom) / 2}) rotate(-90)`, 'text-anchor': 'middle', class: 'axis-name'},
            factorName(second, up), svg);
  }

  /** The mean of the runs at each point of the two factors. */
  drawRuns(svg) {
    const {response, grid} = this.spec, points = new Map();
    for (const run of response.runs) {
      const key = `${run.at[grid.first]} ${run.at[grid.second]}`;
      if (!points.has(key)) points.set(key, {at: run.at, values: []});
      if (finite(run.value)) points.get(key).values.push(run.value);
    }
    const {left, right, top} = this.frame;
    for (const {at, values} of points.values()) {
      const x = this.px(at[grid.first]), y = this.py(at[grid.second]);
      element('circle', {cx: x, cy: y, r: 4, fill: '#fff', stroke: '#1d2733', 'stroke-width': 1.3}, null, svg);
      if (!values.length) continue;
      const mean = values.reduce((a, v) => a + v, 0) / values.length;
      const side = x > right - 40 ? 'end' : x < left + 40 ? 'start' : 'middle';
      element('text', {x: x + (side === 'end' ? -2 : side === 'start' ? 4 : 0), y: y < top + 20 ? y + 17 : y - 8, 'text-anchor': side,
                       class: 'value', 'font-weight': 600}, shortValue(mean), svg);
    }
  }

  drawCalibration(inside, svg) {
    const found = this.spec.calibration, {grid} = this.spec;
    if (!found) return;
    const [a, b] = [found.factors[grid.first], found.factors[grid.second]];
    const cross = {stroke: '#111', 'stroke-width': 2, fill: 'none'};
    if (!a.held) element('path', {d: `M${this.px(a.low)} ${this.py(b.value)}H${this.px(a.high)}`, ...cross}, null, inside);
    if (!b.held) element('path', {d: `M${this.px(a.value)} ${this.py(b.low)}V${this.py(b.high)}`, ...cross}, null, inside);
    for (const region of found.regions.filter(r => r.first === grid.first && r.second === grid.second))
      drawRegion(inside, region, v => this.px(v), v => this.py(v));
    const x = this.px(a.value), y = this.py(b.value);
    element('path', {d: `M${x} ${y - 6}L${x + 6} ${y}L${x} ${y + 6}L${x - 6} ${y}Z`, fill: '#111', stroke: '#fff'}, null, svg);
  }

  drawBar(svg) {
    const x = 490, {top, bottom} = this.frame, n = 24;
    for (let k = 0; k < n; ++k)
      element('rect', {x, width: 14, y: bottom - (k + 1) * (bottom - top) / n, height: (bottom - top) / n + 0.6,
                       fill: `rgb(${mixed((k + 0.5) / n).join(',')})`}, null, svg);
    for (const t of ticks(this.low, this.high, 8))
      element('text', {x: x + 19, y: bottom - (t.value - this.low) / (this.high - this.low) * (bottom - top) + 4}, t.text, svg);
  }

  showValue(event) {
    const box = this.svg.getBoundingClientRect(), {left, right, top, bottom} = this.frame, {first, second, grid, response} = this.spec;
    const u = ((event.clientX - box.left) * this.width / box.width - left) / (right - left);
    const v = (bottom - (event.clientY - box.top) * this.height / box.height) / (bottom - top);
    if (!(u >= 0 && u <= 1 && v >= 0 && v <= 1)) { this.tip.hidden = true; return; }
    const value = grid.values[Math.round(v * (grid.n - 1)) * grid.n + Math.round(u * (grid.n - 1))];
    this.tip.textContent = `${response.name} ${readable(value)} ${response.unit} at ${first.name} ${readable(first.low + u * (first.high - first.low))}, ` +
        `${second.name} ${readable(second.low + v * (second.high - second.low))}`;
    this.tip.hidden = false;
    this.tip.style.transform = `translate(${Math.min(u * box.width * 0.7, box.width - this.tip.offsetWidth - 8)}px, ${(1 - v) * box.height * 0.8 + 24}px)`;
  }
}

/** A power of ten that takes the zeros off an axis: 1e6 for 3e6 to 7e6. */
function powerOf(factor) {
  const largest = Math.max(Math.abs(factor.low), Math.abs(factor.high));
  return largest >= 1e5 || largest < 1e-3 ? 10 ** (3 * Math.floor(Math.log10(largest) / 3)) : 1;
}
const superscript = n => String(n).replace(/-/g, '\u207b').replace(/\d/g, d => '\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079'[d]);
function factorName(factor, power = 1) {
  const unit = [power === 1 ? '' : `10${superscript(Math.round(Math.log10(power)))}`, factor.unit].filter(Boolean).join(' ');
  return factor.name + (unit ? ` [${unit}]` : '');
}
const shortValue = v => (Math.abs(v) >= 1e5 ? String(+(v / 10 ** Math.floor(Math.log10(Math.abs(v)))).toPrecision(4)) +
    `e${Math.floor(Math.log10(Math.abs(v)))}` : String(+v.toPrecision(4))).replace(/^-/, '\u2212');

function drawRegion(svg, region, px, py) {
  for (const line of region.lines)
    element('path', {d: 'M' + line.map(([x, y]) => `${px(x).toFixed(2)} ${py(y).toFixed(2)}`).join('L'), stroke: '#111', 'stroke-width': 1.6,
                     fill: '#11111114'}, null, svg);
}
