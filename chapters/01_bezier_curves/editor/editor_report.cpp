#include "editor/editor_report.h"

#include <nlohmann/json.hpp>

namespace caustic {

namespace {

const char* kindName(PointKind kind) {
    if (kind == PointKind::Anchor) return "anchor";
    return kind == PointKind::In ? "in" : "out";
}

nlohmann::json pair(const Vec2& point) { return {point.x(), point.y()}; }

}  // namespace

std::string editorReport(const Editor& editor) {
    const EditorModel& model = editor.model();
    nlohmann::json report = {{"file", editor.file().string()},
                             {"changed", model.changed()},
                             {"closed", model.closed()},
                             {"segments", model.segmentCount()},
                             {"status", editor.status()},
                             {"complaining", editor.complaining()},
                             {"u", editor.u()},
                             {"points", nlohmann::json::array()},
                             {"choices", nlohmann::json::array()}};
    for (const PointId& id : model.points()) {
        const Vec2 world = model.position(id);
        report["points"].push_back({{"node", id.node},
                                    {"kind", kindName(id.kind)},
                                    {"smooth", model.nodes()[id.node].smooth},
                                    {"selected", editor.selected() == id},
                                    {"world", pair(world)},
                                    {"pixel", pair(editor.view().toPixel(world))}});
    }
    for (const auto& choice : editor.choices()) report["choices"].push_back(choice.filename().string());
    return report.dump(1) + "\n";
}

}  // namespace caustic
