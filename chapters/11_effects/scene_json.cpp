#include "scene_json.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/text.h"

namespace caustic {

namespace {

constexpr std::size_t largestFile = 16 << 20;
constexpr int deepest = 32;

std::string listed(const std::vector<std::string>& names) {
    std::string all;
    for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
    return all;
}

// RFC 6901: ~ and / within a step.
std::string escaped(const std::string& step) {
    std::string text;
    for (const char c : step) text += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
    return text;
}

std::size_t lineOf(const std::string& text, std::size_t byte) {
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(byte, text.size()));
    return 1 + static_cast<std::size_t>(std::count(text.begin(), end, '\n'));
}

}  // namespace

JsonPlace JsonPlace::ofFile(const std::string& file) {
    const std::string text = readTextFile(file, largestFile);
    std::vector<std::set<std::string>> open;  // the members of the objects that are open
    const auto check = [&](int depth, Json::parse_event_t event, Json& parsed) {
        if (depth > deepest) throw InputError({file, 0}, "", "is nested deeper than 32 levels");
        if (event == Json::parse_event_t::object_start) open.emplace_back();
        if (event == Json::parse_event_t::object_end) open.pop_back();
        if (event == Json::parse_event_t::key && !open.back().insert(parsed.get<std::string>()).second)
            throw InputError({file, 0}, parsed.get<std::string>(), "an object has two members of one name");
        return true;
    };
    try {
        return {std::make_shared<Json>(Json::parse(text, check)), file, ""};
    } catch (const Json::parse_error& error) {
        throw InputError({file, lineOf(text, error.byte)}, "", "is no JSON from here on");
    } catch (const Json::exception&) {
        throw InputError({file, 0}, "", "holds a number that is too large");
    }
}

void JsonPlace::refuse(const std::string& reason) const { throw InputError({name(), 0}, value_->dump(), reason); }

Real JsonPlace::number(Real least, Real most) const {
    if (!value_->is_number()) refuse("must be a number");
    const auto value = value_->get<Real>();
    if (!(value >= least && value <= most))
        refuse(most < largest ? "must be from " + formatReal(least) + " to " + formatReal(most)
                              : "must be at least " + formatReal(least));
    return value;
}

std::int64_t JsonPlace::integer(std::int64_t least, std::int64_t most) const {
    const Real value = number(static_cast<Real>(least), static_cast<Real>(most));
    if (value != std::floor(value)) refuse("must be a whole number");
    return static_cast<std::int64_t>(value);
}

std::string JsonPlace::text() const {
    if (!value_->is_string() || value_->get<std::string>().empty()) refuse("must be a text");
    return value_->get<std::string>();
}

Vec3 JsonPlace::vector() const {
    const std::vector<JsonPlace> parts = items();
    if (parts.size() != 3) refuse("must be three numbers");
    return {parts[0].number(-largest, largest), parts[1].number(-largest, largest), parts[2].number(-largest, largest)};
}

Color JsonPlace::color() const {
    if (value_->is_number()) return Color::Constant(number(0, largest));
    const std::vector<JsonPlace> parts = items();
    if (parts.size() != 3) refuse("must be a number, or three for red, green and blue");
    return {parts[0].number(0, largest), parts[1].number(0, largest), parts[2].number(0, largest)};
}

std::string JsonPlace::choice(const std::vector<std::string>& choices) const {
    const std::string chosen = text();
    if (std::find(choices.begin(), choices.end(), chosen) == choices.end()) refuse("must be one of " + listed(choices));
    return chosen;
}

std::vector<JsonPlace> JsonPlace::items() const {
    if (!value_->is_array()) refuse("must be a list");
    std::vector<JsonPlace> all;
    for (std::size_t i = 0; i < value_->size(); ++i) all.push_back(child((*value_)[i], std::to_string(i)));
    return all;
}

std::vector<std::string> JsonPlace::members() const {
    if (!value_->is_object()) refuse("must be an object");
    std::vector<std::string> names;
    for (const auto& member : value_->items()) names.push_back(member.key());
    return names;
}

JsonPlace JsonPlace::operator[](const std::string& member) const {
    if (const auto found = find(member)) return *found;
    throw InputError({name(), 0}, "", "needs a member \"" + member + "\"");
}

std::optional<JsonPlace> JsonPlace::find(const std::string& member) const {
    if (!value_->is_object()) refuse("must be an object");
    const auto found = value_->find(member);
    if (found == value_->end()) return std::nullopt;
    return child(*found, member);
}

void JsonPlace::allow(const std::vector<std::string>& allowed) const {
    for (const std::string& member : members()) {
        if (std::find(allowed.begin(), allowed.end(), member) == allowed.end())
            throw InputError({(*this)[member].name(), 0}, member, "no such member; there are " + listed(allowed));
    }
}

JsonPlace JsonPlace::child(const Json& value, const std::string& step) const {
    return {std::shared_ptr<const Json>(value_, &value), file_, pointer_ + "/" + escaped(step)};
}

// What an object complains of has no file: its place is the name of an argument. What a file of its own is wrong with
// says so itself, with its line.
void JsonPlace::rethrow(const InputError& error) const {
    const std::string& place = error.place().file;
    if (place.rfind(file_ + "#", 0) == 0 || error.place().line > 0 || place.find_first_of("./\\") != std::string::npos)
        throw error;
    throw InputError({name(), 0}, error.value(), (place.empty() ? "" : place + " ") + error.reason());
}

}  // namespace caustic
