#include "sampling/halton.h"

#include <array>

#include "core/mixer.h"
#include "core/not_implemented.h"
#include "sampling/permutation.h"

namespace caustic {

namespace {

constexpr std::array<std::uint32_t, haltonDimensions> primes = {2, 3, 5, 7, 11, 13, 17, 19, 23, 29};

// Names the permutation of the digit at a place, counted from the last one.
std::uint32_t keyOfDigit(std::uint64_t key, unsigned place) {
    return static_cast<std::uint32_t>(splitMix(key + (place + 1) * goldenStep) >> 32);
}

}  // namespace

Real haltonNumber(std::uint32_t index, int dimension, std::uint64_t key) {
    //! [ex-10.1]
    const std::uint32_t base = primes[static_cast<std::size_t>(dimension)];
    std::uint64_t reversed = 0;
    std::uint64_t intervals = 1;
    // As integers, so that rounding puts no point over its interval's border.
    for (unsigned place = 0; intervals < std::uint64_t{1} << 32; ++place) {
        reversed = reversed * base + permuted(index % base, base, keyOfDigit(key, place));
        intervals *= base;
        index /= base;
    }
    return static_cast<Real>(reversed) / static_cast<Real>(intervals);
    //! [ex-10.1]
}

}  // namespace caustic
