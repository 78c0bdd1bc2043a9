// A paint as a material of three.js (0.154 or later), written by Nacre:
//
//   import * as THREE from "three";
//   import { createMaterial } from "./paint.three.js";
//   mesh.material = createMaterial(THREE, { environment: equirectangularTexture });
//
// It is lit by directional, point and ambient lights and by an equirectangular picture of the
// surroundings; it shows the mean of the flakes, without sparkle and shadows.

/** What this is of, and how far its colours are from the paint's. */
export const about = '@ABOUT@';

export const smoothCoat = '@SMOOTH_COAT@';
const tableSize = '@TABLE_SIZE@', smoothSize = '@SMOOTH_SIZE@';

/** nacreBrdf(wi, wo) and what it needs, in GLSL ES 3.00; the caller defines PI. */
export const brdfShader = '@GLSL@';

function halves(text) {
  const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  const view = new DataView(bytes.buffer);
  return Uint16Array.from({ length: bytes.length / 2 }, (_, i) => view.getUint16(2 * i, true));
}

/** The two textures: size, and half floats in RGBA. */
export const textures = {
  table: { size: tableSize, data: halves('@TABLE@') },
  smooth: { size: smoothSize, data: halves('@SMOOTH@') },
};

const vertexShader = `
out vec3 vPosition;
out vec3 vNormal;
void main() {
  vec4 position4 = modelViewMatrix * vec4(position, 1.0);
  vPosition = position4.xyz;
  vNormal = normalMatrix * normal;
  gl_Position = projectionMatrix * position4;
}`;

const fragmentShader = `
#include <common>
#include <lights_pars_begin>
in vec3 vPosition;
in vec3 vNormal;
uniform sampler2D nacreEnvironment;
uniform float nacreEnvironmentIntensity;
${brdfShader}

vec3 nacreSurroundings(vec3 world, float solidAngle) {
  vec2 size = vec2(textureSize(nacreEnvironment, 0));
  // As many texels as the solid angle covers.
  float texel = 2. * PI * PI / (size.x * size.y) * max(sqrt(1. - world.y * world.y), 1e-3);
  float lod = solidAngle > 0. ? max(.5 * log2(solidAngle / texel) + 1., 0.) : 0.;
  vec2 uv = vec2(atan(world.z, world.x) / (2. * PI) + .5, asin(clamp(world.y, -1., 1.)) / PI + .5);
  return textureLod(nacreEnvironment, uv, lod).rgb * nacreEnvironmentIntensity;
}

float nacreRadicalInverse(uint bits) {
  bits = (bits << 16u) | (bits >> 16u);
  bits = ((bits & 0x00ff00ffu) << 8u) | ((bits & 0xff00ff00u) >> 8u);
  bits = ((bits & 0x0f0f0f0fu) << 4u) | ((bits & 0xf0f0f0f0u) >> 4u);
  bits = ((bits & 0x33333333u) << 2u) | ((bits & 0xccccccccu) >> 2u);
  bits = ((bits & 0x55555555u) << 1u) | ((bits & 0xaaaaaaaau) >> 1u);
  return float(bits) * 2.3283064365386963e-10;
}

/// Surroundings by samples of each lobe and evenly, weighted by the balance of their densities.
vec3 nacreSurrounded(vec3 wi, mat3 toWorld) {
  const int each = NACRE_SAMPLES;
  vec3 sum = vec3(0.);
  int lobes = int(nacreLobeCount);
  for (int lobe = 0; lobe <= lobes; ++lobe) {
    for (int k = 0; k < each; ++k) {
      vec2 u = vec2((float(k) + .5) / float(each), nacreRadicalInverse(uint(k)));
      float r = sqrt(u.x), phi = 2. * PI * u.y;
      vec3 wo = lobe < lobes ? nacreDraw(lobe, wi, u)
                              : vec3(r * cos(phi), r * sin(phi), sqrt(1. - u.x));
      if (wo.z <= 0.) continue;
      float density = wo.z / PI;
      for (int other = 0; other < lobes; ++other) density += nacreDensity(other, wi, wo);
      density *= float(each);
      sum += nacreBrdf(wi, wo) * wo.z / density * nacreSurroundings(toWorld * wo, 1. / density);
    }
  }
  return sum;
}

void main() {
  vec3 n = normalize(gl_FrontFacing ? vNormal : -vNormal), v = normalize(-vPosition);
  // Of the samples' directions, without a seam where the surface faces the viewer [duff-2017-onb].
  float a = 1. / (1. + n.z);
  vec3 t = vec3(1. - a * n.x * n.x, -a * n.x * n.y, -n.x);
  mat3 toView = mat3(t, cross(n, t), n);
  vec3 wi = v * toView;
  wi = normalize(vec3(wi.xy, max(wi.z, 1e-3)));
  vec3 light = ambientLightColor / PI * nacreAlbedo(wi.z);
#if NUM_DIR_LIGHTS > 0
  for (int k = 0; k < NUM_DIR_LIGHTS; ++k) {
    vec3 wo = directionalLights[k].direction * toView;
    if (wo.z > 0.) light += nacreBrdf(wi, wo) * wo.z * directionalLights[k].color;
  }
#endif
#if NUM_POINT_LIGHTS > 0
  for (int k = 0; k < NUM_POINT_LIGHTS; ++k) {
    vec3 to = pointLights[k].position - vPosition;
    vec3 wo = normalize(to) * toView;
    if (wo.z > 0.) {
      light += nacreBrdf(wi, wo) * wo.z * pointLights[k].color *
               getDistanceAttenuation(length(to), pointLights[k].distance, pointLights[k].decay);
    }
  }
#endif
#ifdef NACRE_ENVIRONMENT
  mat3 toWorld = transpose(mat3(viewMatrix)) * toView;
  light += nacreSurrounded(wi, toWorld);
  if (${smoothCoat}) {
    vec3 mirror = vec3(-wi.xy, wi.z);
    light += nacreFresnel(wi.z) * nacreSurroundings(toWorld * mirror, 0.);
  }
#endif
  gl_FragColor = vec4(light, 1.);
  #include <tonemapping_fragment>
  #include <colorspace_fragment>
}`;

/**
 * The material; the textures are shared by all that are made of it.
 *
 * @param THREE  the namespace of three.js
 * @param options.environment  an equirectangular THREE.Texture of the surroundings, in linear light,
 *     with mipmaps; its wrapS is set to repeat
 * @param options.environmentIntensity  what it is multiplied by, 1 by default
 * @param options.samples  of the surroundings for each width of flakes and evenly, 1 to 1024; 16 by
 *     default
 */
export function createMaterial(THREE, options = {}) {
  const { environment = null, environmentIntensity = 1, samples = 16 } = options;
  if (!(Number.isInteger(samples) && samples >= 1 && samples <= 1024)) {
    throw new RangeError(`samples = ${samples}: must be a whole number in [1, 1024]`);
  }
  const { table, smooth } = textures;
  const uniforms = THREE.UniformsUtils.clone(THREE.UniformsLib.lights);
  const flat = new THREE.DataTexture(table.data, ...table.size, THREE.RGBAFormat, THREE.HalfFloatType);
  const solid = new THREE.Data3DTexture(smooth.data, ...smooth.size);
  solid.format = THREE.RGBAFormat;
  solid.type = THREE.HalfFloatType;
  solid.minFilter = solid.magFilter = THREE.LinearFilter;
  flat.needsUpdate = solid.needsUpdate = true;
  if (environment) environment.wrapS = THREE.RepeatWrapping;
  return new THREE.ShaderMaterial({
    name: about.name,
    lights: true,
    defines: { NACRE_SAMPLES: samples, ...(environment ? { NACRE_ENVIRONMENT: 1 } : {}) },
    uniforms: {
      ...uniforms,
      nacreTable: { value: flat },
      nacreSmooth: { value: solid },
      nacreEnvironment: { value: environment },
      nacreEnvironmentIntensity: { value: environmentIntensity },
    },
    vertexShader,
    fragmentShader,
  });
}
