#include <gtest/gtest.h>

#include <limits>

#include <opencv2/core.hpp>

#include "core/error.h"
#include "core/random.h"
#include "image/view_transform.h"

namespace caustic {
namespace {

const Vec2 nowhere(std::numeric_limits<Real>::quiet_NaN(), 0);

TEST(ViewTransform, GoesThereAndBack) {
    const ViewTransform view =
        ViewTransform::fit(Bounds2(Vec2(-3, 2), Vec2(5, 4)), Bounds2(Vec2(0, 0), Vec2(640, 480)), 20);
    Random random(44, {0});
    for (int i = 0; i < 1000; ++i) {
        const Vec2 world(random.uniform(-10, 10), random.uniform(-10, 10));
        EXPECT_LT((view.toWorld(view.toPixel(world)) - world).norm(), 1e-12);
    }
}

TEST(ViewTransform, FitsTheWorldIntoTheMargins) {
    const Bounds2 pixels(Vec2(100, 50), Vec2(740, 530));
    Random random(45, {0});
    for (int i = 0; i < 1000; ++i) {
        Bounds2 world;
        for (int corner = 0; corner < 2; ++corner) world.extend(Vec2(random.uniform(-5, 5), random.uniform(-5, 5)));
        const ViewTransform view = ViewTransform::fit(world, pixels, 20);
        Bounds2 shown;
        shown.extend(view.toPixel(world.min()));
        shown.extend(view.toPixel(world.max()));
        const Vec2 left = shown.min() - pixels.min();
        const Vec2 right = pixels.max() - shown.max();
        EXPECT_LT((left - right).norm(), 1e-9) << "Is it in the middle?";
        EXPECT_NEAR(std::min(left.x(), left.y()), 20, 1e-9) << "As large as it goes?";
        EXPECT_NEAR(shown.sizes().x() / world.sizes().x(), shown.sizes().y() / world.sizes().y(), 1e-6 * view.scale());
    }
}

TEST(ViewTransform, TurnsUpUp) {
    const ViewTransform view(Vec2(1, 1), Vec2(100, 100), 10);
    EXPECT_EQ(view.toPixel({1, 1}), Vec2(100, 100));
    EXPECT_EQ(view.toPixel({2, 3}), Vec2(110, 80)) << "Does y point up in the world, down in pixels?";
}

TEST(ViewTransform, ShowsLinesAndPointsToo) {
    const Bounds2 pixels(Vec2(0, 0), Vec2(200, 100));
    EXPECT_NEAR(ViewTransform::fit(Bounds2(Vec2(1, 1), Vec2(3, 1)), pixels, 10).scale(), 90, 1e-12);
    EXPECT_NEAR(ViewTransform::fit(Bounds2(Vec2(1, 1), Vec2(1, 2)), pixels, 10).scale(), 80, 1e-12);
    const ViewTransform point = ViewTransform::fit(Bounds2(Vec2(7, 7), Vec2(7, 7)), pixels, 10);
    EXPECT_EQ(point.toPixel({7, 7}), Vec2(100, 50));
}

TEST(ViewTransform, RefusesWhatCannotBeShown) {
    const Bounds2 pixels(Vec2(0, 0), Vec2(200, 100));
    const Bounds2 world(Vec2(0, 0), Vec2(1, 1));
    EXPECT_THROW(ViewTransform::fit(Bounds2(), pixels, 10), InputError);
    EXPECT_THROW(ViewTransform::fit(world, pixels, 50), InputError);
    EXPECT_THROW(ViewTransform::fit(Bounds2(Vec2(0, 0), nowhere), pixels, 10), InputError);
    EXPECT_THROW(ViewTransform(Vec2(0, 0), Vec2(0, 0), 0), InputError);
    EXPECT_THROW(ViewTransform(nowhere, Vec2(0, 0), 1), InputError);
}

}  // namespace
}  // namespace caustic
