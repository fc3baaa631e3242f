#include "math/sums.h"

#include "core/not_implemented.h"

namespace caustic {

double total(const std::vector<double>& values) {
    //! [ex-01.1]
    double sum = 0;
    for (const double value : values) sum += value;
    return sum;
    //! [ex-01.1]
}

double largest(const std::vector<double>& values) {
    //! [ex-01.2]
    double most = values.front();
    for (const double value : values) most = value > most ? value : most;
    return most;
    //! [ex-01.2]
}

double mean(const std::vector<double>& values) {
    //! [ex-01.3]
    return total(values) / static_cast<double>(values.size());
    //! [ex-01.3]
}

}  // namespace caustic
