#include "sampling/sobol.h"

#include <array>
#include <bit>

#include "core/not_implemented.h"

namespace caustic {

namespace {

using Directions = std::array<std::uint32_t, 32>;

// A primitive polynomial x^degree + a_1 x^(degree-1) + ... + 1 over two elements, its inner coefficients a as bits, and
// the first direction numbers m: Joe and Kuo's table new-joe-kuo-6.21201.
struct Polynomial {
    unsigned degree;
    unsigned inner;
    std::array<std::uint32_t, 4> m;
};
constexpr std::array<Polynomial, sobolDimensions - 1> polynomials = {
    {{1, 0, {1}}, {2, 1, {1, 3}}, {3, 1, {1, 3, 1}}, {3, 2, {1, 1, 1}}, {4, 1, {1, 1, 3, 3}}}};

// Source: Joe, Kuo 2008, eq. 3.6.
constexpr Directions directionsOf(const Polynomial& polynomial) {
    Directions v = {};
    const unsigned degree = polynomial.degree;
    for (unsigned i = 0; i < degree; ++i) v[i] = polynomial.m[i] << (31 - i);
    for (unsigned i = degree; i < 32; ++i) {
        v[i] = v[i - degree] ^ (v[i - degree] >> degree);
        for (unsigned k = 1; k < degree; ++k) {
            if ((polynomial.inner >> (degree - 1 - k) & 1) != 0) v[i] ^= v[i - k];
        }
    }
    return v;
}

constexpr std::array<Directions, sobolDimensions> allDirections() {
    std::array<Directions, sobolDimensions> all = {};
    for (unsigned i = 0; i < 32; ++i) all[0][i] = std::uint32_t{1} << (31 - i);
    for (std::size_t d = 1; d < all.size(); ++d) all[d] = directionsOf(polynomials[d - 1]);
    return all;
}

constexpr std::array<Directions, sobolDimensions> directions = allDirections();

std::uint32_t reversed(std::uint32_t x) {
    x = (x & 0x55555555) << 1 | (x >> 1 & 0x55555555);
    x = (x & 0x33333333) << 2 | (x >> 2 & 0x33333333);
    x = (x & 0x0f0f0f0f) << 4 | (x >> 4 & 0x0f0f0f0f);
    return __builtin_bswap32(x);
}

}  // namespace

std::uint32_t sobolBits(std::uint32_t index, int dimension) {
    //! [ex-09.1]
    const Directions& v = directions[static_cast<std::size_t>(dimension)];
    std::uint32_t bits = 0;
    for (; index != 0; index &= index - 1) bits ^= v[static_cast<std::size_t>(std::countr_zero(index))];
    return bits;
    //! [ex-09.1]
}

std::uint32_t owenScrambled(std::uint32_t bits, std::uint32_t seed) {
    std::uint32_t x = reversed(bits);
    // An even multiplier hands each bit to higher ones only; reversed, that is from the first bits to the later ones.
    x += seed;
    x ^= x * 0x6c50b47cU;
    x ^= x * 0xb82f1e52U;
    x ^= x * 0xc7afe638U;
    x ^= x * 0x8d22f6e6U;
    return reversed(x);
}

}  // namespace caustic
