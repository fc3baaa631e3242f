#include "render_command.h"

#include <chrono>
#include <cstdio>
#include <optional>
#include <thread>

#include "core/check.h"
#include "core/process.h"
#include "core/progress.h"
#include "integrator/render.h"

namespace caustic {

namespace {

// When a rendering ends.
RenderSettings limitsOf(const RenderWishes& wishes) {
    checkArgument(wishes.passes != 0 || wishes.seconds != 0, "--render", "", "needs --passes or --time");
    RenderSettings limits;
    if (wishes.passes != 0) limits.passes = wishes.passes;
    if (wishes.seconds != 0) limits.seconds = wishes.seconds;
    return limits;
}

// Shows the growing picture in a window: the viewer looks at the file again and again. Ends with the window.
class LivePreview {
public:
    explicit LivePreview(std::filesystem::path file) : file_(std::move(file)) {}
    ~LivePreview() {
        if (viewer_.joinable()) viewer_.join();
    }
    // When the file is there.
    void start() {
        if (viewer_.joinable()) return;
        viewer_ = std::thread([file = file_] {
            const auto self = std::filesystem::read_symlink("/proc/self/exe");
            const auto result = runProcess({(self.parent_path() / "preview").string(), file.string()});
            if (!result || result->exitCode != 0) std::fprintf(stderr, "--preview: no window can be opened here\n");
        });
    }

private:
    std::filesystem::path file_;
    std::thread viewer_;
};

}  // namespace

void renderScene(const std::string& name, const RenderWishes& wishes, const ChapterInputs& chapter,
                 const ChapterOptions& options) {
    RenderSettings settings = limitsOf(wishes);
    SceneRendering scene(name, wishes, chapter, options);
    Rendering rendering = scene.begun();
    std::optional<LivePreview> preview;
    if (options.preview) preview.emplace(scene.file());
    auto shown = std::chrono::steady_clock::now();
    const auto look = [&](const Rendering& soFar) {
        if (soFar.passes % wishes.every == 0) scene.saveState(soFar);
        const auto now = std::chrono::steady_clock::now();
        if (preview && (soFar.passes == 1 || now - shown > std::chrono::seconds(1))) {
            shown = now;
            scene.savePicture(soFar);
            preview->start();
        }
        return true;
    };
    {
        Progress progress(name);
        progress.expect(progressSteps);
        settings.threads = options.threads;
        settings.look = look;
        settings.choose = [&scene](const Rendering& soFar) { return scene.pathsOf(soFar.passes); };
        settings.progress = &progress;
        resume(scene.sppm(), settings, rendering);
    }
    scene.finish(rendering);
}

}  // namespace caustic
