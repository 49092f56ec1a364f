'use strict';
// Each grain is one square that faces the eye; the fragment finds where its line of sight meets the sphere. Spheres are
// exact at any zoom, a cut through a grain shows its filled section, and grains that overlap meet at their contact
// plane: where sections lie in one plane, the smaller power distance |x - c|^2 - R^2 wins, which is that plane.

const grainVertexShader = `
attribute vec3 centre;
attribute float radius;
attribute vec3 colour;
varying vec3 sight;
varying vec3 middle;
varying float size;
varying vec3 paint;
void main() {
  vec4 eye = modelViewMatrix * vec4(centre, 1.0);
  middle = eye.xyz;
  size = radius;
  paint = colour;
  float distance2 = dot(middle, middle);
  // The outline of a sphere in perspective is wider than its radius.
  float outline = radius * sqrt(distance2 / max(distance2 - radius * radius, 1e-6 * distance2));
  vec3 forward = normalize(middle);
  vec3 right = normalize(cross(forward, vec3(0.0, 1.0, 0.0)));
  vec3 up = cross(right, forward);
  sight = middle + outline * (position.x * right + position.y * up);
  gl_Position = projectionMatrix * vec4(sight, 1.0);
}`;

const grainFragmentShader = `
uniform mat4 projectionMatrix;
uniform vec4 cut;        // in eye space: points with dot(cut.xyz, p) > cut.w are taken away
varying vec3 sight;
varying vec3 middle;
varying float size;
varying vec3 paint;
void main() {
  vec3 ray = normalize(sight);
  float along = dot(ray, middle);
  float inside = along * along - (dot(middle, middle) - size * size);
  if (inside < 0.0) discard;
  float reach = sqrt(inside);
  float t = along - reach;
  bool isSection = false;
  if (dot(cut.xyz, ray) * t > cut.w) {
    float slope = dot(cut.xyz, ray);
    t = cut.w / slope;
    if (slope >= 0.0 || t > along + reach) discard;
    isSection = true;
  }
  vec3 hit = t * ray;
  vec3 normal = isSection ? cut.xyz : (hit - middle) / size;
  float facing = max(0.0, dot(normal, -ray));
  float above = max(0.0, dot(normal, normalize(vec3(-0.4, 0.8, 0.6))));
  vec3 shade = paint * (0.34 + 0.40 * facing + 0.30 * above);
  shade += 0.10 * pow(above, 24.0);
  if (isSection) shade = mix(paint, vec3(1.0), 0.12);
  vec4 clip = projectionMatrix * vec4(hit, 1.0);
  float depth = clip.z / clip.w;
  vec3 arm = hit - middle;
  if (isSection) depth += 1e-5 * (dot(arm, arm) - size * size);
  // A thin dark rim keeps neighbours of one colour apart.
  float below = dot(cut.xyz, middle) - cut.w;
  float outward = sqrt(max(0.0, dot(arm, arm) - below * below) / max(1e-9, size * size - below * below));
  float rim = isSection ? 1.0 - smoothstep(0.90, 1.0, outward) : smoothstep(0.0, 0.32, facing);
  gl_FragColor = vec4(shade * (0.62 + 0.38 * rim), 1.0);
  gl_FragDepthEXT = 0.5 * depth + 0.5;
}`;
