#include "core/atomic_file.h"

#include <unistd.h>

#include <fstream>
#include <string>

#include "core/error.h"

namespace caustic {

namespace {

class TemporaryFile {
public:
    explicit TemporaryFile(std::filesystem::path path) : path_(std::move(path)) {}
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile() {
        std::error_code ignored;
        std::filesystem::remove(path_, ignored);
    }
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

std::filesystem::path temporaryBeside(const std::filesystem::path& path) {
    const std::string name = "." + path.stem().string() + "." + std::to_string(getpid()) + ".part";
    return path.parent_path() / (name + path.extension().string());
}

}  // namespace

void writeAtomically(const std::filesystem::path& path,
                     const std::function<void(const std::filesystem::path& temporary)>& write) {
    std::error_code failure;
    if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), failure);
    if (failure)
        throw InputError({path.parent_path().string(), 0}, "", "this folder cannot be made: " + failure.message());
    // Root may replace even /dev/null, and every program that writes there would fill a file from then on.
    if (std::filesystem::is_other(path)) throw InputError({path.string(), 0}, "", "is a device, not a file to replace");

    const TemporaryFile temporary(temporaryBeside(path));
    write(temporary.path());
    std::filesystem::rename(temporary.path(), path, failure);
    if (failure) throw InputError({path.string(), 0}, "", "cannot be written: " + failure.message());
}

void writeTextAtomically(const std::filesystem::path& path, std::string_view text) {
    writeAtomically(path, [&](const std::filesystem::path& temporary) {
        std::ofstream file(temporary, std::ios::binary);
        file.write(text.data(), static_cast<std::streamsize>(text.size()));
        file.close();
        if (!file)
            throw InputError({path.string(), 0}, "", "cannot be written; does the folder exist, is the disk full?");
    });
}

}  // namespace caustic
