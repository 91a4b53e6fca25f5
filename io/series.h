// SeriesWriter: OUT/run.h5, what a run reports over time, its tables and its provenance.
//
//   /series/NAME       one extendible f64 dataset a quantity, attributes unit and doc
//   /provenance        text attributes: version, commit, machine ...
//   /NAME              texts (the scene) and tables (groups of datasets with units)
//
// After each row the file is flushed, so a killed run leaves a file that h5py opens, at most one
// row short. Kills between two writes may leave datasets of unequal length: opening cuts to the
// shortest. A kill within a write can tear the file: keep() puts a copy beside it,
// OUT/run.previous.h5, and that is what kAppend goes on from.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "io/hdf5_file.h"
#include "soa/output.h"

namespace quern {

enum class SeriesMode { kNew, kAppend };

// A column of a table: `rows` x `components` of `type`, kept alive by the caller.
struct TableColumn {
  Quantity quantity;
  ArrayLayout layout;
  const void* data = nullptr;
};

template <class T>
TableColumn table_column(Quantity quantity, std::span<const T> values, std::size_t components = 1) {
  QUERN_CHECK(components > 0 && values.size() % components == 0);
  return {std::move(quantity),
          {element_type_of<T>(), values.size() / components, components},
          values.data()};
}

class SeriesWriter {
 public:
  // One of the quantities is "time" (s). kAppend continues an existing file, whose quantities must
  // be the same, or makes a new one if there is none.
  SeriesWriter(const std::string& path, const std::vector<Quantity>& quantities, SeriesMode mode);

  void keep() const;                         // with each checkpoint, before it is written
  void append(std::span<const double> row);  // one value a quantity, in their order
  void truncate_after(double time);          // drops rows with a later time
  std::size_t rows() const { return rows_; }
  std::vector<double> read(const std::string& name) const;  // a quantity's recorded values

  void text(const std::string& name, const std::string& text);
  void provenance(const std::string& name, const std::string& value);
  void write_table(const std::string& name, std::span<const TableColumn> columns);
  bool has(const std::string& name) const { return file_.exists(name); }
  // A table's column, "TABLE/COLUMN", of the layout it was written with.
  void read_column(const std::string& name, const ArrayLayout& layout, void* data) const {
    file_.read(name, layout, data);
  }
  void close();  // reports errors of the last writes; the destructor does not

 private:
  void create(const std::vector<Quantity>& quantities);
  void open(const std::vector<Quantity>& quantities);
  void cut(std::size_t rows);

  std::string path_;
  Hdf5File file_;
  std::vector<std::string> names_;
  std::size_t time_ = 0;  // index of "time"
  std::size_t rows_ = 0;
};

}  // namespace quern
