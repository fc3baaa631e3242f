#include "medium/medium_stack.h"

#include <algorithm>
#include <string>

#include "core/error.h"
#include "core/not_implemented.h"

namespace caustic {

const Interior* MediumStack::current() const { return count_ > 0 ? top()->interior : nullptr; }

Real MediumStack::ior() const { return count_ > 0 ? top()->interior->ior : 1; }

const Medium* MediumStack::medium() const { return count_ > 0 ? top()->interior->medium.get() : nullptr; }

ObjectId MediumStack::object() const { return count_ > 0 ? top()->object : noObject; }

bool MediumStack::contains(ObjectId object) const {
    return std::any_of(entries_.begin(), entries_.begin() + count_, [&](const Entry& e) { return e.object == object; });
}

void MediumStack::enter(ObjectId object, const Interior& interior) {
    if (count_ == mostNested) {
        throw InputError({"media", 0}, std::to_string(count_ + 1),
                         contains(object)
                             ? "an object is entered again and again and never left: its surface isn't closed"
                             : "more objects overlap than are kept track of");
    }
    entries_[static_cast<std::size_t>(count_++)] = {object, &interior};
}

void MediumStack::leave(ObjectId object) {
    const auto end = entries_.begin() + count_;
    const auto found = std::find_if(entries_.begin(), end, [&](const Entry& e) { return e.object == object; });
    if (found == end) return;
    std::copy(found + 1, end, found);
    --count_;
}

const MediumStack::Entry* MediumStack::top() const {
    return std::max_element(entries_.begin(), entries_.begin() + count_, [](const Entry& a, const Entry& b) {
        if (a.interior->priority != b.interior->priority) return a.interior->priority < b.interior->priority;
        return a.object > b.object;
    });
}

Crossing crossBoundary(const MediumStack& media, ObjectId object, const Interior& interior, bool entering) {
    //! [ex-05.6]
    Crossing crossing = {media, media};
    if (entering) {
        crossing.after.enter(object, interior);
        return crossing;
    }
    if (!media.contains(object)) crossing.before.enter(object, interior);
    crossing.after.leave(object);
    return crossing;
    //! [ex-05.6]
}

}  // namespace caustic
