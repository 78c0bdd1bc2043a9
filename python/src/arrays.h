#pragma once

#include <nanobind/ndarray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "nacre/core/error.h"
#include "nacre/core/parallel.h"

// Arrays of numpy: in as they lie in memory, out without a copy.

namespace nacre::python {

namespace nb = nanobind;

using Doubles = nb::ndarray<const double, nb::c_contig, nb::device::cpu>;
template <class T>
using NumpyArray = nb::ndarray<nb::numpy, T>;
using Shape = std::vector<std::size_t>;

/// For properties that return new arrays, which their capsules own.
inline constexpr auto kOwned = nb::rv_policy::move;

/// Hands the memory of a vector over to numpy.
template <class T>
NumpyArray<T> to_numpy(std::vector<T> values, const Shape& shape) {
    auto owner = std::make_unique<std::vector<T>>(std::move(values));
    T* const data = owner->data();
    const nb::capsule capsule(owner.get(),
                              [](void* p) noexcept { delete static_cast<std::vector<T>*>(p); });
    (void)owner.release();
    return NumpyArray<T>(data, shape.size(), shape.data(), capsule);
}

/// Memory for numbers of which each will be written: large arrays are not filled with zeros first,
/// by one thread that keeps Python's lock (std::complex would be even by an array left unset).
template <class T>
class Unwritten {
    static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

 public:
    explicit Unwritten(std::size_t size)
        : size_(size), values_(static_cast<T*>(::operator new(size * sizeof(T)))) {}

    T* at(std::size_t i) { return values_.get() + i; }
    std::size_t size() const { return size_; }
    /// Hands it over to numpy.
    NumpyArray<T> to_numpy(const Shape& shape) && {
        const nb::capsule capsule(values_.get(), [](void* p) noexcept { ::operator delete(p); });
        return NumpyArray<T>(values_.release(), shape.size(), shape.data(), capsule);
    }

 private:
    struct Free {
        void operator()(T* p) const { ::operator delete(p); }
    };
    std::size_t size_;
    std::unique_ptr<T[], Free> values_;
};

template <class T>
NumpyArray<T> to_numpy(std::vector<T> values) {
    const Shape shape = {values.size()};
    return to_numpy(std::move(values), shape);
}

inline std::vector<double> to_vector(const Doubles& array) {
    return {array.data(), array.data() + array.size()};
}

/// The number of values of that shape.
/// @throws std::bad_alloc (Python's MemoryError) if no memory holds so many
inline std::size_t count(const Shape& shape) {
    if (std::ranges::find(shape, 0u) != shape.end()) return 0;
    constexpr std::size_t kMost = PTRDIFF_MAX / sizeof(double);
    std::size_t values = 1;
    for (const std::size_t side : shape) {
        if (side > kMost / values) throw std::bad_alloc();
        values *= side;
    }
    return values;
}

inline std::string text_of(const Shape& shape) {
    std::string text = "(";
    for (std::size_t i = 0; i < shape.size(); ++i) {
        text += (i ? ", " : "") + std::to_string(shape[i]);
    }
    return text + (shape.size() == 1 ? ",)" : ")");
}

/// Arrays whose leading axes are combined by numpy's rule of broadcasting, each with `inner` values
/// along its last axis (1: there is no such axis).
template <std::size_t N>
class Broadcast {
 public:
    /// @param name  of the arrays, for messages
    /// @throws DomainError if the shapes do not fit; std::bad_alloc as count()
    Broadcast(const std::array<const Doubles*, N>& arrays, const std::array<const char*, N>& names,
              std::size_t inner)
        : inner_(inner) {
        std::array<Shape, N> leading;
        for (std::size_t a = 0; a < N; ++a) {
            Shape whole;
            for (std::size_t i = 0; i < arrays[a]->ndim(); ++i)
                whole.push_back(arrays[a]->shape(i));
            leading[a] = whole;
            if (inner > 1) {
                if (whole.empty() || whole.back() != inner) {
                    throw DomainError(std::string(names[a]) + ": has the shape " + text_of(whole) +
                                      "; its last axis must have " + std::to_string(inner) +
                                      " values");
                }
                leading[a].pop_back();
            }
            data_[a] = arrays[a]->data();
            axes_ = std::max(axes_, leading[a].size());
        }
        shape_.assign(axes_, 1);
        for (std::size_t a = 0; a < N; ++a) {
            const std::size_t missing = axes_ - leading[a].size();
            for (std::size_t i = 0; i < leading[a].size(); ++i) {
                std::size_t& side = shape_[missing + i];
                if (side == leading[a][i] || leading[a][i] == 1) continue;
                if (side != 1) {
                    throw DomainError(std::string(names[0]) + " of leading axes " +
                                      text_of(leading[0]) + " and " + names[a] + " of " +
                                      text_of(leading[a]) + " cannot be broadcast together");
                }
                side = leading[a][i];
            }
        }
        size_ = count(shape_);
        for (std::size_t a = 0; a < N; ++a) {
            const std::size_t missing = axes_ - leading[a].size();
            strides_[a].assign(axes_, 0);
            std::size_t stride = inner;
            for (std::size_t i = leading[a].size(); i-- > 0;) {
                if (leading[a][i] != 1) strides_[a][missing + i] = stride;
                stride *= leading[a][i];
            }
        }
    }

    const Shape& shape() const { return shape_; }
    std::size_t size() const { return size_; }
    /// With `last` values at each place. @throws std::bad_alloc as count()
    std::size_t size_with(std::size_t last) const { return count(shape_with(last)); }
    /// The leading axes and one more.
    Shape shape_with(std::size_t last) const {
        Shape shape = shape_;
        shape.push_back(last);
        return shape;
    }
    /// The values of array `a` at a place of the leading axes, counted row by row.
    const double* at(std::size_t a, std::size_t place) const {
        std::size_t offset = 0;
        for (std::size_t i = axes_; i-- > 0;) {
            offset += place % shape_[i] * strides_[a][i];
            place /= shape_[i];
        }
        return data_[a] + offset;
    }

 private:
    std::size_t inner_, axes_ = 0, size_ = 0;
    Shape shape_;
    std::array<const double*, N> data_;
    std::array<Shape, N> strides_;
};

}  // namespace nacre::python
