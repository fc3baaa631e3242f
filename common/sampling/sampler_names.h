#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sampling/sampler.h"

namespace caustic {

/// What the samplers are called: random, stratified, halton, sobol.
const std::vector<std::string>& samplerNames();

/// Makes a sampler.
/// @param name   one of samplerNames()
/// @param seed   of everything
/// @param paths  of a pixel, at least 1: the stratified sampler's grid has the next square number of cells, 4096² at
/// most
/// @throws InputError for another name, or a number out of its range
std::unique_ptr<const Sampler> makeSampler(const std::string& name, std::uint64_t seed, std::int64_t paths);

}  // namespace caustic
