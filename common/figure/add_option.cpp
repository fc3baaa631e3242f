#include "figure/add_option.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <type_traits>

#include "core/text.h"

namespace caustic {

namespace {

std::string numberText(double value) { return formatReal(value); }
std::string numberText(std::int64_t value) { return std::to_string(value); }

std::optional<double> numberIn(const std::string& text, double) {
    const auto number = parseReal(text);
    return number && std::isfinite(*number) ? number : std::nullopt;
}
std::optional<long long> numberIn(const std::string& text, std::int64_t) { return parseInteger(text); }

template <typename Number>
std::string complaintOf(const RangedValue<Number>& range, const std::string& text) {
    const auto number = numberIn(text, Number());
    if (number && *number >= range.least && *number <= range.most) return "";
    const std::string kind = std::is_integral_v<Number> ? "a whole number" : "a number";
    return "must be " + kind + " from " + numberText(range.least) + " to " + numberText(range.most) + " (got '" + text +
           "')";
}

std::string complaintOf(const ChoiceValue& choice, const std::string& text) {
    if (std::ranges::count(choice.choices, text) > 0) return "";
    return "must be one of " + joined(choice.choices, ", ") + " (got '" + text + "')";
}

std::string complaintOf(const TextValue&, const std::string&) { return ""; }

template <typename Number>
std::string domainOf(const RangedValue<Number>& range) {
    return " in [" + numberText(range.least) + ", " + numberText(range.most) + "]";
}
std::string domainOf(const ChoiceValue& choice) { return " {" + joined(choice.choices, ", ") + "}"; }
std::string domainOf(const TextValue&) { return ""; }

}  // namespace

CLI::Option* addOption(CLI::App& app, const ChapterOption& option) {
    const auto check = [value = option.value](const std::string& text) { return complaint(value, text); };
    const std::string type = option.type + domainText(option.value);
    return std::visit(
        [&](const auto& value) {
            return app.add_option(option.name, *value.value, option.help)->type_name(type)->check(check, "", "");
        },
        option.value);
}

std::string complaint(const OptionValue& value, const std::string& text) {
    return std::visit([&](const auto& one) { return complaintOf(one, text); }, value);
}

std::string domainText(const OptionValue& value) {
    return std::visit([](const auto& one) { return domainOf(one); }, value);
}

}  // namespace caustic
