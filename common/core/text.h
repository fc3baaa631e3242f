#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace caustic {

/// Shortest decimal text that reads back as the same number; the same on every locale. "nan", "inf" for those.
std::string formatReal(double value);

/// Reads the whole of `text` as one number, in the "C" locale. Nothing for rubbish, trailing characters, or a value
/// that is too large for a double (1e400); one that is too small is 0. "nan" and "inf" are read as such.
std::optional<double> parseReal(std::string_view text);

/// Reads the whole of `text` as one integer; nothing for rubbish or overflow.
std::optional<long long> parseInteger(std::string_view text);

/// Without white space at either end.
std::string_view trimmed(std::string_view text);

/// Words, one behind the other with something between them.
std::string joined(const std::vector<std::string>& words, std::string_view between);

/// Reads a text file.
/// @param mostBytes  a larger file is refused before it is read
/// @throws InputError when it is missing, a folder, unreadable or too large
std::string readTextFile(const std::filesystem::path& path, std::size_t mostBytes);

}  // namespace caustic
