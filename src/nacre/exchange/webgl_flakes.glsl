// Single flakes: those of sparkle/flake_field.h on the patch of a surface that a sample looks at, hashed
// by the same integers. Whoever includes this defines nacreRadiance().

/// From the direction wo of the surface's frame, without lights narrower than a flake's lobe.
vec3 nacreRadiance(vec3 wo);

const int NACRE_LEVELS = @LEVEL_COUNT@;
const float NACRE_DENSEST = @DENSEST@;  // of all flakes, the fraction in the densest level
const int NACRE_SIZES[NACRE_FLAKES] = @SIZES@;           // channels of the table: diameters, um
const int NACRE_LAYERS[NACRE_FLAKES] = @OWN_LAYERS@;
const int NACRE_REFLECTANCES[NACRE_FLAKES] = @REFLECTANCES@;  // channels by the cosine on the flake
const int NACRE_EXTINCTIONS[NACRE_FLAKES] = @EXTINCTIONS@;  // channels, of their layers
const float NACRE_LOBE_POWER = @LOBE_POWER@;
uniform sampler2D nacreLobeShapes;
uniform sampler2D nacreFilms;

// ------------------------------------------------------------------------------------------ bits

// 64 bits are two of 32, the lower first.
uint nacreHighProduct(uint a, uint b) {
    uint a0 = a & 0xffffu, a1 = a >> 16, b0 = b & 0xffffu, b1 = b >> 16;
    uint middle = a1 * b0 + ((a0 * b0) >> 16), other = a0 * b1 + (middle & 0xffffu);
    return a1 * b1 + (middle >> 16) + (other >> 16);
}
uvec2 nacreProduct(uvec2 a, uvec2 b) {
    return uvec2(a.x * b.x, nacreHighProduct(a.x, b.x) + a.x * b.y + a.y * b.x);
}
uvec2 nacreSum(uvec2 a, uvec2 b) {
    uint low = a.x + b.x;
    return uvec2(low, a.y + b.y + uint(low < a.x));
}
uvec2 nacreShifted(uvec2 a, int right) { return uvec2(a.x >> right | a.y << (32 - right), a.y >> right); }

const uvec2 NACRE_GOLDEN = uvec2(0x7f4a7c15u, 0x9e3779b9u);
const uint NACRE_SHORT_GOLDEN = 0x9e3779b9u;

/// [steele-2014]
uvec2 nacreMix(uvec2 x) {
    x = nacreProduct(x ^ nacreShifted(x, 30), uvec2(0x1ce4e5b9u, 0xbf58476du));
    x = nacreProduct(x ^ nacreShifted(x, 27), uvec2(0x133111ebu, 0x94d049bbu));
    return x ^ nacreShifted(x, 31);
}
/// [wellons-2018]
uint nacreShortMix(uint x) {
    x = (x ^ (x >> 16)) * 0x7feb352du;
    x = (x ^ (x >> 15)) * 0x846ca68bu;
    return x ^ (x >> 16);
}
/// hash_of() two integers of 32 bits.
uvec2 nacreHash(uint a, uint b) {
    uvec2 h = nacreMix(nacreSum(uvec2(2u ^ a, 0u), NACRE_GOLDEN));
    return nacreMix(nacreSum(h ^ uvec2(b, 0u), NACRE_GOLDEN));
}
/// Of a cell of one of the six sides of object space, from which all its flakes are made.
uvec2 nacreCellKey(uvec2 level, int side, int u, int v) {
    uvec2 key = nacreSum(level, nacreProduct(uvec2(uint(side), 0u), NACRE_GOLDEN));
    return nacreMix(key ^ uvec2(uint(u), uint(v)));
}
/// Place and kind of the flake number n, from 0.
uvec2 nacreFlakeBits(uvec2 cell, int n) {
    uint step = uint(n + 1) * NACRE_SHORT_GOLDEN;
    return uvec2(nacreShortMix(cell.x + step), nacreShortMix(cell.y + step));
}
/// Flakes of a cell: one more than n if `draw` is not below the probability of at most n.
int nacreCount(float draw) {
    vec4 count = vec4(0.);
    @COUNTS@
    return int(count.x + count.y + count.z + count.w);
}
float nacreUnit(uint bits) { return float(bits >> 8) * exp2(-24.); }
float nacreFraction(uint bits) { return (float(bits >> 1) + .5) * exp2(-31.); }
/// Of variance 1/2 each.
vec2 nacreSlopes(uvec2 flake) {
    float u = nacreFraction(nacreShortMix(flake.x + NACRE_SHORT_GOLDEN * flake.y));
    float turns = nacreFraction(nacreShortMix(flake.y ^ (flake.x >> 7) ^ (flake.x << 25)));
    return sqrt(max(-log(u), 0.)) * vec2(cos(2. * PI * turns), sin(2. * PI * turns));
}

// ----------------------------------------------------------------------------------------- lobes

/// ln of the blur over the square of the width, and of the inverse of the lobes' fraction: over
/// (slope / alpha)^2 and width / alpha.
vec2 nacreLobeTable(float exponent, float width) {
    ivec2 last = textureSize(nacreLobeShapes, 0) - 1;
    vec2 at = min(vec2(exponent / @MAX_EXPONENT@, width / @MAX_WIDTH@), .99999) * vec2(last);
    ivec2 low = ivec2(at);
    vec2 part = at - vec2(low);
    vec2 a = mix(texelFetch(nacreLobeShapes, low, 0).xy,
                 texelFetch(nacreLobeShapes, low + ivec2(1, 0), 0).xy, part.x);
    vec2 b = mix(texelFetch(nacreLobeShapes, low + ivec2(0, 1), 0).xy,
                 texelFetch(nacreLobeShapes, low + 1, 0).xy, part.x);
    return mix(a, b, part.y);
}
/// DiffractionLobe::widening()
float nacreWidening(float sec2, float cosine) {
    float sec = sqrt(sec2);
    return sec * sqrt(sec) / max(cosine, .1);
}
float nacreExponent(int s, float slope2) { return slope2 / (nacreField[s].y * nacreField[s].y); }
bool nacreReaches(int s, float slope2) { return nacreExponent(s, slope2) < @MAX_EXPONENT@; }
/// What waviness, and a rough coat along a way in and out, add to the square of a lobe's radius.
float nacreSpread2(int s, float mi, float mo) {
#if NACRE_SMOOTH_COAT
    return 3.6 * nacreFieldSize[s].z;
#else
    return 3.6 * (nacreFieldSize[s].z + nacreCoat2(mi, mo));
#endif
}

/// How a patch shows a species: FlakeView. Levels fade out where it touches more cells than `full`, the
/// finest two where it touches more than `finest`.
struct NacreShown {
    float resolved, widening, scale, full;
    vec2 finest;
};

/// FlakeView::resolved_factor()
float nacreResolvedFactor(int s, NacrePair p, float resolved, float widening) {
    float exponent = nacreExponent(s, p.slope2);
    float radius = nacreFieldLevels[s].y * nacreWidening(p.sec2, p.cosine);
    float relative = nacreExponent(s, nacreFieldSize[s].z + p.coat2), narrower = 1. / (1. + relative);
    float power = relative > 0. ? max(NACRE_LOBE_POWER, 1. - .2 * radius * inversesqrt(relative))
                                : NACRE_LOBE_POWER;
    float inverse = exp(nacreLobeTable(exponent * narrower, radius * sqrt(narrower)).y);
    float lobes = 1. / max(1., NACRE_LOBE_POWER / power * inverse);
    if (widening == 1.) return lobes;
    float bend = (exponent - 1.) * (radius * radius + 3.6 * relative) / 3.;
    float bound = resolved > 0. ? 1. / resolved : 1.;
    return min(bound, lobes * sqrt(max(1. - bend, .25) / max(1. - widening * widening * bend, .25)));
}

// What the patch does not show of the flakes, the mean takes the place of: nacreRest().
float nacreResolved[NACRE_FLAKES];
float nacreWidened[NACRE_FLAKES];
void nacreShowNone() {
    for (int s = 0; s < NACRE_FLAKES; ++s) nacreResolved[s] = 0.;
}
float nacreRest(int s, NacrePair p) {
    if (nacreResolved[s] == 0. || !nacreReaches(s, p.slope2)) return 1.;
    return 1. - nacreResolved[s] * nacreResolvedFactor(s, p, nacreResolved[s], nacreWidened[s]);
}

/// Cells of a level that a patch touches.
float nacreCells(int s, vec2 side, float cell) {
    vec2 cells = 1. + (side + 2. * nacreFieldSize[s].y) / cell;
    return cells.x * cells.y;
}
/// The weight of a level of cells of this side.
float nacreFaded(int s, vec2 side, float cell, NacreShown shown) {
    float level = cell / nacreField[s].x;
    float full = level < 2. ? shown.finest.x : level < 8. ? shown.finest.y : shown.full;
    float t = clamp((2.3 - nacreCells(s, side, cell) / full) / 1.3, 0., 1.);
    return t * t;
}
/// FlakeField::level_weights(). lightArea: of a light in slopes over that of a lobe; above 1 it is wide.
NacreShown nacreLevels(int s, vec2 side, float lightArea) {
    bool wide = lightArea > 1.;
    float cell = nacreField[s].x;
    NacreShown shown = NacreShown(1., 1., 1., nacreFieldLevels[s].x, vec2(@FINEST_CELLS@));
    if (nacreCells(s, side, cell) <= shown.finest.x) {
        shown.full = 1e30;
        shown.finest = vec2(1e30);
        return shown;
    }
    float first = 0., second = 0., fraction = NACRE_DENSEST;
    for (int l = 0; l < NACRE_LEVELS; ++l, cell *= 4., fraction *= 1. / 16.) {
        float weight = nacreFaded(s, side, cell, shown);
        first += weight * fraction;
        second += weight * weight * fraction;
    }
    shown.resolved = 0.;
    if (second > 0.) {
        float ratio = sqrt(second) / first;
        if (!wide) shown.widening = clamp(.95 * ratio, 1., max(nacreFieldLevels[s].z, 1.));
        float contrast =
            wide ? 1. : sqrt((shown.widening * shown.widening + lightArea) / (1. + lightArea));
        shown.resolved = min(contrast / ratio, 1.);
        shown.scale = shown.resolved / first;
    }
    return shown;
}

// ----------------------------------------------------------------------------------------- patch

/// ObjectSpaceFootprint
struct NacrePatch {
    vec3 position, normal, tangent;  // in object space, mm
    vec3 edgeA, edgeB;
    vec2 tilt;
};

// No arrays here and below: WebGL keeps those that are indexed by variables in slow memory.

/// PatchOutline: in the patch's own plane, x along its tangent. A side is an edge, its direction, that
/// across it, its length and half the width of the strip along it.
struct NacreOutline {
    vec2 edgeA, alongA, acrossA, edgeB, alongB, acrossB;
    vec2 side, halfWidth, tilt;
    float area;
    bool isPoint;
};

float nacreCross(vec2 a, vec2 b) { return a.x * b.y - a.y * b.x; }

NacreOutline nacreOutline(NacrePatch seen, float smallest) {
    NacreOutline o;
    vec3 t = seen.tangent, b = cross(seen.normal, t);
    vec2 first = vec2(dot(seen.edgeA, t), dot(seen.edgeA, b));
    vec2 second = vec2(dot(seen.edgeB, t), dot(seen.edgeB, b));
    o.isPoint = length(first) + length(second) < .05 * smallest;
    float least = 1e-3 * smallest;
    if (!o.isPoint) {
        float a = abs(nacreCross(first, second));
        if (length(second) > length(first)) {
            if (a < least * length(second)) {
                first = vec2(-second.y, second.x) * (least / length(second));
            }
        } else if (a < least * length(first)) {
            second = vec2(-first.y, first.x) * (least / length(first));
        }
    }
    bool swapped = nacreCross(first, second) < 0.;
    o.edgeA = swapped ? second : first;
    o.edgeB = swapped ? first : second;
    o.tilt = swapped ? seen.tilt.yx : seen.tilt;
    o.side = vec2(length(o.edgeA), length(o.edgeB));
    o.alongA = o.side.x > 0. ? o.edgeA / o.side.x : vec2(0., -1.);
    o.alongB = o.side.y > 0. ? o.edgeB / o.side.y : vec2(1., 0.);
    o.acrossA = vec2(-o.alongA.y, o.alongA.x);
    o.acrossB = vec2(-o.alongB.y, o.alongB.x);
    o.halfWidth = .5 * vec2(abs(dot(o.acrossA, o.edgeA)) + abs(dot(o.acrossA, o.edgeB)),
                            abs(dot(o.acrossB, o.edgeA)) + abs(dot(o.acrossB, o.edgeB)));
    o.area = nacreCross(o.edgeA, o.edgeB);
    return o;
}

bool nacreTouches(NacreOutline o, vec2 at, float radius) {
    vec2 apart = abs(vec2(dot(o.acrossA, at), dot(o.acrossB, at)));
    return all(lessThan(apart, o.halfWidth + radius));
}

/// Of one side, seen from the middle of a disc: twice the area of triangles, and the angle of sectors.
void nacreSide(vec2 from, vec2 along, float side, float radius2, inout vec2 sums, inout bool inside) {
    float off = nacreCross(from, along), t = dot(from, along);
    float chord = sqrt(max(radius2 - off * off, 0.));
    float c0 = clamp(t, -chord, chord), c1 = clamp(t + side, -chord, chord);
    if (off == 0.) off = 1e-30;
    inside = inside && off > 0.;
    if (c1 > c0) sums += vec2(off * (c1 - c0), atan(off * (c1 - c0), off * off + c0 * c1));
}

/// The fraction of the patch that a disc covers.
float nacreCoverage(NacreOutline o, vec2 at, float radius) {
    if (o.isPoint) {
        float far = length(at), safe = max(far, 1e-20);
        float width = 1e-20 + (abs(dot(o.edgeA, at)) + abs(dot(o.edgeB, at))) / safe;
        return clamp(.5 + (radius - far) / width, 0., 1.);
    }
    vec2 a = .5 * (o.edgeA + o.edgeB), b = .5 * (o.edgeB - o.edgeA);
    float radius2 = radius * radius;
    float far = max(max(distance(at, a), distance(at, -a)), max(distance(at, b), distance(at, -b)));
    if (far < radius) return 1.;
    vec2 sums = vec2(0.);
    bool inside = true;
    nacreSide(-a - at, o.alongA, o.side.x, radius2, sums, inside);
    nacreSide(-b - at, o.alongB, o.side.y, radius2, sums, inside);
    nacreSide(a - at, -o.alongA, o.side.x, radius2, sums, inside);
    nacreSide(b - at, -o.alongB, o.side.y, radius2, sums, inside);
    float full = inside ? 2. * PI : 0.;
    return max(.5 * (sums.x + radius2 * (full - sums.y)), 0.) / o.area;
}

/// PatchOutline::relative_weight()
float nacreTilted(NacreOutline o, vec2 at, float radius) {
    if (o.isPoint) return 1.;
    float inverse = 2. / (o.area + PI * radius * radius);
    vec2 along = vec2(nacreCross(at, o.edgeB), nacreCross(o.edgeA, at));
    vec2 weight = 1. + o.tilt * clamp(inverse * along, -1., 1.);
    return weight.x * weight.y;
}

// ------------------------------------------------------------------------- what the flakes reflect

/// FlakeFilms: what a flake reflects over the mean of its species.
vec4 nacreFilm(int s, int g, float cosine, uint film) {
    vec4 kind = nacreFieldFilms[s];
    if (kind.x == 0.) return vec4(1.);
    float y = clamp((cosine - kind.z) * kind.w, 0., float(@FILM_INTERVALS@));
    int low = min(int(y), @FILM_INTERVALS@ - 1);
    ivec2 at = ivec2(4 * int(nacreHighProduct(film, uint(kind.x))) + g, int(kind.y) + low);
    return mix(texelFetch(nacreFilms, at, 0), texelFetch(nacreFilms, at + ivec2(0, 1), 0), y - float(low));
}

/// FlakeView::body(): where a flake lies in its layer, from 0 to 1 downwards.
float nacrePlace(uvec2 body) { return nacreUnit(body.x); }

/// What one flake reflects, where in nacreColour() stands the mean of its species. body: its hash.
vec3 nacreFlakeColour(int s, uvec2 body, vec3 wi, vec3 wo, NacrePair p) {
    float place = nacrePlace(body);
    vec4 depth[4], here[4];
    float path = 1. / p.i.z + 1. / p.o.z;
    @DEPTHS@
    vec3 sum = vec3(0.);
    @FLAKE_LAYERS@
#if NACRE_SMOOTH_COAT
    float leaves = (1. - nacreFresnel(wi.z)) * (1. - nacreFresnel(wo.z)) / (nacreIor * nacreIor);
#else
    float leaves = nacreOverClosed(nacreTabulated(wi, wo, p), nacreLight(p, true).once);
#endif
    return sum * (nacreLobe(nacreFlake[s], p) * leaves / (p.i.z * p.o.z));
}

/// A lobe of this width is evaluated: all but K, times what the patch shows by the flake.
float nacreFlakeFactor(int s, NacrePair p, float width, float resolved, float widening) {
    float alpha = nacreField[s].y, exponent = nacreExponent(s, p.slope2), y = width / alpha;
    float blur = exp(y * y * nacreLobeTable(exponent, y).x);
    return nacreResolvedFactor(s, p, resolved, widening) * PI * alpha * alpha * exp(exponent) / blur;
}

/// A plane of cells as a patch sees it: FlakePlane.
struct NacrePlane {
    int side;
    float kept;
    vec2 at, reach;     // the middle of the patch, and half its extent with the discs that touch it
    vec2 stepU, stepV;  // what steps in the plane are in the plane of the patch
    vec2 turn;
};

/// The components along the plane's axes, and across it.
vec3 nacreOnPlane(vec3 w, int axis) { return axis == 0 ? w.yzx : axis == 1 ? w.zxy : w; }

NacrePlane nacrePlane(NacrePatch seen, int axis, float fraction, float largest) {
    vec3 n = nacreOnPlane(seen.normal, axis), t = nacreOnPlane(seen.tangent, axis);
    vec3 b = cross(n, t);
    NacrePlane plane;
    plane.kept = fraction / abs(n.z) * (65536. / @MAX_STRETCH@);
    plane.at = nacreOnPlane(seen.position, axis).xy;
    plane.reach = .5 * (abs(nacreOnPlane(seen.edgeA, axis).xy) +
                        abs(nacreOnPlane(seen.edgeB, axis).xy)) +
                  largest * sqrt(max(1. - n.xy * n.xy, 0.));
    vec2 over = vec2(t.z, b.z) / n.z;
    plane.stepU = vec2(t.x, b.x) - n.x * over;
    plane.stepV = vec2(t.y, b.y) - n.y * over;
    plane.turn = normalize(vec2(t.x, b.x));
    plane.side = 2 * axis + (n.z < 0. ? 1 : 0);
    return plane;
}

float nacreSunResolved[NACRE_FLAKES];
float nacreSunWidened[NACRE_FLAKES];
void nacreWithoutSunlit() {
    nacreResolved = nacreSunResolved;
    nacreWidened = nacreSunWidened;
}

/// Light of the flakes of a patch, each sampled once: from all around, where one of them
/// is chosen by what they reflect [talbot-2005], and of a sun, which is narrower than their lobes. Afterwards
/// nacreColour() is without them, for light that is not the sun's; nacreWithoutSunlit() is for that.
///
/// sampled: else only what is left without flakes is worked out. sun: towards a place on it; z <= 0: there
/// is none. sunLight: its radiance times its solid angle. random: bits of the sample.
///
/// Processors that draw in place of a card compute both sides of an if, and the body of a loop that is
/// asked at its beginning once more than it runs. So there is one loop that looks for flakes, around it one
/// that draws directions for those that are found, and around that one in which colours are worked out:
/// those of flakes in the sun, and at last that of the chosen one.
vec3 nacreFlakes(NacrePatch seen, bool sampled, vec3 wi, vec3 sun, vec3 sunLight, float sunAngle, uint random) {
    vec3 sum = vec3(0.), i = nacreRefract(wi, nacreIor);
    bool sunny = sun.z > 1e-4;
    NacrePair sunPair;
    vec2 sunSlope;
    if (sunny) {
        sunPair = nacrePair(wi, sun);
        vec3 h = sunPair.i + sunPair.o;
        sunSlope = h.xy / h.z;
    }
    vec3 squares = seen.normal * seen.normal;
    vec3 parts = max(squares - max(squares.x, max(squares.y, squares.z)) + @PROJECTION_BLEND@, 0.);
    parts /= parts.x + parts.y + parts.z;

    // The one that is chosen.
    float brightness = 0., chosenBrightness = 0., chosenWeight, chosenWidth;
    int chosen = 0;
    uvec2 chosenBody;
    vec3 chosenWo, chosenLight;

    // A species, as the patch sees it.
    int s = 0;
    NacreOutline outline;
    NacreShown wide, narrow;
    float typicalDepth, sunScale, sunSpread;
    // One of its planes, -1 before the first, a level of it and a cell, of which n of `count` flakes are known.
    int axis = -1, level, n, count;
    NacrePlane plane;
    ivec2 begin = ivec2(0), end, at;
    float cell, wideWeight, sunWeight;
    uvec2 levelKey, key;

    do {
        vec4 field = nacreField[s], sizes = nacreFieldSize[s];
        float cellSide = field.x, alpha = field.y, largest = sizes.y;
        if (axis < 0) {
            outline = nacreOutline(seen, sizes.x);
            narrow = wide = nacreLevels(s, outline.side, 2.);
            if (sunny && wide.resolved < 1.) {
                // FlakeField::lobe_area() as what it is outside the coat.
                float radius = nacreFieldLevels[s].y * alpha / max(i.z, .1);
                float area = 5. * PI / 9. * (radius * radius + nacreSpread2(s, i.z, i.z));
                float angle = area * 4. * i.z * i.z * i.z * nacreIor * nacreIor * i.z / wi.z;
                narrow = nacreLevels(s, outline.side, min(sunAngle / angle, 1.));
            }
            nacreResolved[s] = wide.resolved;
            nacreWidened[s] = 1.;
            nacreSunResolved[s] = narrow.resolved;
            nacreSunWidened[s] = narrow.widening;
            typicalDepth = 2. * nacreLayer[NACRE_LAYERS[s]].x / i.z *
                           nacreRow(NACRE_EXTINCTIONS[s], 1, length(wi.xy) / (1. + wi.z)).w;
            sunScale = sunSpread = 0.;
            if (sunny && nacreReaches(s, sunPair.slope2)) {
                sunSpread = narrow.widening * narrow.widening * nacreSpread2(s, i.z, sunPair.o.z);
                sunScale = narrow.widening * nacreWidening(sunPair.sec2, sunPair.cosine);
            }
            if (!sampled || wide.resolved + narrow.resolved == 0.) axis = 3;
            level = NACRE_LEVELS - 1;
            n = count = 0;
            at = end = ivec2(0);
        }

        // Of a flake in the sun.
        bool sunlit = false;
        uvec2 body;
        float weight, sunWidth2, lobe;
        do {
            bool found = false;
            uvec2 flake;
            float radius;
            vec2 middle;
            do {
                if (n == count) {
                    n = count = 0;
                    ++at.x;
                    if (at.x > end.x) at = ivec2(begin.x, at.y + 1);
                    if (at.y > end.y) {
                        ++level;
                        if (level == NACRE_LEVELS) {
                            level = 0;
                            ++axis;
                        }
                        float part = axis < 3 ? nacreOnPlane(parts, axis).z : 0.;
                        if (part <= 0.) level = NACRE_LEVELS - 1;
                        else if (level == 0) plane = nacrePlane(seen, axis, part, largest);
                        cell = cellSide * float(1 << 2 * level);
                        wideWeight = wide.scale * nacreFaded(s, outline.side, cell, wide);
                        sunWeight = narrow.scale * nacreFaded(s, outline.side, cell, narrow);
                        at = ivec2(0);
                        end = ivec2(-1);
                        if (part > 0. && wideWeight + sunWeight > 0.) {
                            at = begin = ivec2(floor((plane.at - plane.reach) / cellSide)) >> 2 * level;
                            end = ivec2(floor((plane.at + plane.reach) / cellSide)) >> 2 * level;
                            uvec4 k = uvec4(nacreFieldKey[NACRE_LEVELS * s + level]);
                            levelKey = uvec2(k.x | k.y << 16, k.z | k.w << 16);
                        }
                    }
                    if (at.y <= end.y) {
                        key = nacreCellKey(levelKey, plane.side, at.x, at.y);
                        count = nacreCount(nacreUnit(key.y));
                    }
                }
                float grain = cell * exp2(-16.);
                vec2 corner = vec2(at) * cell - plane.at;
                do {
                    if (n < count) {
                        flake = nacreFlakeBits(key, n);
                        ++n;
                        middle = corner + grain * vec2(flake.x & 0xffffu, flake.x >> 16);
                        middle = plane.stepU * middle.x + plane.stepV * middle.y;
                        radius = largest;
                        if (sizes.x < largest) {
                            ivec2 size = ivec2(4 * NACRE_SIZES[s], flake.y >> 24);
                            radius = .5e-3 * texelFetch(nacreTable, size, 0).x;
                        }
                        found = float(flake.y & 0xffffu) < plane.kept && nacreTouches(outline, middle, radius);
                    }
                } while (!found && n < count);
            } while (!found && axis < 3);
            if (found) {
                vec2 gauss = nacreSlopes(flake), turn = plane.turn;
                vec2 slope = alpha * vec2(turn.x * gauss.x - turn.y * gauss.y,
                                          turn.y * gauss.x + turn.x * gauss.y);
                float own = .5e-3 * field.z / radius;
                weight = field.w * nacreCoverage(outline, middle, radius) * nacreTilted(outline, middle, radius);
                body = nacreHash(flake.x, flake.y);
                // The sun, if it lies in the lobe.
                sunWidth2 = min(own * own * sunScale * sunScale + sunSpread, 16. * alpha * alpha);
                vec2 apart = slope - sunSlope;
                sunlit = weight > 0. && sunScale > 0. && sunWeight > 0. && dot(apart, apart) < sunWidth2;
                float t = 1. - dot(apart, apart) / sunWidth2;
                lobe = 3. / (PI * sunWidth2) * t * t;
                // A direction from the lobe; the least of three even numbers has its law.
                float sec2 = 1. + dot(slope, slope);
                float facing = dot(i.xy, slope) + i.z;
                float scaled = own * nacreWidening(sec2, abs(facing) * inversesqrt(sec2));
                float spread2 = nacreSpread2(s, i.z, 2. * facing / sec2 - i.z);
                float width = min(sqrt(scaled * scaled + spread2), 4. * alpha);
                uint a = nacreShortMix(random ^ flake.x ^ (flake.y * NACRE_SHORT_GOLDEN));
                uint b = nacreShortMix(a ^ NACRE_SHORT_GOLDEN);
                float least = float(min(min(a & 0xffffu, a >> 16), b & 0xffffu)) * exp2(-16.) + exp2(-17.);
                float turned = 2. * PI * float(b >> 16) * exp2(-16.);
                vec2 halfSlope = slope + width * sqrt(least) * vec2(cos(turned), sin(turned));
                vec3 m = vec3(halfSlope, 1.);
                vec3 o = m * (2. * dot(i, m) / dot(m, m)) - i;
                vec2 xy = nacreIor * o.xy;
                float z2 = 1. - dot(xy, xy);
                if (weight > 0. && wideWeight > 0. && o.z > 0. && z2 >= 1e-6 &&
                    dot(halfSlope, halfSlope) < @MAX_EXPONENT@ * alpha * alpha) {
                    vec3 wo = vec3(xy, sqrt(z2));
                    vec3 light = nacreRadiance(wo);
                    float reflected = max(light.r, max(light.g, light.b)) * sizes.w *
                                      wideWeight * weight * exp(-nacrePlace(body) * typicalDepth);
                    if (reflected > 0.) {
                        brightness += reflected;
                        if (nacreFraction(nacreShortMix(b ^ random)) * brightness < reflected) {
                            chosen = s;
                            chosenBrightness = reflected;
                            chosenWeight = wideWeight * weight;
                            chosenBody = body;
                            chosenWidth = width;
                            chosenWo = wo;
                            chosenLight = light;
                        }
                    }
                }
            }
        } while (!sunlit && axis < 3);

        bool shows = sunlit;
        int of = s;
        vec3 wo = sun, light = sunLight;
        float width = sqrt(sunWidth2), resolved = narrow.resolved, widening = narrow.widening;
        if (!sunlit) {
            axis = -1;
            ++s;
            shows = s == NACRE_FLAKES && chosenBrightness > 0.;
            of = chosen;
            wo = chosenWo;
            light = chosenLight;
            body = chosenBody;
            width = chosenWidth;
            resolved = nacreResolved[chosen];
            widening = 1.;
        }
        if (shows) {
            NacrePair p = nacrePair(wi, wo);
            // Solid angle outside per area of slopes; K is what the direction was drawn by.
            float angle = 2. * (p.i.z + p.o.z) / p.sec2 * nacreIor * nacreIor * p.o.z;
            float scale = sunlit ? sunWeight * weight * lobe * sun.z
                                 : angle * chosenWeight * brightness / chosenBrightness;
            sum += nacreFlakeColour(of, body, wi, wo, p) * light *
                   (scale * nacreFlakeFactor(of, p, width, resolved, widening));
        }
    } while (s < NACRE_FLAKES);
    return sum;
}
