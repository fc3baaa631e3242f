#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <opencv2/core.hpp>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/highgui.hpp>

#include "core/atomic_file.h"
#include "core/error.h"
#include "editor/editor.h"
#include "editor/editor_layout.h"
#include "editor/editor_painter.h"
#include "editor/editor_report.h"

namespace caustic {
namespace {

constexpr int exitFailure = 1;
constexpr int exitBadInput = 2;
constexpr int waitMilliseconds = 15;

struct Options {
    std::string profile;
    std::string report;
};

// OpenCV's Qt windows magnify their pixels by the wheel, whatever the program wants, and then a drag moves the
// magnified view as well. So the editor rests until the wheel is turned back. The steps are Qt's own (window_QT.cpp,
// scaleView).
class WheelMagnifier {
public:
    void turn(int delta) { factor_ = std::max(1.0, factor_ * (1 + delta / 240.0 / 5)); }
    bool active() const { return factor_ > 1; }
    void reset() { factor_ = 1; }

private:
    double factor_ = 1;
};

class EditorWindow {
public:
    EditorWindow(Editor& editor, std::string report)
        : editor_(editor), report_(std::move(report)), title_("Bezier editor") {
        open();
    }
    EditorWindow(const EditorWindow&) = delete;
    EditorWindow& operator=(const EditorWindow&) = delete;
    ~EditorWindow() { cv::destroyAllWindows(); }

    // Until the user is done.
    void run() {
        while (!editor_.finished()) {
            if (stale_) show();
            const int key = cv::waitKeyEx(waitMilliseconds);
            if (key >= 0) {
                editor_.key(key);
                stale_ = true;
            }
            if (!editor_.finished() && cv::getWindowProperty(title_, cv::WND_PROP_VISIBLE) < 1) closed();
        }
    }

private:
    void open() {
        cv::namedWindow(title_, cv::WINDOW_AUTOSIZE | cv::WINDOW_GUI_NORMAL);
        cv::setMouseCallback(title_, &EditorWindow::onMouse, this);
        magnifier_.reset();
        stale_ = true;
    }

    // A window that is closed is gone; the question whether to save needs a new one.
    void closed() {
        editor_.closeRequested();
        if (!editor_.finished()) open();
    }

    void show() {
        stale_ = false;
        const Drawing& drawing = painter_.paint(editor_);
        std::vector<std::uint8_t> pixels = drawing.bgr();
        cv::imshow(title_, cv::Mat(drawing.height(), drawing.width(), CV_8UC3, pixels.data()));
        if (!report_.empty()) writeTextAtomically(report_, editorReport(editor_));
    }

    static void onMouse(int event, int x, int y, int flags, void* self) {
        static_cast<EditorWindow*>(self)->mouse(event, {x + 0.5, y + 0.5}, flags);
    }

    void mouse(int event, const Vec2& pixel, int flags) {
        if (event == cv::EVENT_MOUSEWHEEL) {
            magnifier_.turn(cv::getMouseWheelDelta(flags));
            editor_.say(magnifier_.active() ? "Magnified pixels: turn the wheel back to go on; + and − zoom" : "");
            stale_ = true;
            return;
        }
        if (magnifier_.active()) return;
        const bool alone = (flags & (cv::EVENT_FLAG_CTRLKEY | cv::EVENT_FLAG_ALTKEY | cv::EVENT_FLAG_SHIFTKEY)) != 0;
        const bool pressed = (flags & (cv::EVENT_FLAG_LBUTTON | cv::EVENT_FLAG_RBUTTON | cv::EVENT_FLAG_MBUTTON)) != 0;
        if (event == cv::EVENT_MOUSEMOVE && !pressed) return;  // nothing looks different below a mouse that only passes
        if (const auto action = actionOf(event)) {
            editor_.mouse(*action, pixel, alone);
            stale_ = true;
        }
    }

    static std::optional<MouseAction> actionOf(int event) {
        switch (event) {
            case cv::EVENT_MOUSEMOVE:
                return MouseAction::Move;
            case cv::EVENT_LBUTTONDOWN:
                return MouseAction::LeftDown;
            case cv::EVENT_LBUTTONUP:
                return MouseAction::LeftUp;
            case cv::EVENT_LBUTTONDBLCLK:
                return MouseAction::LeftDouble;
            case cv::EVENT_RBUTTONDOWN:
            case cv::EVENT_MBUTTONDOWN:
                return MouseAction::PanDown;
            case cv::EVENT_RBUTTONUP:
            case cv::EVENT_MBUTTONUP:
                return MouseAction::PanUp;
            default:
                return std::nullopt;
        }
    }

    Editor& editor_;
    EditorPainter painter_;
    std::string report_;
    std::string title_;  // plain ASCII: OpenCV finds its Qt windows by it
    WheelMagnifier magnifier_;
    bool stale_ = true;
};

// Qt ends the process when there is no screen, in words of its own; so it is asked before.
void checkScreen() {
    const char* const display = std::getenv("DISPLAY");
    const char* const wayland = std::getenv("WAYLAND_DISPLAY");
    const bool any = (display != nullptr && *display != '\0') || (wayland != nullptr && *wayland != '\0');
    if (!any) throw InputError({"DISPLAY", 0}, "", "no screen to open a window on");
}

void edit(const Options& options) {
    Editor editor(options.profile);
    checkScreen();
    cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
    EditorWindow(editor, options.report).run();
}

int run(int argc, const char* const* argv) {
    CLI::App app{"Draws and changes profiles: piecewise cubic Bézier curves. Mouse and keys are shown in the window.",
                 "bezier_editor"};
    Options options;
    app.add_option("profile", options.profile,
                   "A profile: control points (.txt) or SVG (.svg, perhaps with #id or #number of a path); "
                   "a .txt that doesn't exist yet is begun. Saved as .txt")
        ->type_name("FILE");
    app.add_option("--report", options.report, "Write what the window shows to this file, as JSON, after every change")
        ->type_name("FILE");
    try {
        app.parse(argc, argv);
        edit(options);
        return 0;
    } catch (const CLI::Success& request) {
        return app.exit(request);
    } catch (const CLI::ParseError& error) {
        std::fprintf(stderr, "bezier_editor: %s; see --help\n", error.what());
        return exitBadInput;
    } catch (const InputError& error) {
        std::fprintf(stderr, "bezier_editor: %s\n", error.what());
        return exitBadInput;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bezier_editor: %s\n", error.what());
        return exitFailure;
    }
}

}  // namespace
}  // namespace caustic

// What CLI11 throws as the options are declared is a mistake in them: the program may end by it.
int main(int argc, char** argv) { return caustic::run(argc, argv); }  // NOLINT(bugprone-exception-escape)
