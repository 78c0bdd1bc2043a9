#include "nacre/paint/normal_weights.h"

#include "nacre/paint/beckmann.h"

namespace nacre::paint {

NormalWeights::NormalWeights(double mu, double alpha, int nodes) {
    for_each_normal(mu, alpha, nodes, [&](double cosine, double weight) {
        const double x = cosine * FlakeTable::kFineIntervals;
        const int n = std::min(static_cast<int>(x), FlakeTable::kFineIntervals - 1);
        const double far = x - n, near = 1 - far;
        first_ = std::min(first_, n);
        last_ = std::max(last_, n + 1);
        linear_[n] += weight * near;
        linear_[n + 1] += weight * far;
        square_[n] += weight * near * near;
        square_[n + 1] += weight * far * far;
        product_[n] += weight * 2 * near * far;
    });
}

}  // namespace nacre::paint
