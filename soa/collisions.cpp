#include "soa/collisions.h"

#include <cstring>

namespace quern {

namespace {

// Plain rows of f64 as a column and back.
template <class Row>
void visit_rows(StateVisitor& v, const char* name, std::vector<Row>& rows) {
  constexpr std::size_t kWidth = sizeof(Row) / sizeof(double);
  Column<double> numbers;
  numbers.reset(rows.size() * kWidth);
  if (!rows.empty()) std::memcpy(numbers.data(), rows.data(), rows.size() * sizeof(Row));
  v.column(name, "1, J", numbers, kWidth);
  rows.resize(numbers.size() / kWidth);
  if (!rows.empty())
    std::memcpy(static_cast<void*>(rows.data()), numbers.data(), rows.size() * sizeof(Row));
}

}  // namespace

void Collisions::visit(StateVisitor& v) {
  v.later_values("collisions/recording", "1", ElementType::kU64, &recording, 1);
  if (recording != Recording::kOn) return;
  v.values("collisions/steps", "1", ElementType::kF64, &steps, 1);
  v.values("collisions/start", "J", ElementType::kF64, &start, sizeof(start) / sizeof(double));
  visit_rows(v, "collisions/kinds", kinds);
  visit_rows(v, "collisions/start_elastic", start_elastic);
  visit_rows(v, "collisions/spectra", spectra);
}

}  // namespace quern
