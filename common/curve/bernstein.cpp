#include "curve/bernstein.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/check.h"

namespace caustic {

namespace {

constexpr Real unitRoundoff = std::numeric_limits<Real>::epsilon() / 2;
constexpr Real narrowest = 0x1p-51;  // of a piece that is still halved: two ulp of numbers near 1

int signOf(Real value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

// p on [from, to], each coefficient known to within error.
struct Piece {
    BernsteinPolynomial p;
    Real from;
    Real to;
    Real error;
};

// The sign of a coefficient; 0 when its error leaves it open.
int certainSign(Real coefficient, Real error) { return std::abs(coefficient) > error ? signOf(coefficient) : 0; }

// The sign that all coefficients share, and so all values; 0 when there is none.
int commonSign(const Piece& piece) {
    const int first = certainSign(piece.p.coefficients().front(), piece.error);
    for (const Real c : piece.p.coefficients()) {
        if (certainSign(c, piece.error) != first) return 0;
    }
    return first;
}

// Whether there is exactly one root whatever the errors are: signs s ... s -s ... -s with at most one open in between.
bool crossesOnce(const Piece& piece) {
    const int first = certainSign(piece.p.coefficients().front(), piece.error);
    const int last = certainSign(piece.p.coefficients().back(), piece.error);
    if (first * last >= 0) return false;
    int open = 0;
    bool turned = false;
    for (const Real c : piece.p.coefficients()) {
        const int sign = certainSign(c, piece.error);
        if (sign == 0) ++open;
        if (sign == last) turned = true;
        if (turned && sign != last) return false;
    }
    return open <= 1;
}

// The root of p in (0, 1) where p(0) and p(1) have opposite signs and p crosses once: Newton's method, kept inside a
// bracket. Ends when the bracket or the step is below `resolution`.
Real refinedRoot(const BernsteinPolynomial& p, Real resolution) {
    const BernsteinPolynomial slope = p.derivative();
    const int atStart = signOf(p.coefficients().front());
    Real low = 0;
    Real high = 1;
    const Real first = p.coefficients().front();
    const Real last = p.coefficients().back();
    Real t = first / (first - last);
    for (int step = 0; step < 200 && high - low > resolution; ++step) {
        if (!(t > low && t < high)) t = low + (high - low) / 2;
        const Real value = p.evaluate(t);
        if (value == 0) return t;
        (signOf(value) == atStart ? low : high) = t;
        const Real next = t - value / slope.evaluate(t);
        if (std::abs(next - t) <= resolution) return std::clamp(next, low, high);
        // Newton creeps where p is flat: every third step halves the bracket.
        t = step % 3 == 2 ? low + (high - low) / 2 : next;
    }
    return low + (high - low) / 2;
}

class RootFinder {
public:
    RootFinder(const BernsteinPolynomial& p, Real coefficientError) : p_(p), coefficientError_(coefficientError) {}

    BernsteinRoots find() {
        const Piece all{p_, 0, 1, coefficientError_};
        if (all.p.magnitude() <= all.error) return {true, {}};
        search(all);
        closeCluster(0);
        return std::move(result_);
    }

private:
    // Goes through [0, 1] from left to right; sign_ is the sign of p where it was certain last.
    void search(const Piece& piece) {
        if (const int sign = commonSign(piece)) return closeCluster(sign);
        if (crossesOnce(piece)) return addSimpleRoot(piece);
        if (piece.p.magnitude() <= 2 * piece.error || piece.to - piece.from <= narrowest) return growCluster(piece);
        const Real middle = (piece.from + piece.to) / 2;
        const Real error = piece.error + piece.p.degree() * unitRoundoff * piece.p.magnitude();
        const auto [left, right] = piece.p.split(Real(0.5));
        search({left, piece.from, middle, error});
        search({right, middle, piece.to, error});
    }

    void growCluster(const Piece& piece) {
        if (!cluster_) cluster_ = BernsteinRoot{0, piece.from, piece.to, piece.from == 0 ? 0 : sign_, 0};
        cluster_->high = piece.to;
    }

    void closeCluster(int signAfter) {
        sign_ = signAfter;
        if (!cluster_) return;
        cluster_->after = signAfter;
        cluster_->t = clusterCentre(cluster_->low, cluster_->high);
        result_.roots.push_back(*cluster_);
        cluster_.reset();
    }

    void addSimpleRoot(const Piece& piece) {
        const int before = signOf(piece.p.coefficients().front());
        const int after = signOf(piece.p.coefficients().back());
        closeCluster(before);
        const Real width = piece.to - piece.from;
        const Real t = refinedRoot(piece.p, unitRoundoff / width);

        // A bracket at whose ends the sign is certain again.
        const Real error = piece.error + (4 * piece.p.degree() + 4) * unitRoundoff * piece.p.magnitude();
        Real reach = unitRoundoff / width;
        Real low = t;
        Real high = t;
        while (low > 0 && certainSign(piece.p.evaluate(low), error) != before) {
            low = std::max(Real(0), t - reach);
            reach *= 2;
        }
        reach = unitRoundoff / width;
        while (high < 1 && certainSign(piece.p.evaluate(high), error) != after) {
            high = std::min(Real(1), t + reach);
            reach *= 2;
        }
        const auto place = [&](Real local) { return piece.from + local * width; };
        result_.roots.push_back({place(t), std::max(piece.from, place(low) - 2 * unitRoundoff),
                                 std::min(piece.to, place(high) + 2 * unitRoundoff), before, after});
        sign_ = after;
    }

    // Where m roots meet, the (m-1)th derivative crosses zero once.
    Real clusterCentre(Real low, Real high) const {
        BernsteinPolynomial q = p_.restricted(low, high);
        Real error = coefficientError_ + 8 * p_.degree() * unitRoundoff * q.magnitude();
        for (; q.degree() > 0; q = q.derivative(), error *= 2 * (q.degree() + 1)) {
            if (crossesOnce({q, 0, 1, error})) return low + (high - low) * refinedRoot(q, unitRoundoff);
        }
        const Real middle = low + (high - low) / 2;
        return std::min({middle, low, high},
                        [&](Real a, Real b) { return std::abs(p_.evaluate(a)) < std::abs(p_.evaluate(b)); });
    }

    BernsteinPolynomial p_;
    Real coefficientError_;
    BernsteinRoots result_;
    std::optional<BernsteinRoot> cluster_;  // being grown
    int sign_ = 0;
};

}  // namespace

BernsteinPolynomial::BernsteinPolynomial(std::vector<Real> coefficients) : coefficients_(std::move(coefficients)) {
    checkArgument(!coefficients_.empty(), "Bernstein coefficients", "0", "a polynomial needs at least one");
    for (const Real coefficient : coefficients_) checkFinite(coefficient, "Bernstein coefficient");
}

Real BernsteinPolynomial::magnitude() const {
    Real largest = 0;
    for (const Real coefficient : coefficients_) largest = std::max(largest, std::abs(coefficient));
    return largest;
}

BernsteinPolynomial BernsteinPolynomial::derivative() const {
    if (degree() == 0) return BernsteinPolynomial({0});
    std::vector<Real> differences;
    for (std::size_t i = 0; i + 1 < coefficients_.size(); ++i) {
        differences.push_back(degree() * (coefficients_[i + 1] - coefficients_[i]));
    }
    return BernsteinPolynomial(std::move(differences));
}

std::pair<BernsteinPolynomial, BernsteinPolynomial> BernsteinPolynomial::split(Real t) const {
    std::vector<Real> left;
    std::vector<Real> right = coefficients_;
    for (std::size_t last = right.size(); last > 0; --last) {
        left.push_back(right.front());
        for (std::size_t i = 0; i + 1 < last; ++i) right[i] = (1 - t) * right[i] + t * right[i + 1];
    }
    return {BernsteinPolynomial(std::move(left)), BernsteinPolynomial(std::move(right))};
}

BernsteinPolynomial BernsteinPolynomial::restricted(Real from, Real to) const {
    if (to == 0) return BernsteinPolynomial(std::vector<Real>(coefficients_.size(), coefficients_.front()));
    return split(to).first.split(from / to).second;
}

BernsteinRoots findRoots(const BernsteinPolynomial& p, Real coefficientError) {
    checkArgument(coefficientError >= 0, "coefficient error", formatReal(coefficientError), "must be at least 0");
    return RootFinder(p, coefficientError).find();
}

}  // namespace caustic
