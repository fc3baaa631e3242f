#pragma once

#include <tiny_gltf.h>

#include <string>
#include <vector>

#include "math/real.h"
#include "mesh/scalar_type.h"

namespace caustic {

/// Reads the accessors of a glTF file: strides, sparse values and normalised integers included. Every place is checked
/// before it is read, for tinygltf doesn't.
/// Source: Khronos 2021, glTF 2.0, 3.6.2 and 3.11.
class GltfAccessors {
public:
    /// @param model  outlives this
    /// @param file   what an error's place is called
    GltfAccessors(const tinygltf::Model& model, const std::string& file) : model_(model), file_(file) {}

    /// All values, the components of an element after each other.
    /// @param accessor    number of the accessor
    /// @param components  how many an element must have
    /// @throws InputError with the accessor's number: it isn't there, has other components, reaches beyond its view or
    ///         buffer, or has a value that is not finite
    std::vector<Real> values(int accessor, std::size_t components) const;

    /// Refuses what is wrong with an accessor.
    [[noreturn]] void fail(int accessor, const std::string& value, const std::string& reason) const;

private:
    struct Layout {
        std::size_t count = 0;
        std::size_t components = 0;
        ScalarType type = ScalarType::Float32;
    };

    ScalarType typeOf(int accessor, int componentType) const;
    void read(int accessor, int view, std::size_t offset, const Layout& layout, bool strided,
              std::vector<Real>& into) const;
    void applySparse(int accessor, const Layout& layout, std::vector<Real>& into) const;

    const tinygltf::Model& model_;
    const std::string& file_;
};

}  // namespace caustic
