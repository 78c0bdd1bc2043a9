#pragma once

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "nacre/core/lanes.h"

// Small vectors: directions, which point away from the surface (docs/conventions.md), positions,
// and triples of numbers that are added and scaled together, such as colours.

namespace nacre {

template <class T>
struct Vec2 {
    T x{}, y{};

    friend constexpr T dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
    friend T length(Vec2 a) { return std::sqrt(dot(a, a)); }
};

template <class T>
struct Vec3 {
    T x{}, y{}, z{};

    constexpr T& operator[](int i) { return i == 0 ? x : i == 1 ? y : z; }
    constexpr const T& operator[](int i) const { return i == 0 ? x : i == 1 ? y : z; }

    friend constexpr Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend constexpr Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend constexpr Vec3 operator*(Vec3 a, Vec3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
    friend constexpr Vec3 operator*(T s, Vec3 a) { return {s * a.x, s * a.y, s * a.z}; }
    friend constexpr Vec3 operator*(Vec3 a, T s) { return s * a; }
    friend constexpr Vec3 operator/(Vec3 a, T s) { return {a.x / s, a.y / s, a.z / s}; }
    friend constexpr Vec3 operator-(Vec3 a) { return {-a.x, -a.y, -a.z}; }
    constexpr Vec3& operator+=(Vec3 b) { return *this = *this + b; }
    constexpr Vec3& operator*=(T s) { return *this = s * *this; }
    friend constexpr bool operator==(Vec3, Vec3) = default;

    friend constexpr T dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
    friend constexpr Vec3 cross(Vec3 a, Vec3 b) {
        return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    }
    friend T length(Vec3 a) { return std::sqrt(dot(a, a)); }
    /// Doubles are divided, which keeps the last digit and with it what a long random walk does;
    /// floats, in a renderer's inner loops, are multiplied by the reciprocal, which is faster.
    friend Vec3 normalize(Vec3 a) {
        if constexpr (std::is_same_v<T, double>) {
            return a / length(a);
        } else {
            return (1 / length(a)) * a;
        }
    }
};

/// As an array of three, for nlohmann::json, which finds this by name.
template <class Json, class T>
void to_json(Json& json, const Vec3<T>& v) {
    json = Json::array({v.x, v.y, v.z});
}

using Vec2f = Vec2<float>;
using Vec3f = Vec3<float>;
using Vec3d = Vec3<double>;
/// Eight of them.
using Vec3Lanes = Vec3<FloatLanes>;

inline Vec3Lanes splat(Vec3f a) { return {splat(a.x), splat(a.y), splat(a.z)}; }
inline Vec3f lane(const Vec3Lanes& a, int i) { return {a.x[i], a.y[i], a.z[i]}; }

inline Vec3d to_double(Vec3f a) { return {a.x, a.y, a.z}; }
inline Vec3f to_float(Vec3d a) {
    return {static_cast<float>(a.x), static_cast<float>(a.y), static_cast<float>(a.z)};
}

/// A unit vector perpendicular to `a`, in the plane z = 0 unless `a` is parallel to z.
template <class T>
Vec3<T> perpendicular(Vec3<T> a) {
    constexpr T kUpright = T(1e-12);
    if (std::max(std::abs(a.x), std::abs(a.y)) > kUpright * std::abs(a.z)) {
        const T scale = 1 / std::sqrt(a.x * a.x + a.y * a.y);
        return {-a.y * scale, a.x * scale, 0};
    }
    const T scale = 1 / std::sqrt(a.y * a.y + a.z * a.z);
    return {0, -a.z * scale, a.y * scale};
}

/// Right-handed orthonormal frame whose third axis is the unit vector n, without branches on n
/// and without a singularity.                                        [duff-2017-onb, listing 3]
struct Frame {
    Vec3f s, t, n;

    static Frame around(Vec3f n) {
        const float sign = std::copysign(1.0f, n.z);
        const float a = -1.0f / (sign + n.z);
        const float b = n.x * n.y * a;
        return {
            {1 + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}, n};
    }
    Vec3f to_local(Vec3f v) const { return {dot(v, s), dot(v, t), dot(v, n)}; }
    Vec3Lanes to_local(const Vec3Lanes& v) const {
        return {dot(v, splat(s)), dot(v, splat(t)), dot(v, splat(n))};
    }
    Vec3f to_world(Vec3f v) const { return v.x * s + v.y * t + v.z * n; }
    Vec3Lanes to_world(const Vec3Lanes& v) const {
        return v.x * splat(s) + v.y * splat(t) + v.z * splat(n);
    }
};

}  // namespace nacre
