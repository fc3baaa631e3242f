#pragma once

#include <filesystem>
#include <string>

namespace caustic::test {

/// Top of the tree that the test was built from; assets lie below it.
std::filesystem::path sourceDir();

/// The executable of the test's chapter. Not for graded tests, which know the library only.
std::string chapterProgram();

}  // namespace caustic::test
