#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "math/real.h"

namespace caustic::test {

/// Writes glTF files for tests of the reader, one accessor after the other. What is added goes into `json`, which a
/// test may change before it asks for the file.
class GltfWriter {
public:
    GltfWriter();

    /// Adds an accessor of float, ushort and so on (as PLY calls types); returns its number.
    /// @param stride  bytes from element to element; 0 for no gaps
    int add(const std::vector<Real>& values, std::size_t components, const std::string& type, bool normalized = false,
            std::size_t stride = 0);

    /// Adds a view of those bytes; returns its number.
    int addView(const std::string& bytes, std::size_t stride = 0);

    /// Adds a primitive of one mesh; indices -1: none.
    void addPrimitive(const nlohmann::json& attributes, int indices, int mode = 4);

    /// The file as text, its buffer within.
    std::string text() const;

    /// The file as GLB.
    std::string binary() const;

    nlohmann::json json;  ///< all but the buffer

private:
    std::string buffer_;
};

}  // namespace caustic::test
