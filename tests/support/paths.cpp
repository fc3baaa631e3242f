#include "support/paths.h"

namespace caustic::test {

std::filesystem::path sourceDir() { return CAUSTIC_SOURCE_DIR; }

}  // namespace caustic::test
