#include "core/error.h"

#include <utility>

namespace caustic {

namespace {

// Long enough to recognise the place, short enough for one line of a terminal.
constexpr std::size_t longestValue = 60;

std::string shortened(std::string value) {
    for (char& c : value) {
        if (static_cast<unsigned char>(c) < 0x20) c = ' ';
    }
    if (value.size() <= longestValue) return value;
    return value.substr(0, longestValue) + "...";
}

std::string describe(const InputPlace& place, const std::string& value, const std::string& reason) {
    std::string text = place.file;
    if (place.line > 0) text += ":" + std::to_string(place.line);
    if (!text.empty()) text += ": ";
    text += reason;
    if (!value.empty()) text += " (got '" + value + "')";
    return text;
}

}  // namespace

InputError::InputError(InputPlace place, std::string value, std::string reason)
    : std::runtime_error(describe(place, shortened(value), reason)),
      place_(std::move(place)),
      value_(shortened(std::move(value))),
      reason_(std::move(reason)) {}

}  // namespace caustic
