/** The shaders of the live picture; that of the paint comes from the server. */

import { FLAKES } from "./flakes";

export const MOST_RECTANGLES = 4;
/**
 * Between the numbers of neighbours in a coarse picture: of 24 to 200 one by which the directions of the first
 * samples of 5 x 5 pixels fill the square well, next ones none takes twice (0.17 between the nearest two).
 */
const APART = 115;

export const HEAD = `
precision highp float;
precision highp int;
precision highp sampler2D;
#define PI 3.141592653589793
`;

/** A triangle that covers everything. */
export const EVERYWHERE = `
void main() {
    gl_Position = vec4(gl_VertexID == 1 ? 3. : -1., gl_VertexID == 2 ? 3. : -1., 0., 1.);
}`;

/** Where the shape is seen: places and normals in the world. */
export const SHAPE_VERTEX = `
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform mat4 toWorld;
uniform mat4 toScreen;
out vec3 place;
out vec3 facing;
void main() {
    vec4 world = toWorld * vec4(position, 1.);
    place = world.xyz;
    facing = mat3(toWorld) * normal;
    gl_Position = toScreen * world;
}`;

export const SHAPE_FRAGMENT = `${HEAD}
in vec3 place;
in vec3 facing;
layout(location = 0) out vec4 placeAt;
layout(location = 1) out vec4 facingAt;
void main() {
    placeAt = vec4(place, 1.);
    facingAt = vec4(normalize(facing), 0.);
}`;

/**
 * One more sample of each pixel, added to those before. Light is looked for in directions that are drawn
 * from the surroundings, from rectangles and from the lobes of the paint, weighted by the balance of
 * their densities [veach-1997]; the sun, narrower than any lobe, by itself.
 */
export function shading(paint: string, smoothCoat: boolean): string {
    return `${HEAD}
${paint}
uniform sampler2D placeAt;
uniform sampler2D facingAt;
uniform sampler2D surroundings;
uniform sampler2D byColumn;
uniform sampler2D byRow;
uniform float azimuth;           // of the middle of the surroundings
uniform vec4 sun;                // towards it, and the cosine of its radius; 2: there is none
uniform vec3 sunRadiance;
uniform int rectangleCount;
uniform vec3 corner[${String(MOST_RECTANGLES)}];
uniform vec3 edgeU[${String(MOST_RECTANGLES)}];
uniform vec3 edgeV[${String(MOST_RECTANGLES)}];
uniform vec3 rectangleNormal[${String(MOST_RECTANGLES)}];
uniform vec3 rectangleRadiance[${String(MOST_RECTANGLES)}];
uniform vec3 eye;
uniform vec3 ahead;              // to the middle of the picture, and half its width and height
uniform vec3 across;
uniform vec3 upwards;
uniform vec2 size;
uniform vec2 shift;              // of this sample within its pixel
uniform uint sampleIndex;
uniform int interleaved;         // pixels of a side of which each takes other ones of the same numbers; 0: none
layout(location = 0) out vec4 light;
layout(location = 1) out vec4 flakes;  // their light apart, as not all samples have it

uint mixBits(uint x) {
    x = (x ^ (x >> 16)) * 0x7feb352du;
    x = (x ^ (x >> 15)) * 0x846ca68bu;
    return x ^ (x >> 16);
}
uint pixelBits, number;
/// Numbers in [0, 1) that fill the square evenly from sample to sample, shifted by pixel.
vec2 evenly(uint which) {
    uint a = mixBits(pixelBits + which * 0x9e3779b9u), b = mixBits(a);
    return vec2((uvec2(a, b) + number * uvec2(3242174889u, 2447445413u)) >> 8) * 0x1p-24_;
}
float evenlyOne(uint which) {
    return float((mixBits(pixelBits ^ (which * 0x85ebca6bu)) + number * 2654435769u) >> 8) * 0x1p-24_;
}

vec2 placeOf(vec3 w) {
    float u = (azimuth - atan(w.y, w.x)) / (2. * PI) + .5;
    return vec2(u - floor(u), acos(clamp(w.z, -1., 1.)) / PI);
}
vec3 fromAfar(vec3 w) { return textureLod(surroundings, placeOf(w), 0.).rgb; }

float columnAt(int x, int y) { return x < 0 ? 0. : texelFetch(byColumn, ivec2(x, y), 0).r; }
float rowAt(int y) { return y < 0 ? 0. : texelFetch(byRow, ivec2(y, 0), 0).r; }
/// Density per solid angle of drawFromAfar() in a texel.
float densityOf(ivec2 texel, ivec2 texels) {
    float top = PI * float(texel.y) / float(texels.y), bottom = PI * float(texel.y + 1) / float(texels.y);
    float solidAngle = 2. * PI / float(texels.x) * (cos(top) - cos(bottom));
    return (columnAt(texel.x, texel.y) - columnAt(texel.x - 1, texel.y)) *
           (rowAt(texel.y) - rowAt(texel.y - 1)) / solidAngle;
}
float densityFromAfar(vec3 w) {
    ivec2 texels = textureSize(byColumn, 0);
    return densityOf(min(ivec2(placeOf(w) * vec2(texels)), texels - 1), texels);
}
vec3 drawFromAfar(vec2 u) {
    ivec2 texels = textureSize(byColumn, 0);
    int y = 0;
    int high = texels.y - 1;
    do {
        int middle = (y + high) / 2;
        if (rowAt(middle) > u.y) high = middle; else y = middle + 1;
    } while (y < high);
    int x = 0;
    high = texels.x - 1;
    do {
        int middle = (x + high) / 2;
        if (columnAt(middle, y) > u.x) high = middle; else x = middle + 1;
    } while (x < high);
    float left = columnAt(x - 1, y), above = rowAt(y - 1);
    vec2 part = clamp(vec2((u.x - left) / max(columnAt(x, y) - left, 1e-20),
                           (u.y - above) / max(rowAt(y) - above, 1e-20)), 0., 1.);
    float top = cos(PI * float(y) / float(texels.y)), bottom = cos(PI * float(y + 1) / float(texels.y));
    float z = mix(top, bottom, part.y), r = sqrt(max(1. - z * z, 0.));
    float turn = azimuth - 2. * PI * ((float(x) + part.x) / float(texels.x) - .5);
    return vec3(r * cos(turn), r * sin(turn), z);
}

/// How far a rectangle is, in units of w; negative: w misses it.
float distanceTo(int k, vec3 place, vec3 w) {
    float facing = dot(rectangleNormal[k], w);
    if (abs(facing) < 1e-6) return -1.;
    float far = dot(rectangleNormal[k], corner[k] - place) / facing;
    vec3 at = place + far * w - corner[k];
    float u = dot(at, edgeU[k]) / dot(edgeU[k], edgeU[k]), v = dot(at, edgeV[k]) / dot(edgeV[k], edgeV[k]);
    return far > 0. && u >= 0. && u <= 1. && v >= 0. && v <= 1. ? far : -1.;
}
/// Radiance from w; density: per solid angle of drawing it from a rectangle that it meets.
vec3 radianceFrom(vec3 place, vec3 w, out float density) {
    float nearest = 1e30;
    int met = -1;
    for (int k = 0; k < rectangleCount; ++k) {
        float far = distanceTo(k, place, w);
        if (far > 0. && far < nearest) { nearest = far; met = k; }
    }
    density = 0.;
    if (met < 0) return fromAfar(w);
    float facing = -dot(rectangleNormal[met], w);
    if (facing <= 0.) return vec3(0.);
    density = nearest * nearest / (facing * length(cross(edgeU[met], edgeV[met])));
    return rectangleRadiance[met];
}

const float EVEN = .3;  // the part of the paint's directions that are drawn evenly
float densityOfPaint(vec3 wi, vec3 wo) {
    float sum = 0.;
    int count = int(nacreLobeCount), k = 0;
    do sum += nacreDensity(k, wi, wo); while (++k < count);
    return EVEN * wo.z / PI + (1. - EVEN) / float(count) * sum;
}
${FLAKES}
vec3 shaded(vec3 place, vec3 n, vec3 view, out vec3 ofFlakes) {
    vec3 t = normalize(abs(n.x) < .9 ? cross(n, vec3(1., 0., 0.)) : cross(n, vec3(0., 1., 0.)));
    mat3 toWorld = mat3(t, cross(n, t), n);
    vec3 wi = view * toWorld;
    wi = normalize(vec3(wi.xy, max(wi.z, 1e-3)));
    // Towards a place on the sun; below the horizon: there is none.
    vec3 towardsSun = vec3(0., 0., -1.);
    if (sun.w < 1.5) {
        vec2 u = evenly(6u);
        float z = 1. - u.x * (1. - sun.w), r = sqrt(max(1. - z * z, 0.)), phi = 2. * PI * u.y;
        vec3 s = normalize(abs(sun.x) < .9 ? cross(sun.xyz, vec3(1., 0., 0.)) : cross(sun.xyz, vec3(0., 1., 0.)));
        towardsSun = (r * cos(phi) * s + r * sin(phi) * cross(sun.xyz, s) + z * sun.xyz) * toWorld;
    }
    ofFlakes = shadedFlakes(place, toWorld, wi, towardsSun);
    vec3 sum = vec3(0.);
    // Directions from the paint, from afar and from each rectangle, and at last to the sun. Processors that draw in
    // place of a card compute both sides of an if, and a loop's body once more than it runs where it is asked at
    // its beginning, here and in what it calls.
    float which = evenlyOne(7u);
    vec2 u = evenly(0u);
    float r = sqrt(u.x), phi = 2. * PI * u.y;
    vec3 ofPaint = nacreDraw(clamp(int((which - EVEN) / (1. - EVEN) * nacreLobeCount), 0, int(nacreLobeCount) - 1), wi, u);
    if (which < EVEN) ofPaint = vec3(r * cos(phi), r * sin(phi), sqrt(1. - u.x));
    vec3 fromFar = drawFromAfar(evenly(1u));
    int toSun = 2 + rectangleCount, ways = towardsSun.z > 1e-4 ? toSun + 1 : toSun, way = 0;
    do {
        vec3 wo = ofPaint, w = toWorld * wo, radiance;
        float scale = 0.;
        if (way > 0) {
            u = evenly(uint(way));
            int k = min(max(way - 2, 0), ${String(MOST_RECTANGLES - 1)});
            w = way == 1 ? fromFar : normalize(corner[k] + u.x * edgeU[k] + u.y * edgeV[k] - place);
            wo = w * toWorld;
        }
        if (way == toSun) {
            nacreWithoutSunlit();
            wo = towardsSun;
            radiance = sunRadiance;
            scale = 2. * PI * (1. - sun.w) * wo.z;
        } else if (wo.z > 1e-4) {
            float density;
            radiance = radianceFrom(place, w, density);
            density += densityFromAfar(w) + densityOfPaint(wi, wo);
            if (max(radiance.r, max(radiance.g, radiance.b)) > 0.) scale = wo.z / density;
        }
        if (scale > 0.) sum += nacreColour(wi, wo) * radiance * scale;
        ++way;
    } while (way < ways);
#if ${smoothCoat ? "1" : "0"}
    vec3 mirrored = toWorld * vec3(-wi.xy, wi.z);
    float ignored;
    vec3 image = radianceFrom(place, mirrored, ignored);
    if (dot(mirrored, sun.xyz) > sun.w) image += sunRadiance;
    sum += nacreFresnel(wi.z) * image;
#endif
    return sum;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    pixelBits = interleaved > 0 ? 0u : mixBits(uint(pixel.x) + mixBits(uint(pixel.y)));
    number = sampleIndex;
    if (interleaved > 0) {
        ivec2 within = pixel % interleaved;
        number += ${String(APART)}u * uint(within.x + interleaved * within.y);
    }
    vec4 place = texelFetch(placeAt, pixel, 0);
    vec3 value, ofFlakes = vec3(0.);
    if (place.w == 0.) {
        vec2 at = (gl_FragCoord.xy + shift) / size * 2. - 1.;
        float ignored;
        value = radianceFrom(eye, normalize(ahead + at.x * across + at.y * upwards), ignored);
    } else {
        vec3 view = normalize(eye - place.xyz), n = texelFetch(facingAt, pixel, 0).xyz;
        value = shaded(place.xyz, dot(n, view) < -.1 ? -n : n, view, ofFlakes);
    }
    // What is not finite would stay for good.
    light = vec4(dot(value, value) < 1e12 ? value : vec3(0.), 1.);
    flakes = vec4(dot(ofFlakes, ofFlakes) < 1e12 ? ofFlakes : vec3(0.), flakesSampled ? 1. : 0.);
}`.replaceAll("0x1p-24_", "5.9604644775390625e-8");
}

const MEANS = `
vec4 mean(vec4 sum) { return sum.a > 0. ? vec4(sum.rgb / sum.a, 1.) : vec4(0.); }
float brightness(vec3 light) { return max(dot(light, vec3(.2126, .7152, .0722)), 0.); }
vec3 lightOf(sampler2D sums, sampler2D flakes, ivec2 pixel) {
    return mean(texelFetch(sums, pixel, 0)).rgb + mean(texelFetch(flakes, pixel, 0)).rgb;
}
`;

/** Of a picture, around the pixels of one that is as coarse or coarser. */
export const AVERAGE = `${HEAD}${MEANS}
uniform sampler2D sums;
uniform sampler2D sumsOfFlakes;
uniform vec2 size;
out vec4 around;
void main() {
    vec2 step = vec2(textureSize(sums, 0)) / size;
    ivec2 begin = ivec2(floor((gl_FragCoord.xy - .5) * step)), end = ivec2(ceil((gl_FragCoord.xy + .5) * step));
    end = min(end, textureSize(sums, 0));
    vec4 sum = vec4(0.);
    for (int y = begin.y; y < end.y; ++y) for (int x = begin.x; x < end.x; ++x) {
        bool known = texelFetch(sums, ivec2(x, y), 0).a > 0.;
        if (known) sum += vec4(lightOf(sums, sumsOfFlakes, ivec2(x, y)), 1.);
    }
    around = min(mean(sum), 65504.); // the largest half float
}`;

/**
 * Of a coarse picture of few samples, around its own pixels along one of its axes: where the shape faces the same
 * way, as each of them has looked in directions of its own. Weights fall towards the ends: where `width` pixels share
 * out the directions, all of these weigh the same, and no sample has an edge.
 */
export const SMOOTH = `${HEAD}${MEANS}
uniform sampler2D sums;
uniform sampler2D placeAt;
uniform sampler2D facingAt;
uniform vec2 along;
uniform int width;
out vec4 around;
void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy), last = textureSize(sums, 0) - 1;
    vec3 facing = texelFetch(facingAt, pixel, 0).xyz;
    int reach = texelFetch(placeAt, pixel, 0).w > 0. ? width : 1; // what lies behind has no noise
    vec4 sum = vec4(0.);
    for (int k = 1 - reach; k < reach; ++k) {
        ivec2 at = clamp(pixel + k * ivec2(along), ivec2(0), last);
        bool alike = k == 0 || dot(texelFetch(facingAt, at, 0).xyz, facing) > .8;
        if (alike) sum += float(reach - abs(k)) * mean(texelFetch(sums, at, 0));
    }
    around = min(mean(sum), 65504.);
}`;

/** How much brighter each pixel of a picture is than it is on average around a coarser one's. */
export const GLITTER = `${HEAD}${MEANS}
uniform sampler2D sums;
uniform sampler2D sumsOfFlakes;
uniform sampler2D means;  // filtered between its pixels, which are larger
out float glitter;
void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float around = brightness(mean(texture(means, gl_FragCoord.xy / vec2(textureSize(sums, 0)))).rgb);
    float here = brightness(lightOf(sums, sumsOfFlakes, pixel));
    glitter = around > 1e-4 ? min(here / around, 65504.) : 1.;
}`;

/** What is on the screen: a coarse picture, the whole one, or each where the whole one has samples enough. */
export type Shown = "coarse" | "whole" | "both";

/**
 * To the screen, as the program writes PNGs: clipped, sRGB. Each its own shader: processors that draw in place of
 * a card compute both sides of an if.
 */
export function display(shown: Shown): string {
    const [hasCoarse, hasWhole] = [shown !== "whole", shown !== "coarse"].map(Number);
    return `${HEAD}${MEANS}
#define HAS_COARSE ${String(hasCoarse)}
#define HAS_WHOLE ${String(hasWhole)}
uniform sampler2D whole;
uniform sampler2D wholeFlakes;
uniform sampler2D coarseMeans;  // filtered between its pixels, which are larger
uniform sampler2D glitter;      // of the picture before; one texel where there is none
uniform vec2 size;
uniform float enough;  // samples
uniform bool warn;     // of colours outside the gamut
out vec4 seen;
void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 light = vec4(0.);
#if HAS_WHOLE
    light = texelFetch(whole, pixel, 0);
    float samples = light.a;
    light = mean(light);
    light.rgb += mean(texelFetch(wholeFlakes, pixel, 0)).rgb;
#endif
#if HAS_COARSE
    vec2 at = gl_FragCoord.xy / size;
    vec4 coarse = mean(texture(coarseMeans, at));
    coarse.rgb *= texture(glitter, at).r;
#if HAS_WHOLE
    if (samples < enough) light = coarse;
#else
    light = coarse;
#endif
#endif
    vec3 linear = light.rgb, clipped = clamp(linear, 0., 1.);
    vec3 encoded = mix(12.92 * clipped, 1.055 * pow(max(clipped, 1e-6), vec3(1. / 2.4)) - .055,
                       vec3(greaterThan(clipped, vec3(.0031308))));
    // Stripes where a component is negative by more than rounding.
    float lowest = min(linear.r, min(linear.g, linear.b)), scale = max(linear.r, max(linear.g, linear.b));
    bool stripe = mod(gl_FragCoord.x + gl_FragCoord.y, 12.) < 4.;
    if (warn && stripe && lowest < -.002 - .01 * scale) encoded = vec3(.5);
    seen = light.a > 0. ? vec4(encoded, 1.) : vec4(0.);  // else what lies behind the canvas is seen
}`;
}
