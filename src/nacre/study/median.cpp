#include "nacre/study/median.h"

#include <algorithm>

#include "nacre/core/error.h"

namespace nacre::study {

double median(std::vector<double> values) {
    if (values.empty()) throw DomainError("there is no median of no values");
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

}  // namespace nacre::study
