'use strict';
// The compact in three dimensions: lengths in mm about the middle of the bed, z up the press axis.

const viridis = ['#440154', '#482878', '#3e4989', '#31688e', '#26828e', '#1f9e89', '#35b779', '#6ece58', '#b5de2b', '#fde725']
    .map(hex => new THREE.Color(hex));
const componentColours = ['#d9c7a0', '#3d79b5', '#c9561b', '#3f7f3b', '#8a4f9e', '#5b6470'].map(hex => new THREE.Color(hex));

function unpack(base64) {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let k = 0; k < text.length; ++k) bytes[k] = text.charCodeAt(k);
  return bytes;
}

/** Smooth between the listed colours; 0 and beyond give the ends. */
function viridisAt(fraction) {
  const at = Math.min(1, Math.max(0, fraction)) * (viridis.length - 1), k = Math.min(viridis.length - 2, Math.floor(at));
  return viridis[k].clone().lerp(viridis[k + 1], at - k);
}

/** Limits that leave out the two per cent at either end, where single grains would wash out all the others. */
function usefulRange(values) {
  const sorted = Float32Array.from(values).filter(Number.isFinite).sort();
  if (!sorted.length) return [0, 1];
  const pick = q => sorted[Math.round(q * (sorted.length - 1))];
  const low = pick(0.02), high = pick(0.98);
  return high > low ? [low, high] : [low, low + (Math.abs(low) || 1)];
}

class CompactView {
  constructor(canvas, data) {
    this.canvas = canvas;
    this.data = data;
    this.readGrains(data.grains);
    const context = canvas.getContext('webgl2', {antialias: true, preserveDrawingBuffer: true, alpha: true});
    if (!context) throw new Error('This browser does not draw in three dimensions (WebGL 2 is off).');
    this.renderer = new THREE.WebGLRenderer({canvas, context, antialias: true, alpha: true, preserveDrawingBuffer: true});
    this.renderer.setClearColor(0xeef1f4, 1);
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(26, 4 / 3, 1, 1000);
    this.camera.up.set(0, 0, 1);
    this.controls = new THREE.OrbitControls(this.camera, canvas);
    this.controls.enableKeys = false;   // the arrows turn here, they do not pan
    this.controls.enableZoom = false;   // until the picture is chosen: scrolling belongs to the page
    this.controls.addEventListener('change', () => this.render());
    this.addGrains();
    this.addTools();
    this.cutAxis = 'y';
    this.cutFraction = 0;
    this.colourBy('stress');
    this.reset();
    new ResizeObserver(() => this.resize()).observe(canvas);
    this.resize();
  }

  readGrains({numbers, component}) {
    const raw = new Float32Array(unpack(numbers).buffer);
    this.n = raw.length / 6;
    this.component = unpack(component);
    const column = (k, factor) => Float32Array.from({length: this.n}, (_, g) => raw[6 * g + k] * factor);
    this.radius = column(3, 1e3);
    this.values = {radius: column(3, 1), overlap: column(4, 1), stress: column(5, 1)};
    const z = column(2, 1e3);
    this.low = z.reduce((low, v, g) => Math.min(low, v - this.radius[g]), Infinity);
    this.high = z.reduce((high, v, g) => Math.max(high, v + this.radius[g]), -Infinity);
    this.middle = this.n ? (this.low + this.high) / 2 : 0;
    this.centre = new Float32Array(3 * this.n);
    this.extent = 1;
    for (let g = 0; g < this.n; ++g) {
      const [x, y] = [raw[6 * g] * 1e3, raw[6 * g + 1] * 1e3];
      this.centre.set([x, y, z[g] - this.middle], 3 * g);
      this.extent = Math.max(this.extent, Math.hypot(x, y) + this.radius[g], Math.abs(z[g] - this.middle) + this.radius[g]);
    }
  }

  addGrains() {
    const geometry = new THREE.InstancedBufferGeometry();
    geometry.setAttribute('position', new THREE.Float32BufferAttribute([-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0], 3));
    geometry.setIndex([0, 1, 2, 0, 2, 3]);
    geometry.setAttribute('centre', new THREE.InstancedBufferAttribute(this.centre, 3));
    geometry.setAttribute('radius', new THREE.InstancedBufferAttribute(this.radius, 1));
    this.colours = new THREE.InstancedBufferAttribute(new Float32Array(3 * this.n), 3);
    geometry.setAttribute('colour', this.colours);
    geometry.maxInstancedCount = this.n;
    this.material = new THREE.ShaderMaterial({
      vertexShader: grainVertexShader, fragmentShader: grainFragmentShader, side: THREE.DoubleSide,
      uniforms: {cut: {value: new THREE.Vector4(0, 0, 0, 1)}}, extensions: {fragDepth: true}});
    const mesh = new THREE.Mesh(geometry, this.material);
    mesh.frustumCulled = false;
    this.scene.add(mesh);
  }

  addTools() {
    this.tools = new THREE.Group();
    for (const tool of this.data.tools) {
      const points = [], at = (angle, z) =>
          new THREE.Vector3(1e3 * tool.radius * Math.cos(angle), 1e3 * tool.radius * Math.sin(angle), 1e3 * z - this.middle);
      for (const z of new Set([tool.bottom, tool.top]))
        for (let k = 0; k < 96; ++k) points.push(at(k * Math.PI / 48, z), at((k + 1) * Math.PI / 48, z));
      if (tool.top !== tool.bottom)
        for (let k = 0; k < 8; ++k) points.push(at(k * Math.PI / 4, tool.bottom), at(k * Math.PI / 4, tool.top));
      this.tools.add(new THREE.LineSegments(new THREE.BufferGeometry().setFromPoints(points),
                                            new THREE.LineBasicMaterial({color: 0x5b6470, transparent: true, opacity: 0.6})));
    }
    this.scene.add(this.tools);
  }

  /** Paints the grains. @returns what a colour bar needs: {range} or, for components, {keys} */
  colourBy(name) {
    if (name === 'component') {
      const colour = k => componentColours[k % componentColours.length];
      for (let g = 0; g < this.n; ++g) colour(this.component[g]).toArray(this.colours.array, 3 * g);
      this.bar = {keys: this.data.components.map((text, k) => ({text, colour: '#' + colour(k).getHexString()}))};
    } else {
      const values = this.values[name], range = usefulRange(values);
      for (let g = 0; g < this.n; ++g)
        viridisAt((values[g] - range[0]) / (range[1] - range[0])).toArray(this.colours.array, 3 * g);
      this.bar = {range};
    }
    this.colours.needsUpdate = true;
    this.render();
    return this.bar;
  }

  /** Takes away what lies beyond a plane across `axis`; fraction 0 keeps all, 1 nothing. */
  cut(axis, fraction) {
    this.cutAxis = axis;
    this.cutFraction = fraction;
    this.render();
  }

  reset() {
    const distance = 1.08 * this.extent / Math.sin(13 * Math.PI / 180);
    this.camera.position.set(0.42, -0.80, 0.44).setLength(distance);
    this.camera.near = distance / 20;
    this.camera.far = distance * 4;
    this.camera.updateProjectionMatrix();
    this.controls.target.set(0, 0, 0);
    this.controls.minDistance = distance / 8;
    this.controls.maxDistance = distance * 2;
    this.controls.update();
    this.render();
  }

  /** Turns the view by angles [rad] about the press axis and upwards. */
  turn(around, upwards) {
    const s = new THREE.Spherical().setFromVector3(new THREE.Vector3(this.camera.position.x, this.camera.position.z, -this.camera.position.y));
    s.theta += around;
    s.phi = Math.min(Math.PI - 0.01, Math.max(0.01, s.phi - upwards));
    const p = new THREE.Vector3().setFromSpherical(s);
    this.camera.position.set(p.x, -p.z, p.y);
    this.controls.update();
    this.render();
  }

  zoom(factor) {
    this.camera.position.multiplyScalar(factor);
    this.controls.update();
    this.render();
  }

  resize() {
    const {clientWidth: w, clientHeight: h} = this.canvas;
    if (!w || !h) return;
    this.renderer.setPixelRatio(Math.min(2, window.devicePixelRatio || 1));
    this.renderer.setSize(w, h, false);
    this.camera.aspect = w / h;
    this.camera.updateProjectionMatrix();
    this.render();
  }

  /** The cut as normal and offset, here and in the eye's frame. The near side goes: at the front that is -y. */
  cutPlane() {
    const normal = {x: [1, 0, 0], y: [0, -1, 0], z: [0, 0, 1]}[this.cutAxis];
    const half = this.cutAxis === 'z' ? (this.high - this.low) / 2 : this.extent;
    return {normal: new THREE.Vector3(...normal), offset: half * (1.001 - 2 * this.cutFraction)};
  }

  render() {
    this.camera.updateMatrixWorld();
    const {normal, offset} = this.cutPlane();
    const eye = normal.clone().transformDirection(this.camera.matrixWorldInverse);
    const shift = eye.dot(new THREE.Vector3().setFromMatrixPosition(this.camera.matrixWorldInverse));
    this.material.uniforms.cut.value.set(eye.x, eye.y, eye.z, offset + shift);
    this.renderer.render(this.scene, this.camera);
  }

  /** The grain under a point of the canvas (fractions of its size), or -1. */
  grainAt(fx, fy) {
    const ray = new THREE.Raycaster();
    ray.setFromCamera({x: 2 * fx - 1, y: 1 - 2 * fy}, this.camera);
    const {origin, direction} = ray.ray, {normal, offset} = this.cutPlane(), centre = new THREE.Vector3();
    let best = -1, nearest = Infinity;
    for (let g = 0; g < this.n; ++g) {
      centre.fromArray(this.centre, 3 * g).sub(origin);
      const along = centre.dot(direction), inside = along * along - centre.lengthSq() + this.radius[g] ** 2;
      if (inside < 0) continue;
      let t = along - Math.sqrt(inside);
      const slope = normal.dot(direction), over = normal.dot(origin) + slope * t - offset;
      if (over > 0) {
        t = (offset - normal.dot(origin)) / slope;
        if (slope >= 0 || t > along + Math.sqrt(inside)) continue;
      }
      if (t < nearest) { nearest = t; best = g; }
    }
    return best;
  }
}
