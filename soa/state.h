// StateVisitor: one enumeration of a run's state, used to write, to read and to describe it.
//
// World::visit() names every column and value once; a checkpoint writer, a checkpoint reader and
// `quern info` are visitors. A reader resizes columns to what it finds. Names use '/' for groups.
#pragma once

#include <cstring>
#include <vector>

#include "soa/column.h"

namespace quern {

class StateVisitor {
 public:
  virtual ~StateVisitor() = default;
  // `components` > 1: rows of that many elements (column.size() is a multiple of it).
  virtual void column(const char* name, const char* unit, ColumnBase& column,
                      std::size_t components) = 0;
  // A fixed-size block of numbers outside columns.
  virtual void values(const char* name, const char* unit, ElementType type, void* data,
                      std::size_t count) = 0;
  // A column that only some scenes have: not written while empty, and left as it is where the state
  // that is read lacks it.
  virtual void later_column(const char* name, const char* unit, ColumnBase& all,
                            std::size_t components) {
    if (!all.empty()) column(name, unit, all, components);
  }
  // One that states written by earlier versions lack: it then stays as it is.
  virtual void later_values(const char* name, const char* unit, ElementType type, void* data,
                            std::size_t count) {
    values(name, unit, type, data, count);
  }
};

// Rows of f64 numbers as a column and back.
template <class Row>
void visit_rows(StateVisitor& v, const char* name, const char* unit, std::vector<Row>& rows) {
  constexpr std::size_t kWidth = sizeof(Row) / sizeof(double);
  static_assert(sizeof(Row) == kWidth * sizeof(double), "numbers only");
  Column<double> numbers;
  numbers.reset(rows.size() * kWidth);
  if (!rows.empty()) std::memcpy(numbers.data(), rows.data(), rows.size() * sizeof(Row));
  v.column(name, unit, numbers, kWidth);
  rows.resize(numbers.size() / kWidth);
  if (!rows.empty()) {
    std::memcpy(static_cast<void*>(rows.data()), numbers.data(), rows.size() * sizeof(Row));
  }
}

}  // namespace quern
