#include "core/progress.h"
#include "failures/root_examination.h"
#include "figure/failures.h"
#include "figures.h"

namespace caustic {

void chartFailures(FigureContext& context) {
    const auto revolutionSets = revolutionSetNames();
    const auto patchSets = patchSetNames();
    context.progress().expect(static_cast<std::int64_t>(revolutionSets.size() + patchSets.size()));
    const std::int64_t rays = context.byQuality<std::int64_t>(400, 16'000);
    std::vector<FailureRow> rows;
    const auto add = [&](const std::string& name, const RootExamination& count) {
        for (const NearestCount& method : count.nearest) {
            if (method.trials > 0)
                rows.push_back({method.method, name, method.failures, method.trials, method.method == "robust"});
        }
        context.progress().advance();
    };
    for (std::size_t set = 0; set < revolutionSets.size(); ++set) {
        add("revolution: " + revolutionSets[set], examineRevolution(set, rays, context.seed(), context.threads()));
    }
    for (std::size_t set = 0; set < patchSets.size(); ++set) {
        add("patch: " + patchSets[set], examinePatches(set, rays / 4, context.seed(), context.threads()));
    }
    drawFailureMarks(rows, context);
}

}  // namespace caustic
