#include "camera/film.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/check.h"

namespace caustic {

namespace {

constexpr std::string_view kindOfFile = "caustic film";
constexpr std::int64_t version = 1;

std::string sizeText(int width, int height) { return std::to_string(width) + " x " + std::to_string(height); }

// Colours are three numbers in a row, and so is a list of them.
void putColors(ByteWriter& to, const std::vector<Color>& colors) {
    to.putAll(std::span<const Real>(colors.front().data(), 3 * colors.size()));
}

void getColors(ByteReader& from, std::vector<Color>& colors) {
    from.getAll(std::span<Real>(colors.front().data(), 3 * colors.size()));
}

// The pixel in which a place of the film is; the nearest one when it lies outside or is no place at all.
int pixelAt(Real place, int count) {
    return place >= 1 ? static_cast<int>(std::min(place, static_cast<Real>(count - 1))) : 0;
}

}  // namespace

Film::Film(int width, int height) : width_(width), height_(height) {
    checkImageSize(width, height, "film");
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    sums_.assign(pixels, Color::Zero());
    counts_.assign(pixels, 0);
}

void Film::add(Pixel pixel, std::int64_t index, const Color& value) {
    if (!value.isFinite().all()) {
        countBad(pixel, index);
        return;
    }
    sums_[offset(pixel)] += value;
    ++counts_[offset(pixel)];
}

void Film::splat(const Vec2& place, const Color& value, const PixelFilter& filter) {
    if (!value.isFinite().all()) {
        countBad({pixelAt(place.x(), width_), pixelAt(place.y(), height_)}, 0);
        return;
    }
    if (splats_.empty()) splats_.assign(sums_.size(), Color::Zero());
    const Real reach = filter.radius();
    // Pixels whose centre is within reach.
    const int left = std::max(0, static_cast<int>(std::ceil(place.x() - 0.5 - reach)));
    const int right = std::min(width_ - 1, static_cast<int>(std::floor(place.x() - 0.5 + reach)));
    const int top = std::max(0, static_cast<int>(std::ceil(place.y() - 0.5 - reach)));
    const int bottom = std::min(height_ - 1, static_cast<int>(std::floor(place.y() - 0.5 + reach)));
    for (int y = top; y <= bottom; ++y) {
        for (int x = left; x <= right; ++x)
            splats_[offset({x, y})] += filter.density({place.x() - x - 0.5, place.y() - y - 0.5}) * value;
    }
}

void Film::merge(const Film& next) {
    checkArgument(next.width_ == width_ && next.height_ == height_, "film to merge",
                  sizeText(next.width_, next.height_),
                  "must have this film's " + sizeText(width_, height_) + " pixels");
    for (std::size_t i = 0; i < sums_.size(); ++i) {
        sums_[i] += next.sums_[i];
        counts_[i] += next.counts_[i];
    }
    if (!next.splats_.empty()) {
        if (splats_.empty()) splats_.assign(sums_.size(), Color::Zero());
        for (std::size_t i = 0; i < splats_.size(); ++i) splats_[i] += next.splats_[i];
    }
    splatPaths_ += next.splatPaths_;
    badSamples_ += next.badSamples_;
    if (!firstBad_) firstBad_ = next.firstBad_;
}

void Film::save(ByteWriter& to, std::string_view picture) const {
    to.putText(kindOfFile);
    to.put(version);
    to.putText(picture);
    to.put(std::int64_t{width_});
    to.put(std::int64_t{height_});
    putColors(to, sums_);
    to.putAll(std::span<const std::int64_t>(counts_));
    to.put(std::int64_t{splats_.empty() ? 0 : 1});
    if (!splats_.empty()) putColors(to, splats_);
    to.put(splatPaths_);
    to.put(badSamples_);
    const BadSample first = firstBad_.value_or(BadSample{{-1, -1}, 0});
    to.put(std::int64_t{first.pixel.x});
    to.put(std::int64_t{first.pixel.y});
    to.put(first.index);
    to.seal();
}

void Film::load(ByteReader& from, std::string_view picture) {
    from.expectText(kindOfFile, "kind");
    from.expect(version, "version");
    from.expectText(picture, "picture");
    const auto width = from.get<std::int64_t>();
    const auto height = from.get<std::int64_t>();
    if (width != width_ || height != height_)
        from.refuse(std::to_string(width) + " x " + std::to_string(height),
                    "is of another size, not of " + sizeText(width_, height_) + " pixels");
    Film film(width_, height_);
    getColors(from, film.sums_);
    from.getAll(std::span<std::int64_t>(film.counts_));
    if (from.get<std::int64_t>() != 0) {
        film.splats_.assign(film.sums_.size(), Color::Zero());
        getColors(from, film.splats_);
    }
    film.splatPaths_ = from.get<std::int64_t>();
    film.badSamples_ = from.get<std::int64_t>();
    const auto x = static_cast<int>(from.get<std::int64_t>());
    const auto y = static_cast<int>(from.get<std::int64_t>());
    const auto index = from.get<std::int64_t>();
    if (film.badSamples_ > 0) film.firstBad_ = BadSample{{x, y}, index};
    from.checkSeal();
    *this = std::move(film);
}

Color Film::value(Pixel pixel) const {
    const std::size_t i = offset(pixel);
    Color value = Color::Zero();
    if (counts_[i] > 0) value += sums_[i] / static_cast<Real>(counts_[i]);
    if (!splats_.empty() && splatPaths_ > 0) value += splats_[i] / static_cast<Real>(splatPaths_);
    return value;
}

Image Film::image() const {
    Image image(width_, height_);
    for (int y = 0; y < height_; ++y) {
        for (int x = 0; x < width_; ++x) image.set(x, y, value({x, y}));
    }
    return image;
}

void Film::countBad(Pixel pixel, std::int64_t index) {
    ++badSamples_;
    if (!firstBad_) firstBad_ = BadSample{pixel, index};
}

}  // namespace caustic
