#pragma once

#include <cmath>
#include <cstdint>

namespace nacre {

/// A sum of floats that comes out the same, bit for bit, in whatever order and in whatever groups
/// they are added: threads, processes and machines may share the work. Sums of floating-point
/// numbers do not, as each addition rounds; here every number is rounded once, towards 0, to a
/// multiple of 2^-fraction_bits, and whole numbers add up exactly.
///
/// It is for at most n numbers below 2^(bits - 1 - fraction_bits) / n; beyond, sums wrap around.
template <class Signed, class Unsigned, int fraction_bits>
class ReproducibleSum {
 public:
    static constexpr float kStepsPerUnit = static_cast<float>(std::uint64_t{1} << fraction_bits);

    /// @param x  finite, and |x| below 2^(bits - 1 - fraction_bits)
    void add(float x) {
        const float steps = x * kStepsPerUnit;
        // Most are small, and the conversion to a word is one instruction.
        steps_ += std::abs(steps) < 0x1p62f
                      ? static_cast<Unsigned>(static_cast<std::int64_t>(steps))
                      : static_cast<Unsigned>(static_cast<Signed>(steps));
    }
    void add(const ReproducibleSum& other) { steps_ += other.steps_; }
    /// Rounded to the nearest double.
    double value() const {
        return static_cast<double>(static_cast<Signed>(steps_)) / kStepsPerUnit;
    }
    friend bool operator==(const ReproducibleSum&, const ReproducibleSum&) = default;

 private:
    Unsigned steps_ = 0;  // two's complement
};

__extension__ using Int128 = __int128;
__extension__ using UnsignedInt128 = unsigned __int128;

/// For light: 2^24 numbers below 2^55, in steps of 2^-48.
using LightSum = ReproducibleSum<Int128, UnsignedInt128, 48>;
/// For the components of 2^24 unit vectors, in steps of 2^-38.
using UnitSum = ReproducibleSum<std::int64_t, std::uint64_t, 38>;

}  // namespace nacre
