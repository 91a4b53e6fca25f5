#include "soa/collisions.h"

#include <algorithm>

namespace quern {

void Collisions::visit_liner(StateVisitor& v) {
  constexpr std::size_t kWidth = 2 * kLinerBins;
  Column<double> numbers;
  numbers.reset(liner.size() * kWidth);
  for (std::size_t k = 0; k < liner.size(); ++k) {
    std::copy_n(liner[k].contact_time.begin(), kLinerBins, numbers.begin() + k * kWidth);
    std::copy_n(liner[k].hit_dissipation.begin(), kLinerBins,
                numbers.begin() + k * kWidth + kLinerBins);
  }
  v.column("collisions/liner", "s, J", numbers, kWidth);
  liner.assign(numbers.size() / kWidth, make_liner_histogram());
  for (std::size_t k = 0; k < liner.size(); ++k) {
    std::copy_n(numbers.begin() + k * kWidth, kLinerBins, liner[k].contact_time.begin());
    std::copy_n(numbers.begin() + k * kWidth + kLinerBins, kLinerBins,
                liner[k].hit_dissipation.begin());
  }
}

void Collisions::visit(StateVisitor& v) {
  v.later_values("collisions/recording", "1", ElementType::kU64, &recording, 1);
  if (recording != Recording::kOn) return;
  v.values("collisions/steps", "1", ElementType::kF64, &steps, 1);
  v.values("collisions/start", "J", ElementType::kF64, &start, sizeof(start) / sizeof(double));
  visit_rows(v, "collisions/kinds", "J", kinds);
  visit_rows(v, "collisions/start_elastic", "J", start_elastic);
  visit_rows(v, "collisions/spectra", "1, J", spectra);
  visit_liner(v);
}

}  // namespace quern
