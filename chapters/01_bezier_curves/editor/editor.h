#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "editor/editor_model.h"
#include "image/view_transform.h"

namespace caustic {

/// What the mouse does.
enum class MouseAction { Move, LeftDown, LeftUp, LeftDouble, PanDown, PanUp };

/// Codes of the keys that are no characters, as OpenCV gives them; characters stand for themselves.
namespace editor_key {
inline constexpr int escape = 27;
inline constexpr int backspace = 8;
inline constexpr int remove = 0xffff;
}  // namespace editor_key

/// The editor without its window: turns mouse and keys into changes of the model, and knows what is to be shown.
///
/// Pixels are those of editor_layout. Bad input never leaves it: it ends in the status line.
class Editor {
public:
    /// @param name  a profile to open; one that doesn't exist yet is a new curve to be saved there, when it ends in
    /// .txt;
    ///              empty for an untitled one
    /// @throws InputError when the profile can't be opened
    explicit Editor(const std::string& name);

    /// @param alone  whether Ctrl, Alt or Shift is held: a handle then moves without its partner
    void mouse(MouseAction action, const Vec2& pixel, bool alone);
    void key(int code);
    /// Zooms about a pixel; factor > 1 enlarges.
    void zoom(Real factor, const Vec2& pixel);
    /// The window was closed. Finishes, unless there are changes to be lost: then it asks, and finishes the next time.
    void closeRequested();

    /// Whether it is over, what it edits, how that is seen, and which point the user picked.
    bool finished() const { return finished_; }
    const EditorModel& model() const { return model_; }
    const ViewTransform& view() const { return view_; }
    const std::optional<PointId>& selected() const { return selected_; }

    /// What it says in the status line, and whether that is a complaint.
    const std::string& status() const { return status_; }
    bool complaining() const { return complaining_; }
    void say(const std::string& text);

    /// The parameter whose construction is shown: segment i covers [i, i + 1].
    Real u() const { return u_; }
    /// The segment that u lies on, and t on it; nothing while there is no segment.
    std::optional<CurvePlace> place() const;

    /// What the user switched on: boxes, construction, mirror image, adding points.
    bool showsBoxes() const { return boxes_; }
    bool showsConstruction() const { return construction_; }
    bool showsMirror() const { return mirror_; }
    bool adding() const { return adding_; }
    /// The profiles to choose from while a list of them is shown.
    const std::vector<std::filesystem::path>& choices() const { return choices_; }
    /// Where it will be saved.
    const std::filesystem::path& file() const { return file_; }

private:
    void open(const std::string& name);
    void save();
    void leave();
    void showChoices();
    void choose(std::size_t row);
    void addAt(const Vec2& pixel);
    void removeSelected();
    void setU(Real u);
    void fit();
    void complain(const std::string& text);
    void act(int code);
    // A key while the list of profiles is shown; a key that changes what is seen.
    void answer(int code);
    void look(int code);
    void leftDown(const Vec2& pixel);
    std::optional<PointId> pointAt(const Vec2& pixel) const;

    EditorModel model_;
    ViewTransform view_;
    std::filesystem::path file_;
    bool overwrites_ = false;  // whether file_ is what was opened or saved before
    std::optional<PointId> selected_;
    std::string status_;
    bool complaining_ = false;
    Real u_ = 0;
    bool boxes_ = true;
    bool construction_ = true;
    bool mirror_ = false;
    bool adding_ = false;
    bool sliding_ = false;
    bool finished_ = false;
    int confirming_ = 0;  // the key that was pressed once and must be pressed again
    std::optional<Vec2> panningFrom_;
    Vec2 grip_ = Vec2::Zero();  // from the mouse to the point that it drags
    std::vector<std::filesystem::path> choices_;
};

}  // namespace caustic
