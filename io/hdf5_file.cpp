// HDF5's C API behind Hdf5File; the only code that includes it.
//
// Format choices, all tried with 1.10.8:
// - A file is created with superblock 2 and then raised to V110. A V110 file has superblock 3 and
//   marks itself "open for write": after a kill nobody can open it, and h5py cannot while we run.
// - No file locks, so that a running simulation's series can be read.
// - In a growing file every object begins a page, and a chunk of a series fits in one: fewer kills
//   in a write tear it, but some do. It is opened anew after so many arrays: 6 kB each in memory.
// - After a failed write (disk full) the library's clean-up at exit crashes: it is then left out.
#include "io/hdf5_file.h"

#include <fmt/format.h>
#include <hdf5.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cstdlib>
#include <limits>
#include <utility>

namespace quern {
namespace {

static_assert(sizeof(hid_t) == sizeof(std::int64_t), "Hdf5File::Id must hold HDF5's handles");

constexpr hsize_t kPage = 4096;
constexpr hsize_t kSeriesChunkRows = kPage / sizeof(double) - 1;  // and 4 bytes of checksum
constexpr std::size_t kChunkBytes = std::size_t{1} << 20;         // fits HDF5's chunk cache
constexpr std::size_t kWrittenInMemory = 100;  // arrays; a flush looks through them

using CloseFunction = herr_t (*)(hid_t);

// Closes a handle when it goes; a negative handle means the call that made it failed.
class Handle {
 public:
  Handle(hid_t id, CloseFunction close) : id_(id), close_(close) {}
  Handle(Handle&& other) noexcept : id_(other.release()), close_(other.close_) {}
  Handle& operator=(Handle&&) = delete;
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  hid_t get() const { return id_; }
  hid_t release() { return std::exchange(id_, -1); }
  bool bad() const { return id_ < 0; }

 private:
  hid_t id_;
  CloseFunction close_;
};

// In the order of ElementType.
struct TypeRow {
  ElementType type;
  const char* name;
  std::size_t bytes;
};
constexpr std::array<TypeRow, 7> kTypes = {{{ElementType::kF64, "f64", 8},
                                            {ElementType::kF32, "f32", 4},
                                            {ElementType::kU64, "u64", 8},
                                            {ElementType::kU32, "u32", 4},
                                            {ElementType::kU16, "u16", 2},
                                            {ElementType::kU8, "u8", 1},
                                            {ElementType::kI64, "i64", 8}}};
const TypeRow& row_of(ElementType type) { return kTypes.at(static_cast<std::size_t>(type)); }

static_assert(std::ranges::is_sorted(kTypes, {}, &TypeRow::type), "in the order of ElementType");
// In the file and in memory alike: on little-endian machines nothing is converted.
hid_t file_type(ElementType type) {
  const std::array<hid_t, kTypes.size()> in_order = {H5T_IEEE_F64LE, H5T_IEEE_F32LE, H5T_STD_U64LE,
                                                     H5T_STD_U32LE,  H5T_STD_U16LE,  H5T_STD_U8LE,
                                                     H5T_STD_I64LE};
  return in_order.at(static_cast<std::size_t>(type));
}
static_assert(std::endian::native == std::endian::little, "files are copied as they lie in memory");

Handle text_type(const std::string& text) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  const bool ascii = std::all_of(text.begin(), text.end(),
                                 [](char c) { return static_cast<unsigned char>(c) < 128; });
  H5Tset_size(type.get(), std::max<std::size_t>(text.size(), 1));
  H5Tset_strpad(type.get(), H5T_STR_NULLPAD);
  H5Tset_cset(type.get(), ascii ? H5T_CSET_ASCII : H5T_CSET_UTF8);
  return type;
}

std::string without_padding(std::string text) {
  text.erase(text.find_last_not_of('\0') + 1);
  return text;
}

// Reason of the innermost error of the last call, in the operating system's words where there are
// any. To be asked before another call, of which closing a handle is one.
std::string last_reason() {
  std::string reason;
  const auto take = [](unsigned, const H5E_error2_t* error, void* out) -> herr_t {
    auto& text = *static_cast<std::string*>(out);
    if (text.empty() && error->desc != nullptr) text = error->desc;
    return 0;
  };
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, take, &reason);
  constexpr std::string_view kSystem = "error message = '";
  if (const std::size_t begin = reason.find(kSystem); begin != std::string::npos) {
    const std::size_t from = begin + kSystem.size();
    return reason.substr(from, reason.find('\'', from) - from);
  }
  return reason.empty() ? "unknown reason" : reason;
}

bool creates(FileMode mode) {
  return mode == FileMode::kCreate || mode == FileMode::kCreateGrowing;
}

Handle file_access(FileMode mode) {
  Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  const H5F_libver_t low = creates(mode) ? H5F_LIBVER_V18 : H5F_LIBVER_V110;
  H5Pset_libver_bounds(access.get(), low, H5F_LIBVER_V110);
  H5Pset_file_locking(access.get(), false, true);
  H5Pset_fclose_degree(access.get(), H5F_CLOSE_STRONG);
  if (mode == FileMode::kCreateGrowing || mode == FileMode::kUpdate) {
    H5Pset_alignment(access.get(), 1, kPage);
  }
  return access;
}

std::atomic<bool> write_failed = false;

// Before the first use of the library: no printing, and a clean-up at exit that spares it after a
// failed write.
void prepare_library() {
  static const bool once = [] {
    H5dont_atexit();
    std::atexit([] {
      if (!write_failed) H5close();
    });
    return H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr) >= 0;
  }();
  QUERN_CHECK(once);
}

// Asked before room is made for what a file claims to hold: nothing in it is packed.
bool fits(hid_t file, hsize_t rows, hsize_t row_bytes) {
  hsize_t size = 0;
  return H5Fget_filesize(file, &size) >= 0 && (row_bytes == 0 || rows <= size / row_bytes);
}

Handle dataset_creation() {
  Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_obj_track_times(creation.get(), false);
  return creation;
}

}  // namespace

std::size_t element_bytes(ElementType type) { return row_of(type).bytes; }

std::size_t ArrayLayout::bytes() const { return rows * components * element_bytes(type); }

std::string describe(const ArrayLayout& layout) {
  return layout.components == 1 ? fmt::format("{} of {}", layout.rows, row_of(layout.type).name)
                                : fmt::format("{} x {} of {}", layout.rows, layout.components,
                                              row_of(layout.type).name);
}

Hdf5File::Hdf5File(std::string what, std::string path, FileMode mode)
    : what_(std::move(what)), path_(std::move(path)), mode_(mode) {
  prepare_library();
  file_ = open_file();
  if (creates(mode_) && H5Fset_libver_bounds(file_, H5F_LIBVER_V110, H5F_LIBVER_V110) < 0) {
    fail("set format");
  }
}

Hdf5File::Id Hdf5File::open_file() const {
  const Handle access = file_access(mode_);
  const Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
  H5Pset_obj_track_times(creation.get(), false);
  const unsigned flags = mode_ == FileMode::kRead ? H5F_ACC_RDONLY : H5F_ACC_RDWR;
  const hid_t file = creates(mode_)
                         ? H5Fcreate(path_.c_str(), H5F_ACC_TRUNC, creation.get(), access.get())
                         : H5Fopen(path_.c_str(), flags, access.get());
  if (file < 0) fail("open", last_reason());  // here, as closing a handle forgets the reason
  return file;
}

Hdf5File::~Hdf5File() {
  for (const Series& series : series_) H5Dclose(series.id);
  if (file_ >= 0) H5Fclose(file_);
}

void Hdf5File::close() {
  for (Series& series : series_) {
    if (H5Dclose(series.id) < 0) fail("close dataset '" + series.name + "'");
  }
  series_.clear();
  if (file_ >= 0 && H5Fclose(std::exchange(file_, -1)) < 0) fail("close");
}

void Hdf5File::flush() {
  if (written_ > kWrittenInMemory) return reopen();
  if (H5Fflush(file_, H5F_SCOPE_LOCAL) < 0) fail("flush");
}

void Hdf5File::reopen() {
  const std::vector<Series> open = series_;
  close();
  mode_ = FileMode::kUpdate;
  file_ = open_file();
  for (const Series& one : open) series_.push_back({open_dataset(one.name), one.name, one.rows});
  written_ = 0;
}

void Hdf5File::fail(const std::string& operation, std::string reason) const {
  if (reason.empty()) {
    write_failed = mode_ != FileMode::kRead || write_failed;
    reason = last_reason();
  }
  throw SystemError(fmt::format("cannot {} {} '{}': {}: {}",
                                mode_ == FileMode::kRead ? "read" : "write", what_, path_,
                                operation, reason));
}

bool Hdf5File::exists(const std::string& name) const {
  if (name == "/") return true;
  for (std::size_t end = name.find('/', 1);; end = name.find('/', end + 1)) {
    const htri_t found = H5Lexists(file_, name.substr(0, end).c_str(), H5P_DEFAULT);
    if (found < 0) fail("look up '" + name + "'");
    if (found == 0 || end == std::string::npos) return found > 0;
  }
}

void Hdf5File::remove(const std::string& name) {
  if (H5Ldelete(file_, name.c_str(), H5P_DEFAULT) < 0) fail("remove '" + name + "'");
}

// HDF5 can make the groups on the way itself, but then with the time of day in them.
void Hdf5File::make_parents(const std::string& name) {
  const std::size_t end = name.rfind('/');
  if (end == std::string::npos || end == 0) return;
  const std::string parent = name.substr(0, end);
  if (!exists(parent)) make_group(parent);
}

void Hdf5File::make_group(const std::string& name) {
  make_parents(name);
  const Handle creation(H5Pcreate(H5P_GROUP_CREATE), H5Pclose);
  H5Pset_obj_track_times(creation.get(), false);
  const Handle group(H5Gcreate2(file_, name.c_str(), H5P_DEFAULT, creation.get(), H5P_DEFAULT),
                     H5Gclose);
  if (group.bad()) fail("make group '" + name + "'");
}

std::vector<std::string> Hdf5File::datasets(const std::string& group) const {
  std::vector<std::string> names;
  const auto take = [](hid_t, const char* name, const H5O_info_t* info, void* out) -> herr_t {
    if (info->type != H5O_TYPE_DATASET) return 0;
    static_cast<std::vector<std::string>*>(out)->emplace_back(name);
    return 0;
  };
  if (H5Ovisit_by_name2(file_, group.c_str(), H5_INDEX_NAME, H5_ITER_INC, take, &names,
                        H5O_INFO_BASIC, H5P_DEFAULT) < 0) {
    fail("list '" + group + "'");
  }
  std::sort(names.begin(), names.end());
  return names;
}

void Hdf5File::write_array(const std::string& name, Id type, const ArrayLayout& layout,
                           const void* data) {
  const int rank = layout.components == 1 ? 1 : 2;
  const std::array<hsize_t, 2> size = {layout.rows, layout.components};
  const Handle space(H5Screate_simple(rank, size.data(), nullptr), H5Sclose);
  const Handle creation = dataset_creation();
  if (layout.rows > 0) {
    const std::size_t row_bytes = layout.components * H5Tget_size(type);
    const std::array<hsize_t, 2> chunk = {
        std::clamp<std::size_t>(kChunkBytes / row_bytes, 1, layout.rows), layout.components};
    H5Pset_chunk(creation.get(), rank, chunk.data());
    H5Pset_fletcher32(creation.get());
    H5Pset_fill_time(creation.get(), H5D_FILL_TIME_NEVER);
  }
  make_parents(name);
  ++written_;
  const Handle dataset(
      H5Dcreate2(file_, name.c_str(), type, space.get(), H5P_DEFAULT, creation.get(), H5P_DEFAULT),
      H5Dclose);
  if (dataset.bad()) fail("make dataset '" + name + "'");
  if (layout.rows > 0 && H5Dwrite(dataset.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data) < 0) {
    fail("write dataset '" + name + "'");
  }
}

void Hdf5File::write(const std::string& name, const ArrayLayout& layout, const void* data) {
  QUERN_CHECK(layout.components > 0);
  write_array(name, file_type(layout.type), layout, data);
}

Hdf5File::Id Hdf5File::open_dataset(const std::string& name) const {
  if (!exists(name)) fail("open dataset '" + name + "'", "missing");
  const hid_t dataset = H5Dopen2(file_, name.c_str(), H5P_DEFAULT);
  if (dataset < 0) fail("open dataset '" + name + "'");
  return dataset;
}

bool Hdf5File::is_text(const std::string& name) const {
  const Handle dataset(open_dataset(name), H5Dclose);
  return H5Tget_class(Handle(H5Dget_type(dataset.get()), H5Tclose).get()) == H5T_STRING;
}

ArrayLayout Hdf5File::layout(const std::string& name) const {
  const Handle dataset(open_dataset(name), H5Dclose);
  const Handle type(H5Dget_type(dataset.get()), H5Tclose);
  const Handle space(H5Dget_space(dataset.get()), H5Sclose);
  if (type.bad() || space.bad()) fail("describe dataset '" + name + "'");
  const auto row = std::find_if(kTypes.begin(), kTypes.end(), [&](const TypeRow& candidate) {
    return H5Tequal(type.get(), file_type(candidate.type)) > 0;
  });
  if (row == kTypes.end()) fail("describe dataset '" + name + "'", "unexpected element type");
  const int rank = H5Sget_simple_extent_ndims(space.get());
  if (rank < 1 || rank > 2) fail("describe dataset '" + name + "'", "unexpected rank");
  std::array<hsize_t, 2> size = {0, 1};
  H5Sget_simple_extent_dims(space.get(), size.data(), nullptr);
  if (!fits(file_, size[0], size[1]) || !fits(file_, size[0] * size[1], row->bytes)) {
    fail("describe dataset '" + name + "'", "it is larger than the file");
  }
  return {row->type, size[0], size[1]};
}

void Hdf5File::read(const std::string& name, const ArrayLayout& expected, void* data) const {
  const ArrayLayout found = layout(name);
  if (!(found == expected)) {
    fail("read dataset '" + name + "'",
         fmt::format("holds {}, expected {}", describe(found), describe(expected)));
  }
  if (found.rows == 0) return;
  const Handle dataset(open_dataset(name), H5Dclose);
  if (H5Dread(dataset.get(), file_type(found.type), H5S_ALL, H5S_ALL, H5P_DEFAULT, data) < 0) {
    fail("read dataset '" + name + "'");
  }
}

void Hdf5File::write_text(const std::string& name, const std::string& text) {
  const Handle type = text_type(text);
  const std::string padded = text.empty() ? std::string(1, '\0') : text;
  write_array(name, type.get(), {ElementType::kU8, 1, 1}, padded.data());
}

std::string Hdf5File::read_text(const std::string& name) const {
  const Handle dataset(open_dataset(name), H5Dclose);
  const Handle type(H5Dget_type(dataset.get()), H5Tclose);
  const Handle space(H5Dget_space(dataset.get()), H5Sclose);
  if (type.bad() || H5Tget_class(type.get()) != H5T_STRING || H5Tis_variable_str(type.get()) != 0 ||
      H5Sget_simple_extent_npoints(space.get()) != 1 || !fits(file_, 1, H5Tget_size(type.get()))) {
    fail("read text '" + name + "'", "is not one fixed-length string");
  }
  std::string text(H5Tget_size(type.get()), '\0');
  if (H5Dread(dataset.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()) < 0) {
    fail("read text '" + name + "'");
  }
  return without_padding(std::move(text));
}

void Hdf5File::write_attribute(const std::string& object, const std::string& name, Id type,
                               Id space, const void* value) {
  if (has_attribute(object, name) &&
      H5Adelete_by_name(file_, object.c_str(), name.c_str(), H5P_DEFAULT) < 0) {
    fail(fmt::format("replace attribute '{}' of '{}'", name, object));
  }
  const Handle attribute(H5Acreate_by_name(file_, object.c_str(), name.c_str(), type, space,
                                           H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                         H5Aclose);
  if (attribute.bad() || H5Awrite(attribute.get(), type, value) < 0) {
    fail(fmt::format("write attribute '{}' of '{}'", name, object));
  }
}

void Hdf5File::write_scalar(const std::string& object, const std::string& name, Id type,
                            const void* value) {
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  write_attribute(object, name, type, space.get(), value);
}

void Hdf5File::set_attribute(const std::string& object, const std::string& name,
                             const std::string& text) {
  const Handle type = text_type(text);
  write_scalar(object, name, type.get(), text.c_str());
}

void Hdf5File::set_attribute(const std::string& object, const std::string& name, double value) {
  write_scalar(object, name, file_type(ElementType::kF64), &value);
}

void Hdf5File::set_attribute(const std::string& object, const std::string& name,
                             std::uint64_t value) {
  write_scalar(object, name, file_type(ElementType::kU64), &value);
}

void Hdf5File::set_attribute(const std::string& object, const std::string& name,
                             std::span<const std::int64_t> values) {
  const hsize_t count = values.size();
  const Handle space(H5Screate_simple(1, &count, nullptr), H5Sclose);
  write_attribute(object, name, file_type(ElementType::kI64), space.get(), values.data());
}

bool Hdf5File::has_attribute(const std::string& object, const std::string& name) const {
  const htri_t found = H5Aexists_by_name(file_, object.c_str(), name.c_str(), H5P_DEFAULT);
  if (found < 0) fail(fmt::format("look up attribute '{}' of '{}'", name, object));
  return found > 0;
}

Hdf5File::Id Hdf5File::open_attribute(const std::string& object, const std::string& name) const {
  const std::string operation = fmt::format("read attribute '{}' of '{}'", name, object);
  if (!exists(object) || !has_attribute(object, name)) fail(operation, "missing");
  const hid_t attribute =
      H5Aopen_by_name(file_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
  if (attribute < 0) fail(operation);
  return attribute;
}

std::string Hdf5File::text_attribute(const std::string& object, const std::string& name) const {
  const Handle attribute(open_attribute(object, name), H5Aclose);
  const Handle type(H5Aget_type(attribute.get()), H5Tclose);
  const std::string operation = fmt::format("read attribute '{}' of '{}'", name, object);
  if (type.bad() || H5Tget_class(type.get()) != H5T_STRING || H5Tis_variable_str(type.get()) != 0) {
    fail(operation, "is no fixed-length text");
  }
  std::string text(H5Aget_storage_size(attribute.get()), '\0');
  if (H5Aread(attribute.get(), type.get(), text.data()) < 0) fail(operation);
  return without_padding(std::move(text));
}

void Hdf5File::read_attribute(const std::string& object, const std::string& name, ElementType type,
                              void* value) const {
  const Handle attribute(open_attribute(object, name), H5Aclose);
  const Handle found(H5Aget_type(attribute.get()), H5Tclose);
  if (found.bad() || H5Tequal(found.get(), file_type(type)) <= 0 ||
      H5Aget_storage_size(attribute.get()) != element_bytes(type) ||
      H5Aread(attribute.get(), file_type(type), value) < 0) {
    fail(fmt::format("read attribute '{}' of '{}'", name, object),
         fmt::format("is not one {}", row_of(type).name));
  }
}

std::size_t Hdf5File::create_series(const std::string& name) {
  const hsize_t rows = 0, most = H5S_UNLIMITED;
  const Handle space(H5Screate_simple(1, &rows, &most), H5Sclose);
  const Handle creation = dataset_creation();
  H5Pset_chunk(creation.get(), 1, &kSeriesChunkRows);
  const double unwritten = std::numeric_limits<double>::quiet_NaN();
  H5Pset_fill_value(creation.get(), file_type(ElementType::kF64), &unwritten);
  H5Pset_fletcher32(creation.get());
  make_parents(name);
  const hid_t dataset = H5Dcreate2(file_, name.c_str(), file_type(ElementType::kF64), space.get(),
                                   H5P_DEFAULT, creation.get(), H5P_DEFAULT);
  if (dataset < 0) fail("make dataset '" + name + "'");
  series_.push_back({dataset, name, 0});
  return series_.size() - 1;
}

std::size_t Hdf5File::open_series(const std::string& name) {
  const ArrayLayout found = layout(name);
  if (found.type != ElementType::kF64 || found.components != 1) {
    fail("open series '" + name + "'", "holds " + describe(found));
  }
  series_.push_back({open_dataset(name), name, found.rows});
  return series_.size() - 1;
}

void Hdf5File::resize_series(std::size_t handle, std::size_t rows) {
  Series& series = series_.at(handle);
  const hsize_t size = rows;
  if (H5Dset_extent(series.id, &size) < 0) fail("resize dataset '" + series.name + "'");
  series.rows = rows;
}

void Hdf5File::append_series(std::size_t handle, double value) {
  const hsize_t one = 1, row = series_.at(handle).rows;
  resize_series(handle, row + 1);
  const Series& series = series_[handle];
  const Handle memory(H5Screate_simple(1, &one, nullptr), H5Sclose);
  const Handle space(H5Dget_space(series.id), H5Sclose);
  if (H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, &row, nullptr, &one, nullptr) < 0 ||
      H5Dwrite(series.id, file_type(ElementType::kF64), memory.get(), space.get(), H5P_DEFAULT,
               &value) < 0) {
    fail("append to dataset '" + series.name + "'");
  }
}

std::vector<double> Hdf5File::read_series(std::size_t handle) const {
  const Series& series = series_.at(handle);
  std::vector<double> values(series.rows);
  if (!values.empty() && H5Dread(series.id, file_type(ElementType::kF64), H5S_ALL, H5S_ALL,
                                 H5P_DEFAULT, values.data()) < 0) {
    fail("read dataset '" + series.name + "'");
  }
  return values;
}

}  // namespace quern
