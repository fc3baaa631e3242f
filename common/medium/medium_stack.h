#pragma once

#include <algorithm>
#include <array>

#include "math/hit.h"
#include "medium/interior.h"

namespace caustic {

/// Which objects with an interior a path is in. The one that fills the place is that of the highest priority; among
/// equals, the one with the smallest id, whichever was entered first, so that a path and its reverse agree. Source:
/// Schmidt, Budge 2002, Simple Nested Dielectrics in Ray Traced Images, Journal of Graphics Tools 7(2).
class MediumStack {
public:
    /// More objects than this may not overlap at one place.
    static constexpr int mostNested = 8;

    /// In empty space.
    MediumStack() = default;
    /// Copies what is there: paths carry their media along, and mostly they are in none.
    MediumStack(const MediumStack& other) { *this = other; }
    /// The same.
    MediumStack& operator=(const MediumStack& other) {
        std::copy_n(other.entries_.begin(), other.count_, entries_.begin());
        count_ = other.count_;
        return *this;
    }
    ~MediumStack() = default;

    /// What fills the place; null in empty space.
    const Interior* current() const;

    /// Index of refraction of what fills the place; 1 in empty space.
    Real ior() const;

    /// What absorbs or scatters there; null for neither.
    const Medium* medium() const;

    /// Whether the path is in the object.
    bool contains(ObjectId object) const;

    /// The object that fills the place, noObject in empty space.
    ObjectId object() const;

    /// The path enters or leaves an object. One that it is in already, since the object's surface overlaps itself,
    /// counts twice from then on: it takes two leavings to be out. Leaving one that it isn't in changes nothing.
    /// @param interior  the object's; kept by reference
    /// @throws InputError when more than mostNested would overlap
    void enter(ObjectId object, const Interior& interior);
    /// The path leaves an object.
    void leave(ObjectId object);

private:
    struct Entry {
        ObjectId object;
        const Interior* interior;
    };
    const Entry* top() const;

    std::array<Entry, mostNested> entries_;  // the first count_ are set
    int count_ = 0;
};

/// What crossing a boundary does to a path.
struct Crossing {
    MediumStack before;  ///< on the side that it comes from
    MediumStack after;   ///< on the other side

    /// Whether something else fills the place behind the boundary. If not, the boundary is hidden within an object of
    /// higher priority, and light goes on as if it weren't there.
    bool counts() const { return before.object() != after.object(); }
};

/// Crosses the boundary of an object with an interior: `before` is what the path was in, and `after` has the object
/// once more when the path enters, once less when it leaves. Whether the boundary counts plays no part in that.
///
/// A path that leaves an object which it never entered must have been in it without knowing: it started there. Then
/// `before` has it.
/// @param media     what the path is in
/// @param entering  whether it comes from the side that ng points to
Crossing crossBoundary(const MediumStack& media, ObjectId object, const Interior& interior, bool entering);

}  // namespace caustic
