#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace caustic {

/// Takes an option and its value out of the arguments: one that belongs to a chapter's command, which runChapter
/// doesn't know.
/// @param option  "--material"
/// @return its value; `fallback` when the user gave none
inline std::string takeOption(std::vector<const char*>& arguments, std::string_view option, const char* fallback) {
    for (std::size_t i = 1; i + 1 < arguments.size(); ++i) {
        if (arguments[i] != option) continue;
        const std::string value = arguments[i + 1];
        const auto place = arguments.begin() + static_cast<std::ptrdiff_t>(i);
        arguments.erase(place, place + 2);
        return value;
    }
    return fallback;
}

}  // namespace caustic
