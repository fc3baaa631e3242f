#include "integrator/checkpoint.h"

#include <fstream>

#include "core/atomic_file.h"
#include "core/error.h"

namespace caustic {

void saveCheckpoint(const std::filesystem::path& file, std::string_view picture, const Rendering& rendering,
                    const Integrator& integrator) {
    writeAtomically(file, [&](const std::filesystem::path& temporary) {
        std::ofstream out(temporary, std::ios::binary);
        ByteWriter to(out);
        rendering.save(to, picture);
        integrator.save(to);
        to.seal();
        out.close();
        if (!out)
            throw InputError({file.string(), 0}, "", "cannot be written; does the folder exist, is the disk full?");
    });
}

Rendering loadCheckpoint(const std::filesystem::path& file, std::string_view picture, Integrator& integrator) {
    std::ifstream in(file, std::ios::binary);
    if (!in) throw InputError({file.string(), 0}, "", "cannot be opened for reading; is it there?");
    ByteReader from(in, file.string());
    return loadCheckpoint(from, picture, integrator);
}

Rendering loadCheckpoint(ByteReader& from, std::string_view picture, Integrator& integrator) {
    const Camera& camera = integrator.scene().camera();
    Rendering rendering = {Film(camera.width(), camera.height()), {}};
    rendering.load(from, picture);
    integrator.load(from);
    from.checkSeal();
    from.checkEnd();
    return rendering;
}

}  // namespace caustic
