#include "texture/check_color.h"

#include <cmath>
#include <string>

#include "core/error.h"
#include "core/text.h"

namespace caustic {

void checkNotNegative(const Color& color, std::string_view what) {
    for (const Real channel : color) {
        if (!std::isfinite(channel) || channel < 0)
            throw InputError({std::string(what), 0}, formatReal(channel), "must be finite and at least 0");
    }
}

void checkReflectance(const Color& color, std::string_view what) {
    for (const Real channel : color) {
        if (!(channel >= 0 && channel <= 1))
            throw InputError({std::string(what), 0}, formatReal(channel), "must be between 0 and 1");
    }
}

}  // namespace caustic
