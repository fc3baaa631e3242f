#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "math/real.h"

namespace caustic {

/// Largest magnitude of a coordinate that a profile may have. Squares and products of differences stay far inside the
/// range of double, so no length, tangent or box of a profile overflows.
constexpr Real largestCoordinate = 1e100;

/// Most bytes of a profile's file, of either kind.
constexpr std::size_t mostProfileBytes = std::size_t{16} << 20;

/// Most cubic segments that one path may have. Together with mostProfileBytes this keeps what a file of bad will can
/// make the reader hold below 200 MB.
constexpr std::size_t mostSegments = std::size_t{1} << 20;

/// Line of the character at `offset`, counted from 1.
std::size_t lineOf(std::string_view text, std::size_t offset);

/// `text` without the UTF-8 byte order mark that some editors put in front.
std::string_view withoutByteOrderMark(std::string_view text);

/// Says what `text` is when it is no UTF-8 text at all: UTF-16 or UTF-32, or binary.
/// @param file  what errors call it
/// @throws InputError
void checkIsText(std::string_view text, const std::string& file);

}  // namespace caustic
