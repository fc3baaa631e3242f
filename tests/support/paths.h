#pragma once

#include <filesystem>

namespace caustic::test {

/// Top of the tree that the test was built from; assets lie below it.
std::filesystem::path sourceDir();

}  // namespace caustic::test
