// Hdf5File: an HDF5 file with errors as exceptions; its .cpp is the only code that includes HDF5.
//
// Everything is written so that damage shows: format V110 (checksums on all metadata) and
// fletcher32 on every dataset with rows, because flipped bits in plain HDF5 data are read back
// silently. No time stamps are stored: the same contents are the same bytes. Arrays are `rows` or
// `rows` x `components` of one ElementType, little-endian, so reading back is a plain copy, bit for
// bit. Names may contain '/': groups are made on the way. Any failure is a SystemError
//   cannot write checkpoint 'OUT/checkpoint.h5': write dataset 'state/x': No space left on device
// The library is serial: use it from one thread at a time.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "soa/column.h"

namespace quern {

// An array in memory or in a file, apart from its place.
struct ArrayLayout {
  ElementType type = ElementType::kF64;
  std::size_t rows = 0;
  std::size_t components = 1;  // 1: rank 1; otherwise rank 2, rows x components

  std::size_t bytes() const;
  bool operator==(const ArrayLayout&) const = default;
};

std::size_t element_bytes(ElementType type);
std::string describe(const ArrayLayout& layout);  // "1000 x 3 of f64"

enum class FileMode {
  kCreate,         // for a file written at once; an existing one is replaced
  kCreateGrowing,  // for a file that stays open, to be whole if the program is killed
  kRead,
  kUpdate,  // an existing growing file is read and written
};

class Hdf5File {
 public:
  // `what` names the file's role in messages: "checkpoint", "frame" ...
  Hdf5File(std::string what, std::string path, FileMode mode);
  Hdf5File(const Hdf5File&) = delete;
  Hdf5File& operator=(const Hdf5File&) = delete;
  ~Hdf5File();  // closes without reporting; call close() where a lost write matters

  void close();
  void flush();  // of a growing file; what the library remembers of it stays below some megabytes
  const std::string& path() const { return path_; }

  bool exists(const std::string& name) const;
  void remove(const std::string& name);
  void make_group(const std::string& name);
  std::vector<std::string> datasets(const std::string& group) const;  // below it, sorted

  void write(const std::string& name, const ArrayLayout& layout, const void* data);
  bool is_text(const std::string& name) const;
  ArrayLayout layout(const std::string& name) const;
  // Refuses a dataset whose layout differs from `expected`.
  void read(const std::string& name, const ArrayLayout& expected, void* data) const;

  // Text of any length as one row of a fixed-length UTF-8 string.
  void write_text(const std::string& name, const std::string& text);
  std::string read_text(const std::string& name) const;

  // Attributes of a dataset or group ("/" is the root); an existing one is replaced.
  void set_attribute(const std::string& object, const std::string& name, const std::string& text);
  void set_attribute(const std::string& object, const std::string& name, double value);
  void set_attribute(const std::string& object, const std::string& name, std::uint64_t value);
  void set_attribute(const std::string& object, const std::string& name,
                     std::span<const std::int64_t> values);
  bool has_attribute(const std::string& object, const std::string& name) const;
  std::string text_attribute(const std::string& object, const std::string& name) const;
  double f64_attribute(const std::string& object, const std::string& name) const {
    return scalar<double>(object, name);
  }
  std::uint64_t u64_attribute(const std::string& object, const std::string& name) const {
    return scalar<std::uint64_t>(object, name);
  }

  // Extendible rank-1 f64 datasets; they stay open until close(). The handle is an index.
  // A kill may leave a row whose extent was written and its chunk was not: it reads as NaN.
  std::size_t create_series(const std::string& name);
  std::size_t open_series(const std::string& name);
  std::size_t series_rows(std::size_t handle) const { return series_[handle].rows; }
  void resize_series(std::size_t handle, std::size_t rows);
  void append_series(std::size_t handle, double value);
  std::vector<double> read_series(std::size_t handle) const;

  // Throws SystemError for this file; `reason` empty: the library's own.
  [[noreturn]] void fail(const std::string& operation, std::string reason = {}) const;

 private:
  using Id = std::int64_t;  // HDF5's hid_t
  struct Series {
    Id id;
    std::string name;
    std::size_t rows;
  };
  Id open_file() const;
  void reopen();
  void make_parents(const std::string& name);
  Id open_dataset(const std::string& name) const;
  Id open_attribute(const std::string& object, const std::string& name) const;
  void read_attribute(const std::string& object, const std::string& name, ElementType type,
                      void* value) const;
  template <class T>
  T scalar(const std::string& object, const std::string& name) const {
    T value = 0;
    read_attribute(object, name, element_type_of<T>(), &value);
    return value;
  }
  void write_attribute(const std::string& object, const std::string& name, Id type, Id space,
                       const void* value);
  void write_scalar(const std::string& object, const std::string& name, Id type, const void* value);
  void write_array(const std::string& name, Id type, const ArrayLayout& layout, const void* data);

  std::string what_, path_;
  FileMode mode_;
  Id file_ = -1;
  std::vector<Series> series_;
  std::size_t written_ = 0;  // arrays since the file was opened
};

}  // namespace quern
