#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

namespace caustic {

/// Writes a file so that nobody ever sees half of it: `write` fills a temporary file in the same folder (with the same
/// extension, so that image writers know the format), which then replaces `path`. Makes missing folders.
/// When `write` throws, the temporary file is removed and `path` stays as it was.
/// @throws InputError when the folder cannot be made or written, or `path` is a device, a pipe or a socket
void writeAtomically(const std::filesystem::path& path,
                     const std::function<void(const std::filesystem::path& temporary)>& write);

/// The same for text.
void writeTextAtomically(const std::filesystem::path& path, std::string_view text);

}  // namespace caustic
