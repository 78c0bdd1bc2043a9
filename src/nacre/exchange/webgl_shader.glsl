// The mean of the model nacre in RGB (docs/microflake.md, docs/nacre-model.md), from the arrays of one
// paint.
// Directions are unit vectors that point away from the surface, z being its normal.

precision highp sampler3D;
uniform sampler2D nacreTable;   // functions of a place in [0, 1] down the rows, 4 wavelengths a texel
uniform sampler3D nacreSmooth;  // multiple scattering; under a rough coat single too, whose luminance is alpha

@STRUCTURE@
@NUMBERS@

vec4 nacreRow(int channel, int group, float place) {
    float y = clamp(place, 0., 1.) * float(NACRE_ROWS - 1);
    int low = min(int(y), NACRE_ROWS - 2), x = 4 * channel + group;
    return mix(texelFetch(nacreTable, ivec2(x, low), 0), texelFetch(nacreTable, ivec2(x, low + 1), 0),
               y - float(low));
}

struct NacrePair {
    vec3 i, o;          // inside the coat
    float xi, xo;       // tan(theta / 2) outside
    float slope2, sec2; // of the half vector inside
    float cosine;       // on a flake that reflects one into the other
    float turned;       // cosine between i and o
    float spread;       // of both rays, by a step in height
    float coat2;        // square of the alpha by which a rough coat spreads half vectors
};

@FLAKES@
vec3 nacreRefract(vec3 w, float ior) {
    vec2 xy = w.xy / ior;
    return vec3(xy, sqrt(max(1. - dot(xy, xy), 0.)));
}

#if !NACRE_SMOOTH_COAT
// sparkle::CoatTilt: cosines are those inside a smooth coat.
float nacreTurned(float mu) {
    return mu - sqrt(max(mu * mu - 1. + 1. / (nacreIor * nacreIor), 0.));
}
float nacreCoat2(float mi, float mo) {
    vec2 k = nacreRoughness * vec2(nacreTurned(mi), nacreTurned(mo)) / max(mi + mo, .1);
    return dot(k, k);
}
/// What one ray adds to the variance of a component of the distance of both.
float nacreApart(float mu) {
    float k = nacreRoughness * nacreTurned(mu), secant2 = 1. / (max(mu, .1) * max(mu, .1));
    return k * k * secant2 * .25 * (1. + secant2 * secant2);
}
#endif

NacrePair nacrePair(vec3 wi, vec3 wo) {
    NacrePair p;
    p.i = nacreRefract(wi, nacreIor);
    p.o = nacreRefract(wo, nacreIor);
    p.xi = length(wi.xy) / (1. + wi.z);
    p.xo = length(wo.xy) / (1. + wo.z);
    vec3 h = p.i + p.o;
    p.slope2 = dot(h.xy, h.xy) / (h.z * h.z);
    p.sec2 = 1. + p.slope2;
    p.cosine = min(.5 * h.z * sqrt(p.sec2), 1.);
    p.turned = dot(p.i, p.o);
    vec2 apart = p.i.xy / p.i.z - p.o.xy / p.o.z;
    float square = dot(apart, apart);
#if NACRE_SMOOTH_COAT
    p.coat2 = 0.;
#else
    p.coat2 = nacreCoat2(p.i.z, p.o.z);
    float variance = max(nacreApart(p.i.z) + nacreApart(p.o.z), 1e-12);
    square += variance * (1. + (.5 * PI - 1.) / (1. + .5 * square / variance));
#endif
    p.spread = clamp(sqrt(square), 1e-4, 1e6);
    return p;
}

vec4 nacreBoth(int channel, int g, NacrePair p) {
    return nacreRow(channel, g, p.xi) * nacreRow(channel, g, p.xo);
}

vec4 nacreRate(int channel, int g, NacrePair p) {
    return nacreRow(channel, g, p.xi) / p.i.z + nacreRow(channel, g, p.xo) / p.o.z;
}

/// flake: half its area per volume over 2 pi alpha^2, and alpha.
float nacreLobe(vec2 flake, NacrePair p) {
    float own2 = flake.y * flake.y, alpha2 = own2 + p.coat2;
    return flake.x * (own2 / alpha2) * exp(-min(p.slope2 / alpha2, 80.)) * p.sec2 * sqrt(p.sec2);
}

float nacreHenyeyGreenstein(float g, float turned) {
    float turn = max(1. + g * g + 2. * g * turned, 1e-6);
    return (1. - g * g) / (4. * PI) / (turn * sqrt(turn));
}

vec4 nacreEscape(vec4 x) {
    vec4 large = max(x, 1e-2);
    return mix(1. - x * (.5 - x / 6.), (1. - exp(-large)) / large, vec4(greaterThanEqual(x, vec4(1e-2))));
}

vec3 nacreRgb(vec4 x, int g) {
    return vec3(dot(nacreRed[g], x), dot(nacreGreen[g], x), dot(nacreBlue[g], x));
}

#if NACRE_GAPS
// Of the hot spot of large flakes: light that came in through a gap finds it again on its way out.
const float NACRE_FARTHEST = @FARTHEST@;  // optical depths, beyond which 6e-6 of the light comes from
const int NACRE_NODES = @NODE_COUNT@;
const vec2 NACRE_NODE[NACRE_NODES] = @NODES@;  // places in a layer, and weights

/// Over t from 0 to x of the overlap of two discs t diameters apart.
float nacreOverlap(float x) {
    x = min(x, 1.);
    float chord = sqrt(max(1. - x * x, 0.));
    return 2. / PI * (x * acos(x) - chord + chord * chord * chord / 3. + 2. / 3.);
}

/// Length over which both rays are shared, up to `far` above the flake or ground and from `near` on.
float nacreShared(float far, float near, float perHeight) {
    float overlap = nacreOverlap(far * perHeight);
    if (near > 0.) overlap -= nacreOverlap(near * perHeight);
    return overlap / perHeight;
}
#endif

float nacreLeast(vec4 x) { return min(min(x.x, x.y), min(x.z, x.w)); }

struct NacreLight {
    vec3 once;     // met one flake or particle
    vec3 ground;   // gained from below through gaps
    vec3 compensation;  // what is left of all other light
};

/// Without what the interface turns away. whole: with the mean of the flakes that are shown one by one.
NacreLight nacreLight(NacrePair p, bool whole) {
    vec3 once = vec3(0.), ground = vec3(0.), rest = vec3(0.);
    vec4 depth[4], here[4], kernel[4], escape[4], compensation;
    float reach, lobe, angle, path = 1. / p.i.z + 1. / p.o.z;
    int node;
    @DEPTHS@
    @LAYERS@
    return NacreLight(once / (p.i.z * p.o.z), ground, rest);
}

/// From the table of what is not closed.
vec4 nacreTabulated(vec3 wi, vec3 wo, NacrePair p) {
    float a = min(max(p.xi, p.xo), 1.), b = abs(p.xi - p.xo) / max(a, 1e-12);
    float si = length(wi.xy), so = length(wo.xy), scale = 4. * si * si * so * so;
    vec2 u = si * wo.xy + so * wi.xy;
    float q2 = scale > 1e-14 ? min(dot(u, u) / scale, 1.) : 0.;
    vec3 size = vec3(textureSize(nacreSmooth, 0));
    vec3 at = vec3(sqrt(sqrt(q2)), sqrt(b), sqrt(a));
    return texture(nacreSmooth, (at * (size - 1.) + .5) / size) / (p.i.z + p.o.z);
}

float nacreFresnel(float cosine) {
    float inside = sqrt(max(1. - (1. - cosine * cosine) / (nacreIor * nacreIor), 0.));
    float s = (cosine - nacreIor * inside) / (cosine + nacreIor * inside);
    float p = (inside - nacreIor * cosine) / (inside + nacreIor * cosine);
    return .5 * (s * s + p * p);
}

#if !NACRE_SMOOTH_COAT
vec3 nacreInterface(vec3 wi, vec3 wo, NacrePair p) {
    vec3 h = wi + wo;
    float tan2 = dot(h.xy, h.xy) / (h.z * h.z), sec2 = 1. + tan2, a2 = nacreRoughness * nacreRoughness;
    float facets = exp(-min(tan2 / a2, 60.)) / (PI * a2) * sec2 * sec2;
    float masking = nacreBoth(NACRE_MASKING, 0, p).x;
    vec3 masked = vec3(0.);
    for (int g = 0; g < 4; ++g) masked += nacreRgb(nacreBoth(NACRE_MASKED, g, p), g);
    return masked + .25 * facets * masking * nacreFresnel(min(.5 * length(h), 1.));
}

/// Light that was scattered once, as the table has it, over that of the closed form under a smooth coat
/// (BoundMicroflake::rough_ratio()): by luminance, as interface and coat are nearly grey and RGB may be
/// next to 0.
float nacreOverClosed(vec4 tabulated, vec3 once) {
    const vec3 LUMINANCE = vec3(.2126, .7152, .0722);
    float closed = dot(LUMINANCE, once);
    return closed > 1e-20 ? min(tabulated.a, dot(LUMINANCE, tabulated.rgb)) / closed : 0.;
}
#endif

/// In 1/sr, linear Rec. 709, without the mirror image in a smooth coat: that is nacreFresnel(). Colours
/// outside the gamut have negative components.
vec3 nacreColour(vec3 wi, vec3 wo) {
    NacrePair p = nacrePair(wi, wo);
    vec4 tabulated = nacreTabulated(wi, wo, p);
    vec3 value = tabulated.rgb;
#if NACRE_SMOOTH_COAT
    NacreLight light = nacreLight(p, false);
    value = light.compensation * value + light.ground + light.once;
    value *= (1. - nacreFresnel(wi.z)) * (1. - nacreFresnel(wo.z)) / (nacreIor * nacreIor);
#else
    value += nacreInterface(wi, wo, p);
#ifdef NACRE_FLAKES
    vec3 once = nacreLight(p, true).once;
    value += nacreOverClosed(tabulated, once) * (nacreLight(p, false).once - once);
#endif
#endif
    return value;
}

/// The same, clipped to the gamut.
vec3 nacreBrdf(vec3 wi, vec3 wo) {
    return max(nacreColour(wi, wo), 0.);
}

#if NACRE_ALBEDO >= 0
/// Of the light from everywhere, the mirror image included.
vec3 nacreAlbedo(float cosine) {
    return nacreRow(NACRE_ALBEDO, 0, sqrt(max(1. - cosine * cosine, 0.)) / (1. + cosine)).rgb;
}
#endif

// Directions in which the surroundings are looked at: those of flakes, and evenly. A lobe is Beckmann's
// alpha, and the index of the medium; the first nacreLobeCount are there.

/// Below the horizon where none leaves.
vec3 nacreDraw(int lobe, vec3 wi, vec2 u) {
    float alpha = nacreLobes[lobe].x, ior = nacreLobes[lobe].y;
    float r = alpha * sqrt(-log(1. - u.x)), phi = 2. * PI * u.y;
    vec3 m = normalize(vec3(r * cos(phi), r * sin(phi), 1.)), i = nacreRefract(wi, ior);
    vec3 o = 2. * dot(i, m) * m - i;
    vec2 xy = ior * o.xy;
    float z2 = 1. - dot(xy, xy);
    return o.z > 0. && z2 > 0. ? vec3(xy, sqrt(z2)) : vec3(0., 0., -1.);
}

/// Its density per solid angle.
float nacreDensity(int lobe, vec3 wi, vec3 wo) {
    float alpha = nacreLobes[lobe].x, ior = nacreLobes[lobe].y;
    vec3 i = nacreRefract(wi, ior), o = nacreRefract(wo, ior), h = i + o;
    float slope2 = dot(h.xy, h.xy) / (h.z * h.z);
    float slopes = exp(-min(slope2 / (alpha * alpha), 80.)) / (PI * alpha * alpha);
    return slopes * .5 * (1. + slope2) / h.z * wo.z / (ior * ior * o.z);
}
