#include "nacre/core/sha256.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>

namespace nacre {
namespace {

// The standard takes its constants from the fractional parts of the square and cube roots of the
// first primes (sections 4.2.2 and 5.3.3); so does this, in integers, while compiling.
__extension__ using Wide = unsigned __int128;

constexpr bool is_prime(int n) {
    for (int d = 2; d * d <= n; ++d) {
        if (n % d == 0) return false;
    }
    return n > 1;
}

// First 32 bits of the fraction of prime^(1/power): the low half of floor(prime^(1/power) 2^32).
constexpr std::uint32_t root_fraction(int prime, int power) {
    Wide target = prime;
    for (int i = 0; i < power; ++i) target <<= 32;
    std::uint64_t root = 0;
    for (int bit = 37; bit >= 0; --bit) {  // roots of primes up to 311 are below 2^5
        const Wide trial = root | (std::uint64_t{1} << bit);
        if ((power == 2 ? trial * trial : trial * trial * trial) <= target) {
            root = static_cast<std::uint64_t>(trial);
        }
    }
    return static_cast<std::uint32_t>(root);
}

template <std::size_t count>
constexpr std::array<std::uint32_t, count> root_fractions(int power) {
    std::array<std::uint32_t, count> fractions{};
    int prime = 1;
    for (auto& f : fractions) {
        do ++prime;
        while (!is_prime(prime));
        f = root_fraction(prime, power);
    }
    return fractions;
}

constexpr auto kInitialState = root_fractions<8>(2);
constexpr auto kRoundConstants = root_fractions<64>(3);

void put_big_endian(std::uint64_t value, std::uint8_t* out, int bytes) {
    for (int i = 0; i < bytes; ++i) {
        out[i] = static_cast<std::uint8_t>(value >> (8 * (bytes - 1 - i)));
    }
}

}  // namespace

Sha256::Sha256() : state_(kInitialState) {}

void Sha256::compress(const std::uint8_t* block) {
    std::array<std::uint32_t, 64> w;
    for (int t = 0; t < 16; ++t) {
        w[t] = std::uint32_t{block[4 * t]} << 24 | std::uint32_t{block[4 * t + 1]} << 16 |
               std::uint32_t{block[4 * t + 2]} << 8 | std::uint32_t{block[4 * t + 3]};
    }
    for (int t = 16; t < 64; ++t) {
        const auto s0 = std::rotr(w[t - 15], 7) ^ std::rotr(w[t - 15], 18) ^ (w[t - 15] >> 3);
        const auto s1 = std::rotr(w[t - 2], 17) ^ std::rotr(w[t - 2], 19) ^ (w[t - 2] >> 10);
        w[t] = w[t - 16] + s0 + w[t - 7] + s1;
    }
    auto [a, b, c, d, e, f, g, h] = state_;
    for (int t = 0; t < 64; ++t) {
        const auto sum1 = std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25);
        const auto choice = (e & f) ^ (~e & g);
        const auto t1 = h + sum1 + choice + kRoundConstants[t] + w[t];
        const auto sum0 = std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22);
        const auto majority = (a & b) ^ (a & c) ^ (b & c);
        h = g, g = f, f = e, e = d + t1;
        d = c, c = b, b = a, a = t1 + sum0 + majority;
    }
    const std::array<std::uint32_t, 8> change = {a, b, c, d, e, f, g, h};
    for (int i = 0; i < 8; ++i) state_[i] += change[i];
}

void Sha256::update(const void* bytes, std::size_t count) {
    const auto* in = static_cast<const std::uint8_t*>(bytes);
    total_ += count;
    while (count > 0) {
        const std::size_t taken = std::min(count, block_.size() - filled_);
        std::memcpy(block_.data() + filled_, in, taken);
        in += taken, count -= taken, filled_ += taken;
        if (filled_ == block_.size()) {
            compress(block_.data());
            filled_ = 0;
        }
    }
}

std::string Sha256::hex() const {
    // Padding: a one bit, zeros up to 8 bytes before the end of a block, the length in bits.
    Sha256 padded = *this;
    std::array<std::uint8_t, 128> tail{0x80};
    const std::size_t zeros_end = filled_ < 56 ? 56 - filled_ : 120 - filled_;
    put_big_endian(total_ * 8, tail.data() + zeros_end, 8);
    padded.update(tail.data(), zeros_end + 8);
    std::string text;
    for (std::uint32_t word : padded.state_) text += fmt::format("{:08x}", word);
    return text;
}

std::string sha256_hex(std::string_view bytes) {
    Sha256 hash;
    hash.update(bytes);
    return hash.hex();
}

}  // namespace nacre
