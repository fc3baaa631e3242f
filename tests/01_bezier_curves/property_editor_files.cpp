#include <gtest/gtest.h>

#include <fstream>

#include "core/error.h"
#include "curve/profile_file.h"
#include "curve/profile_text.h"
#include "editor/editor.h"
#include "editor/editor_layout.h"
#include "editor/editor_model.h"
#include "editor_curves.h"
#include "support/temporary_folder.h"

namespace caustic {
namespace {

using namespace test;

TEST(Editor, SavesWhatItShows) {
    const test::TemporaryFolder folder;
    Editor editor(saved(folder, waveSpline()).string());
    drag(editor, pixelOf(editor, {0, PointKind::Out}), Vec2(200, 50));
    editor.key('s');
    EXPECT_FALSE(editor.model().changed()) << editor.status();
    EXPECT_EQ(profileText(loadProfile((folder / "wave.txt").string())), profileText(*editor.model().spline()));
}

TEST(Editor, AnSvgIsSavedAsTextBesideIt) {
    const test::TemporaryFolder folder;
    std::ofstream(folder / "a.svg")
        << R"(<svg xmlns="http://www.w3.org/2000/svg" height="10"><path d="M0 0C1 2 3 4 5 6"/></svg>)";
    Editor editor((folder / "a.svg").string());
    editor.key('s');
    EXPECT_EQ(profileText(loadProfile((folder / "a.txt").string())), profileText(*editor.model().spline()));
}

TEST(Editor, AsksBeforeItReplacesAFileThatItDidNotOpen) {
    const test::TemporaryFolder folder;
    std::ofstream(folder / "a.txt") << "precious";
    std::ofstream(folder / "a.svg")
        << R"(<svg xmlns="http://www.w3.org/2000/svg" height="10"><path d="M0 0C1 2 3 4 5 6"/></svg>)";
    Editor editor((folder / "a.svg").string());
    const auto contents = [&] {
        std::ifstream file(folder / "a.txt");
        return std::string(std::istreambuf_iterator<char>(file), {});
    };
    editor.key('s');
    EXPECT_TRUE(editor.complaining());
    EXPECT_EQ(contents(), "precious");
    editor.key('b');
    editor.key('s');
    EXPECT_EQ(contents(), "precious") << "Does another key in between take the question back?";
    editor.key('s');
    EXPECT_NE(contents(), "precious");
    EXPECT_FALSE(editor.complaining()) << editor.status();
}

TEST(Editor, AsksBeforeChangesAreLost) {
    const test::TemporaryFolder folder;
    const auto changed = [&] {
        Editor editor(saved(folder, waveSpline()).string());
        drag(editor, pixelOf(editor, {1, PointKind::Anchor}), {300, 300});
        return editor;
    };
    Editor quitting = changed();
    quitting.key('q');
    EXPECT_FALSE(quitting.finished());
    quitting.key('q');
    EXPECT_TRUE(quitting.finished());

    Editor working = changed();
    working.key('q');
    drag(working, pixelOf(working, {1, PointKind::Anchor}), {350, 300});
    working.key('q');
    EXPECT_FALSE(working.finished()) << "A question from long ago is not answered now.";

    Editor closing = changed();
    closing.closeRequested();
    EXPECT_FALSE(closing.finished());
    closing.closeRequested();
    EXPECT_TRUE(closing.finished());

    Editor saving = changed();
    saving.key('q');
    saving.key('s');
    saving.key('q');
    EXPECT_TRUE(saving.finished());

    Editor opening = changed();
    opening.key('o');
    EXPECT_TRUE(opening.choices().empty());
    opening.key('o');
    EXPECT_FALSE(opening.choices().empty());

    Editor untouched(saved(folder, waveSpline()).string());
    untouched.key('q');
    EXPECT_TRUE(untouched.finished());
}

TEST(Editor, OpensAnotherProfileFromTheList) {
    const test::TemporaryFolder folder;
    saveProfileText(ringSpline(), folder / "ring.txt");
    std::ofstream(folder / "broken.txt") << "1 2 three";
    std::ofstream(folder / "other.dat") << "no profile";
    Editor editor(saved(folder, waveSpline()).string());
    editor.key('o');
    ASSERT_EQ(editor.choices().size(), 3U) << "broken.txt, ring.txt, wave.txt";
    editor.key('1');
    EXPECT_TRUE(editor.complaining()) << "A broken file is said, not thrown.";
    EXPECT_EQ(profileText(*editor.model().spline()), profileText(waveSpline())) << "And what was there stays.";
    editor.key('o');
    click(editor, editor_layout::chooserRow(1).center());
    EXPECT_EQ(profileText(*editor.model().spline()), profileText(ringSpline()));
    EXPECT_EQ(editor.file().filename(), "ring.txt");
    editor.key('o');
    editor.key(editor_key::escape);
    EXPECT_TRUE(editor.choices().empty());
    EXPECT_FALSE(editor.finished());
}

TEST(Editor, BeginsANewFile) {
    const test::TemporaryFolder folder;
    Editor editor((folder / "new.txt").string());
    EXPECT_EQ(editor.model().nodes().size(), 0U);
    editor.key('s');
    EXPECT_TRUE(editor.complaining()) << "There is nothing to save yet.";
    editor.mouse(MouseAction::LeftDouble, {100, 100}, false);
    editor.mouse(MouseAction::LeftDouble, {400, 300}, false);
    editor.key('s');
    EXPECT_EQ(loadProfile((folder / "new.txt").string()).segments().size(), 1U);
}

TEST(Editor, RefusesWhatCannotBeOpened) {
    const test::TemporaryFolder folder;
    EXPECT_THROW(Editor((folder / "none.svg").string()), InputError);
    EXPECT_THROW(Editor((folder / "none" / "a.txt").string()), InputError);
    EXPECT_THROW(Editor(folder.path().string()), InputError);
    std::ofstream(folder / "bad.txt") << "0 0\n1 nan\n";
    EXPECT_THROW(Editor((folder / "bad.txt").string()), InputError);
}

TEST(Editor, SaysWhatCannotBeSaved) {
    const test::TemporaryFolder folder;
    Editor editor(saved(folder, waveSpline()).string());
    std::filesystem::remove(folder / "wave.txt");
    std::filesystem::create_directory(folder / "wave.txt");
    drag(editor, pixelOf(editor, {1, PointKind::Anchor}), {300, 300});
    editor.key('s');
    EXPECT_TRUE(editor.complaining());
    EXPECT_TRUE(editor.model().changed()) << "What isn't on the disk isn't saved.";
}

}  // namespace
}  // namespace caustic
