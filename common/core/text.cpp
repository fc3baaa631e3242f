#include "core/text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>

#include "core/error.h"

namespace caustic {

std::string formatReal(double value) {
    std::array<char, 32> buffer{};
    const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    (void)error;  // 32 characters hold every double
    return {buffer.data(), end};
}

namespace {

// Without a plus sign, which from_chars doesn't know. "+-1" stays, and is rubbish.
std::string_view withoutPlus(std::string_view text) {
    const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
    return plus ? text.substr(1) : text;
}

// Whether a number that is out of range is too small, not too large: the exponent of its first digit tells.
bool isTiny(std::string_view text) {
    const std::size_t mark = std::min(text.find_first_of("eE"), text.size());
    const std::size_t point = std::min(text.find('.'), mark);
    const std::size_t first = std::min(text.find_first_of("123456789"), mark);
    const auto shift = static_cast<double>(point) - static_cast<double>(first);
    double exponent = 0;
    for (const char c : text.substr(mark)) {
        if (c >= '0' && c <= '9') exponent = 10 * exponent + (c - '0');
    }
    if (mark + 1 < text.size() && text[mark + 1] == '-') exponent = -exponent;
    return shift + exponent < 0;
}

}  // namespace

std::optional<double> parseReal(std::string_view text) {
    text = withoutPlus(text);
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc::invalid_argument || end != text.data() + text.size()) return std::nullopt;
    if (error == std::errc()) return value;
    if (!isTiny(text)) return std::nullopt;
    return text.front() == '-' ? -0.0 : 0.0;
}

std::optional<long long> parseInteger(std::string_view text) {
    text = withoutPlus(text);
    long long value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
}

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view space = " \t\r\n\f\v";
    const auto first = text.find_first_not_of(space);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(space) - first + 1);
}

std::string joined(const std::vector<std::string>& words, std::string_view between) {
    std::string text;
    for (const std::string& word : words) {
        if (!text.empty()) text += between;
        text += word;
    }
    return text;
}

std::string readTextFile(const std::filesystem::path& path, std::size_t mostBytes) {
    std::error_code failure;
    const auto status = std::filesystem::status(path, failure);
    if (!std::filesystem::exists(status)) throw InputError({path.string(), 0}, "", "no such file");
    if (std::filesystem::is_directory(status)) throw InputError({path.string(), 0}, "", "is a folder, not a file");
    std::ifstream file(path, std::ios::binary);
    if (!file) throw InputError({path.string(), 0}, "", "cannot be opened for reading");

    // Read by blocks and count: the size that the file system states is 0 for pipes and wrong for growing files.
    std::string text;
    std::array<char, 1 << 16> block{};
    while (file.read(block.data(), block.size()) || file.gcount() > 0) {
        text.append(block.data(), static_cast<std::size_t>(file.gcount()));
        if (text.size() > mostBytes) {
            throw InputError({path.string(), 0}, "", "is larger than " + std::to_string(mostBytes >> 20) + " MiB");
        }
    }
    if (file.bad()) throw InputError({path.string(), 0}, "", "cannot be read to its end");
    return text;
}

}  // namespace caustic
