// tinygltf compiled here, so that the sanitizers see into it; Debian's shared library has the same source.

#define TINYGLTF_IMPLEMENTATION
#include <tiny_gltf.h>
