'use strict';
// Uses an open report as a person would, and notes on <html> as data-* what came of it. browser_test.cpp appends this
// to a copy of the page and judges the notes.

const note = (name, value) => { document.documentElement.dataset[name] = String(value); };
const byId = id => document.getElementById(id);

function picture(id = 'compact-canvas') {
  const canvas = byId(id), gl = canvas.getContext('webgl2');
  const pixels = new Uint8Array(4 * gl.drawingBufferWidth * gl.drawingBufferHeight);
  gl.readPixels(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  return new Uint32Array(pixels.buffer);
}

/** Percentage of pixels that differ. */
function difference(a, b) {
  let n = 0;
  for (let k = 0; k < a.length; ++k) n += a[k] !== b[k];
  return (100 * n / a.length).toFixed(2);
}

/** Does something to the page; @returns the percentage of the picture that it changed. */
function changes(act) {
  const before = picture();
  act();
  return difference(before, picture());
}

function choose(id, value, type = 'change') {
  byId(id).value = value;
  byId(id).dispatchEvent(new Event(type, {bubbles: true}));
}

const press = key => byId('compact-canvas').dispatchEvent(new KeyboardEvent('keydown', {key, bubbles: true}));

function drag(node, [fromX, fromY], [toX, toY], Type, names) {
  const box = node.getBoundingClientRect();
  const fire = (name, fx, fy, buttons) => node.dispatchEvent(new Type(name, {
    bubbles: true, cancelable: true, button: 0, buttons, clientX: box.left + fx * box.width, clientY: box.top + fy * box.height}));
  fire(names[0], fromX, fromY, 1);
  fire(names[1], (fromX + toX) / 2, (fromY + toY) / 2, 1);
  fire(names[1], toX, toY, 1);
  fire(names[2], toX, toY, 0);
}

/** How much of the picture the tools take, and their colour bar. */
function lookAtTheTools() {
  if (!byId('tools-canvas')) return;
  const seen = picture('tools-canvas'), background = seen[0];
  note('stressedPainted', (100 * seen.filter(p => p !== background).length / seen.length).toFixed(2));
  note('barVonMises', byId('tools-bar').textContent);
}

function useTheCompact() {
  const first = picture(), background = first[0];
  note('painted', (100 * first.filter(p => p !== background).length / first.length).toFixed(2));
  note('turnedByMouse', changes(() => drag(byId('compact-canvas'), [0.5, 0.5], [0.7, 0.4], MouseEvent, ['mousedown', 'mousemove', 'mouseup'])));
  note('turnedByKey', changes(() => press('ArrowRight')));
  note('zoomed', changes(() => press('+')));
  note('cut', changes(() => choose('compact-cut', 50, 'input')));
  note('cutText', byId('compact-cut').getAttribute('aria-valuetext'));
  note('cutAcross', changes(() => choose('compact-axis', 'z')));
  note('barStress', byId('compact-bar').textContent);
  note('colouredByComponent', changes(() => choose('compact-colour', 'component')));
  note('barComponent', byId('compact-bar').textContent);
  choose('compact-colour', 'overlap');
  note('barOverlap', byId('compact-bar').textContent);
  note('withoutTools', changes(() => byId('compact-tools').click()));
  byId('compact-tools').click();
  choose('compact-colour', 'stress');
  byId('compact-reset').click();
  choose('compact-axis', 'y');
  note('afterReset', difference(first, picture()));
  drag(byId('compact-canvas'), [0.5, 0.5], [0.5, 0.5], PointerEvent, ['pointerdown', 'pointermove', 'pointerup']);
  note('grainUnderPointer', byId('compact-note').textContent);
}

function point(svg, fx, fy, name = 'pointermove') {
  const box = svg.getBoundingClientRect();
  svg.dispatchEvent(new PointerEvent(name, {bubbles: true, clientX: box.left + fx * box.width, clientY: box.top + fy * box.height}));
}

function useTheCharts() {
  const figure = byId('force-time'), svg = () => figure.querySelector('.plot > svg');
  const lines = () => figure.querySelectorAll('path').length;
  const axis = () => [...svg().querySelectorAll('text')].map(t => t.textContent).join('|');
  const at = v => (62 + v * (550 - 62)) / 560;  // where the fraction v of the time axis lies in the drawing
  point(svg(), at(0.6), 0.5);
  note('tip', figure.querySelector('.tip').textContent);
  point(byId('force-gap').querySelector('.plot > svg'), at(0.1), 0.7);
  note('tipGap', byId('force-gap').querySelector('.tip').textContent);
  note('lines', lines());
  figure.querySelector('.legend button').click();
  note('linesWithoutUpper', lines());
  figure.querySelector('.legend button').click();
  const whole = axis();
  drag(svg(), [at(0.5), 0.5], [at(0.7), 0.5], PointerEvent, ['pointerdown', 'pointermove', 'pointerup']);
  note('zoomedAxis', axis());
  svg().dispatchEvent(new MouseEvent('dblclick', {bubbles: true}));
  note('axisRestored', axis() === whole);
}

function lookAtThePage() {
  note('fetched', performance.getEntriesByType('resource').map(r => r.name).join(' '));
  note('tooWide', document.documentElement.scrollWidth > window.innerWidth);
  const nameless = [...document.querySelectorAll('button, select, input, canvas, svg[role=img]')].filter(node =>
      !(node.getAttribute('aria-label') || node.textContent.trim() || (node.labels && node.labels.length)));
  note('nameless', nameless.length);
  const badText = [...document.querySelectorAll('svg text, td, .tip')].filter(n => /NaN|undefined|Infinity/.test(n.textContent));
  note('badText', badText.length);
}

try {
  lookAtThePage();
  lookAtTheTools();
  if (document.documentElement.dataset.grains) useTheCompact();
  if (document.querySelector('#force-time svg')) useTheCharts();
  note('driven', 'to the end');
} catch (problem) {
  note('driven', problem.stack);
}
