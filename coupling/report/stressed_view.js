'use strict';
// The tools with the stress on their surfaces, cut open along the press axis, and the grains between them: lengths as in
// the picture of the compact.

const toolVertexShader = `
attribute vec3 colour;
varying vec3 place;
varying vec3 paint;
void main() {
  vec4 eye = modelViewMatrix * vec4(position, 1.0);
  place = eye.xyz;
  paint = colour;
  gl_Position = projectionMatrix * eye;
}`;

const toolFragmentShader = `
uniform vec4 cut;        // as for the grains
varying vec3 place;
varying vec3 paint;
void main() {
  if (dot(cut.xyz, place) > cut.w) discard;
  vec3 normal = normalize(cross(dFdx(place), dFdy(place)));
  float facing = abs(dot(normal, normalize(place)));
  gl_FragColor = vec4(paint * (0.55 + 0.45 * facing), 1.0);
}`;

class StressedView extends CompactView {
  constructor(canvas, {grains, tools}) {
    super(canvas, {grains, tools: [], components: facts.components});
    this.colourBy('component');
    this.addStress(tools);
    this.cut('y', 0.5);
    this.reset();
  }

  addStress(tools) {
    const floats = text => new Float32Array(unpack(text).buffer);
    const stress = tools.map(tool => floats(tool.von_mises));
    const all = Float32Array.from(stress.flatMap(values => [...values]));
    const range = [0, usefulRange(all)[1]];
    this.triangles = 0;
    tools.forEach((tool, t) => {
      const place = floats(tool.vertices), n = place.length / 3;
      const index = new Uint32Array(unpack(tool.triangles).buffer), colour = new Float32Array(3 * n);
      for (let v = 0; v < n; ++v) {
        for (let c = 0; c < 3; ++c) place[3 * v + c] *= 1e3;
        place[3 * v + 2] -= this.middle;
        this.extent = Math.max(this.extent, Math.hypot(place[3 * v], place[3 * v + 1], place[3 * v + 2]));
        viridisAt(stress[t][v] / range[1]).toArray(colour, 3 * v);
      }
      const geometry = new THREE.BufferGeometry();
      geometry.setAttribute('position', new THREE.BufferAttribute(place, 3));
      geometry.setAttribute('colour', new THREE.BufferAttribute(colour, 3));
      geometry.setIndex(new THREE.BufferAttribute(index, 1));
      const material = new THREE.ShaderMaterial({
        vertexShader: toolVertexShader, fragmentShader: toolFragmentShader, side: THREE.DoubleSide,
        uniforms: {cut: this.material.uniforms.cut}, extensions: {derivatives: true},
        // The sides of the punches lie in the bore: the first tool, the die, stands behind them.
        polygonOffset: t === 0, polygonOffsetFactor: 4, polygonOffsetUnits: 4});
      const mesh = new THREE.Mesh(geometry, material);
      mesh.frustumCulled = false;
      this.scene.add(mesh);
      this.triangles += index.length / 3;
    });
    this.bar = {range};
  }
}
