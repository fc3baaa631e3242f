#include "sampling/permutation.h"

#include <bit>

namespace caustic {

std::uint32_t permuted(std::uint32_t i, std::uint32_t count, std::uint32_t key) {
    // Each step is a bijection of the numbers below the next power of two; what leaves the list is sent round again.
    const std::uint32_t mask = std::bit_ceil(count) - 1;
    do {
        i ^= key;
        i *= 0xe170893d;
        i ^= key >> 16;
        i ^= (i & mask) >> 4;
        i ^= key >> 8;
        i *= 0x0929eb3f;
        i ^= key >> 23;
        i ^= (i & mask) >> 1;
        i *= 1 | key >> 27;
        i *= 0x6935fa69;
        i ^= (i & mask) >> 11;
        i *= 0x74dcb303;
        i ^= (i & mask) >> 2;
        i *= 0x9e501cc3;
        i ^= (i & mask) >> 2;
        i *= 0xc860a3df;
        i &= mask;
        i ^= i >> 5;
    } while (i >= count);
    return (i + key) % count;
}

}  // namespace caustic
