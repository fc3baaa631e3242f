#pragma once

#include <cstddef>
#include <new>
#include <type_traits>
#include <utility>

#include "material/bsdf.h"

namespace caustic {

/// Room for one BSDF of any kind, so that none is ever made on the heap. A value: copies hold a copy.
class BsdfBuffer {
public:
    /// Bytes that the largest model may take.
    static constexpr std::size_t capacity = 384;

    /// Holds nothing.
    BsdfBuffer() = default;
    /// Copies what is held.
    BsdfBuffer(const BsdfBuffer& other) { *this = other; }
    /// The same.
    BsdfBuffer& operator=(const BsdfBuffer& other) {
        if (this == &other) return *this;
        copy_ = other.copy_;
        bsdf_ = copy_ != nullptr ? copy_(storage_, *other.bsdf_) : nullptr;
        return *this;
    }
    ~BsdfBuffer() = default;

    /// Makes a model in place of what was held.
    template <typename Model, typename... Arguments>
    void emplace(Arguments&&... arguments) {
        static_assert(std::is_base_of_v<Bsdf, Model> && sizeof(Model) <= capacity);
        // Models hold numbers only: leaving one without a call to its destructor loses nothing.
        bsdf_ = new (storage_) Model(std::forward<Arguments>(arguments)...);
        copy_ = [](std::byte* to, const Bsdf& from) -> Bsdf* {
            return new (to) Model(static_cast<const Model&>(from));
        };
    }

    /// What is held; null for nothing.
    const Bsdf* get() const { return bsdf_; }

private:
    using Copy = Bsdf* (*)(std::byte*, const Bsdf&);

    alignas(std::max_align_t) std::byte storage_[capacity];
    Bsdf* bsdf_ = nullptr;
    Copy copy_ = nullptr;
};

}  // namespace caustic
