#include "math/products.h"

#include <cstddef>

#include "core/not_implemented.h"
#include "math/sums.h"

namespace caustic {

double weightedTotal(std::vector<double> values, const std::vector<double>& weights) {
    //! [ex-02.1]
    for (std::size_t i = 0; i < values.size(); ++i) values[i] *= weights[i];
    return total(values);
    //! [ex-02.1]
}

}  // namespace caustic
