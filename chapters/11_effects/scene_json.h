#pragma once

#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/error.h"
#include "math/color.h"
#include "math/vector.h"

namespace caustic {

/// A value in a JSON file, which knows where it stands: errors say the file and the value's JSON pointer (RFC 6901), as
/// in "scene.json#/objects/2/shape/radius". A value; the file's text stays alive with it.
class JsonPlace {
public:
    /// Reads a file.
    /// @throws InputError when it is missing, over 16 MiB, no JSON, nested deeper than 32 levels, or an object has two
    ///         members of one name
    static JsonPlace ofFile(const std::string& file);

    /// Where it stands.
    std::string name() const { return file_ + "#" + pointer_; }
    /// The file that it stands in.
    const std::string& file() const { return file_; }

    /// @throws InputError with this place and value
    [[noreturn]] void refuse(const std::string& reason) const;

    /// Larger numbers are taken for a slip of the pen.
    static constexpr Real largest = 1e30;

    /// What it holds. All of them throw InputError when it is something else, or out of the range.
    Real number(Real least, Real most) const;
    /// A whole number.
    std::int64_t integer(std::int64_t least, std::int64_t most) const;
    /// A text that isn't empty.
    std::string text() const;
    /// Three numbers.
    Vec3 vector() const;
    /// Three numbers of at least 0, or one for all three.
    Color color() const;
    /// One of these texts.
    std::string choice(const std::vector<std::string>& choices) const;
    /// Whether it is an object, and not a text, a number or a list.
    bool isObject() const { return value_->is_object(); }
    /// Whether it is a list.
    bool isList() const { return value_->is_array(); }

    /// The values of a list.
    std::vector<JsonPlace> items() const;

    /// The names of an object's members, in the file's order.
    std::vector<std::string> members() const;
    /// A member of an object.
    JsonPlace operator[](const std::string& member) const;
    /// The same, if it is there.
    std::optional<JsonPlace> find(const std::string& member) const;
    /// Refuses members of other names.
    void allow(const std::vector<std::string>& members) const;

    /// Makes something of the value. What that throws gets this place if it names no file.
    template <typename Make>
    auto make(const Make& what) const {
        try {
            return what();
        } catch (const InputError& error) {
            rethrow(error);
        }
    }

private:
    using Json = nlohmann::ordered_json;

    JsonPlace(std::shared_ptr<const Json> value, std::string file, std::string pointer)
        : value_(std::move(value)), file_(std::move(file)), pointer_(std::move(pointer)) {}

    JsonPlace child(const Json& value, const std::string& step) const;
    [[noreturn]] void rethrow(const InputError& error) const;

    std::shared_ptr<const Json> value_;
    std::string file_;
    std::string pointer_;
};

/// One kind of thing that an object of a file may describe: its member "type" says which.
template <typename Made>
struct JsonKind {
    std::string name;
    std::vector<std::string> members;  ///< beside "type"
    std::function<Made(const JsonPlace&)> make;
};

/// Makes what an object describes.
/// @throws InputError when its type is none of these, or it has other members
template <typename Made>
Made makeKind(const JsonPlace& place, const std::vector<JsonKind<Made>>& kinds) {
    std::vector<std::string> names;
    for (const auto& kind : kinds) names.push_back(kind.name);
    const std::string type = place["type"].choice(names);
    for (const auto& kind : kinds) {
        if (kind.name != type) continue;
        std::vector<std::string> members = kind.members;
        members.push_back("type");
        place.allow(members);
        return place.make([&] { return kind.make(place); });
    }
    place.refuse("is of no type that there is");
}

}  // namespace caustic
