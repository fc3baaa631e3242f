#include "mesh/gltf_accessor.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/text.h"

namespace caustic {

namespace {

// An accessor without a view is all zeros, and no buffer bounds how many.
constexpr std::size_t mostZeros = std::size_t{1} << 24;

// What the integers of a normalised accessor are divided by; 3.11.
Real largestOf(ScalarType type) {
    switch (type) {
        case ScalarType::Int8:
            return 127;
        case ScalarType::Uint8:
            return 255;
        case ScalarType::Int16:
            return 32767;
        case ScalarType::Uint16:
            return 65535;
        default:
            return 1;
    }
}

std::size_t componentsOf(int type) {
    switch (type) {
        case TINYGLTF_TYPE_SCALAR:
            return 1;
        case TINYGLTF_TYPE_VEC2:
            return 2;
        case TINYGLTF_TYPE_VEC3:
            return 3;
        case TINYGLTF_TYPE_VEC4:
            return 4;
        default:
            return 0;
    }
}

}  // namespace

void GltfAccessors::fail(int accessor, const std::string& value, const std::string& reason) const {
    throw InputError({file_, 0}, value, "accessor " + std::to_string(accessor) + " " + reason);
}

ScalarType GltfAccessors::typeOf(int accessor, int componentType) const {
    switch (componentType) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
            return ScalarType::Int8;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return ScalarType::Uint8;
        case TINYGLTF_COMPONENT_TYPE_SHORT:
            return ScalarType::Int16;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return ScalarType::Uint16;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
            return ScalarType::Uint32;
        case TINYGLTF_COMPONENT_TYPE_FLOAT:
            return ScalarType::Float32;
        default:
            fail(accessor, std::to_string(componentType), "has an unknown type of components");
    }
}

// Each bound by a subtraction that can't overflow.
void GltfAccessors::read(int accessor, int view, std::size_t offset, const Layout& layout, bool strided,
                         std::vector<Real>& into) const {
    if (view < 0 || static_cast<std::size_t>(view) >= model_.bufferViews.size())
        fail(accessor, std::to_string(view), "names a buffer view that isn't there");
    const tinygltf::BufferView& slice = model_.bufferViews[static_cast<std::size_t>(view)];
    if (slice.buffer < 0 || static_cast<std::size_t>(slice.buffer) >= model_.buffers.size())
        fail(accessor, std::to_string(slice.buffer), "lies in a buffer that isn't there");
    const std::vector<unsigned char>& bytes = model_.buffers[static_cast<std::size_t>(slice.buffer)].data;
    if (slice.byteOffset > bytes.size() || slice.byteLength > bytes.size() - slice.byteOffset)
        fail(accessor, "buffer view " + std::to_string(view), "has a buffer view that ends after its buffer");

    const std::size_t element = sizeOf(layout.type) * layout.components;
    const std::size_t stride = strided && slice.byteStride > 0 ? slice.byteStride : element;
    if (stride < element) fail(accessor, std::to_string(stride), "has a stride shorter than its elements");
    const bool fitsOnce = offset <= slice.byteLength && element <= slice.byteLength - offset;
    // NOLINTNEXTLINE(clang-analyzer-core.DivideZero): no type has a size of 0.
    const std::size_t most = fitsOnce ? 1 + (slice.byteLength - offset - element) / stride : 0;
    if (layout.count > most) fail(accessor, std::to_string(layout.count) + " elements", "ends after its buffer view");

    const char* const begin = reinterpret_cast<const char*>(bytes.data()) + slice.byteOffset + offset;
    into.reserve(into.size() + layout.count * layout.components);
    for (std::size_t i = 0; i < layout.count; ++i) {
        for (std::size_t k = 0; k < layout.components; ++k) {
            const char* const place = begin + i * stride + k * sizeOf(layout.type);
            into.push_back(readScalar(place, layout.type, std::endian::little));
        }
    }
}

// Elements that replace those of the view, or the zeros; 3.6.2.3.
void GltfAccessors::applySparse(int accessor, const Layout& layout, std::vector<Real>& into) const {
    const auto& sparse = model_.accessors[static_cast<std::size_t>(accessor)].sparse;
    if (sparse.count < 0 || static_cast<std::size_t>(sparse.count) > layout.count)
        fail(accessor, std::to_string(sparse.count), "has more sparse elements than elements");
    const auto count = static_cast<std::size_t>(sparse.count);
    const ScalarType indexType = typeOf(accessor, sparse.indices.componentType);
    std::vector<Real> indices;
    std::vector<Real> values;
    read(accessor, sparse.indices.bufferView, static_cast<std::size_t>(sparse.indices.byteOffset),
         {count, 1, indexType}, false, indices);
    read(accessor, sparse.values.bufferView, static_cast<std::size_t>(sparse.values.byteOffset),
         {count, layout.components, layout.type}, false, values);
    for (std::size_t i = 0; i < count; ++i) {
        if (!(indices[i] >= 0 && indices[i] < static_cast<Real>(layout.count)) || isReal(indexType))
            fail(accessor, formatReal(indices[i]), "has a sparse index that names no element");
        for (std::size_t k = 0; k < layout.components; ++k)
            into[static_cast<std::size_t>(indices[i]) * layout.components + k] = values[i * layout.components + k];
    }
}

std::vector<Real> GltfAccessors::values(int accessor, std::size_t components) const {
    if (accessor < 0 || static_cast<std::size_t>(accessor) >= model_.accessors.size())
        fail(accessor, "", "is named and isn't there");
    const tinygltf::Accessor& source = model_.accessors[static_cast<std::size_t>(accessor)];
    if (componentsOf(source.type) != components)
        fail(accessor, "", "must have " + std::to_string(components) + " components an element");
    const Layout layout{source.count, components, typeOf(accessor, source.componentType)};
    std::vector<Real> all;
    if (source.bufferView >= 0) {
        read(accessor, source.bufferView, source.byteOffset, layout, true, all);
    } else {
        if (layout.count > mostZeros) fail(accessor, std::to_string(layout.count), "has more zeros than a mesh needs");
        all.resize(layout.count * components);
    }
    if (source.sparse.isSparse) applySparse(accessor, layout, all);
    if (source.normalized && !isReal(layout.type)) {
        for (Real& value : all) value = std::max(value / largestOf(layout.type), Real(-1));
    }
    const auto bad = std::ranges::find_if_not(all, [](Real value) { return std::isfinite(value); });
    if (bad != all.end()) fail(accessor, formatReal(*bad), "must have finite values");
    return all;
}

}  // namespace caustic
