#include "curve/profile_limits.h"

#include <algorithm>

#include "core/error.h"

namespace caustic {

std::size_t lineOf(std::string_view text, std::size_t offset) {
    const std::string_view before = text.substr(0, offset);
    return 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
}

std::string_view withoutByteOrderMark(std::string_view text) {
    constexpr std::string_view mark = "\xEF\xBB\xBF";
    if (text.starts_with(mark)) text.remove_prefix(mark.size());
    return text;
}

void checkIsText(std::string_view text, const std::string& file) {
    const std::size_t zero = text.find('\0');
    const bool wideMark = text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF");
    // "<" of an SVG file, or any other ASCII character, as two bytes.
    const bool wideWithoutMark = zero < 2 && text.size() >= 2 && text[1 - zero] != '\0';
    if (wideMark || wideWithoutMark) throw InputError({file, 1}, "", "is encoded in UTF-16; save it as UTF-8");
    if (zero != std::string_view::npos) {
        throw InputError({file, lineOf(text, zero)}, "", "is no text: it has a zero byte");
    }
}

}  // namespace caustic
