// Column<T>: the only owner of hot memory.
//
// A column is a contiguous array of trivially copyable T, aligned to kAlignment and padded to a
// multiple of kColumnPad elements, so that vector loads may run past size() without harm. reset()
// leaves the memory untouched: the threads that work on it touch it first, which places its pages
// near them. ColumnBase is the type-erased view that checkpoints and the field catalog iterate.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <new>
#include <type_traits>
#include <utility>

#include "soa/base.h"

namespace quern {

enum class ElementType : std::uint8_t { kF64, kF32, kU64, kU32, kU16, kU8, kI64 };

template <class T>
constexpr ElementType element_type_of() {
  if constexpr (std::is_same_v<T, double>) return ElementType::kF64;
  if constexpr (std::is_same_v<T, float>) return ElementType::kF32;
  if constexpr (std::is_same_v<T, std::uint64_t>) return ElementType::kU64;
  if constexpr (std::is_same_v<T, std::uint32_t>) return ElementType::kU32;
  if constexpr (std::is_same_v<T, std::uint16_t>) return ElementType::kU16;
  if constexpr (std::is_same_v<T, std::int64_t>) return ElementType::kI64;
  return ElementType::kU8;  // plain records are saved as bytes
}

inline constexpr std::size_t kColumnPad = 64;

class ColumnBase {
 public:
  ColumnBase(ElementType type, std::size_t element_bytes)
      : type_(type), element_bytes_(element_bytes) {}
  ColumnBase(const ColumnBase&) = delete;
  ColumnBase& operator=(const ColumnBase&) = delete;
  ColumnBase(ColumnBase&& o) noexcept : type_(o.type_), element_bytes_(o.element_bytes_) {
    steal(o);
  }
  ColumnBase& operator=(ColumnBase&& o) noexcept {
    if (this != &o) {
      std::free(bytes_);
      steal(o);
    }
    return *this;
  }
  ~ColumnBase() { std::free(bytes_); }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  ElementType type() const { return type_; }
  std::size_t element_bytes() const { return element_bytes_; }
  std::size_t capacity_bytes() const { return capacity_ * element_bytes_; }
  void* raw() { return bytes_; }
  const void* raw() const { return bytes_; }

  void release() {
    std::free(bytes_);
    bytes_ = nullptr;
    size_ = capacity_ = 0;
  }
  // Makes room for n elements; contents are undefined (and untouched if memory had to grow).
  void reset(std::size_t n) {
    if (n + kColumnPad > capacity_ || bytes_ == nullptr) {
      std::free(bytes_);
      allocate(n);
    }
    size_ = n;
    clear_pad();
  }
  // Grows or shrinks, keeping the first min(n, size()) elements.
  void resize(std::size_t n) {
    if (n + kColumnPad > capacity_ || bytes_ == nullptr) {
      void* old = bytes_;
      const std::size_t keep = size_ * element_bytes_;
      allocate(n + n / 4);
      if (keep > 0) std::memcpy(bytes_, old, keep);
      std::free(old);
    }
    size_ = n;
    clear_pad();
  }

 protected:
  void allocate(std::size_t n) {
    capacity_ = (n + 2 * kColumnPad - 1) / kColumnPad * kColumnPad;
    const std::size_t bytes =
        (capacity_ * element_bytes_ + kAlignment - 1) / kAlignment * kAlignment;
    bytes_ = std::aligned_alloc(kAlignment, bytes);
    if (bytes_ == nullptr) throw std::bad_alloc();
  }
  // Lanes beyond the end are masked but loaded: they hold zeros, which raise nothing.
  void clear_pad() {
    std::memset(static_cast<char*>(bytes_) + size_ * element_bytes_, 0,
                std::min(capacity_ - size_, kColumnPad) * element_bytes_);
  }
  void steal(ColumnBase& o) {
    type_ = o.type_;
    element_bytes_ = o.element_bytes_;
    bytes_ = std::exchange(o.bytes_, nullptr);
    size_ = std::exchange(o.size_, 0);
    capacity_ = std::exchange(o.capacity_, 0);
  }

  ElementType type_;
  std::size_t element_bytes_;
  void* bytes_ = nullptr;
  std::size_t size_ = 0;
  std::size_t capacity_ = 0;
};

template <class T>
class Column : public ColumnBase {
  static_assert(std::is_trivially_copyable_v<T>, "a column holds plain data only");

 public:
  Column() : ColumnBase(element_type_of<T>(), sizeof(T)) {}
  T* data() { return static_cast<T*>(bytes_); }
  const T* data() const { return static_cast<const T*>(bytes_); }
  T& operator[](std::size_t i) {
    QUERN_ASSERT(i < capacity_);
    return data()[i];
  }
  const T& operator[](std::size_t i) const {
    QUERN_ASSERT(i < capacity_);
    return data()[i];
  }
  T* begin() { return data(); }
  T* end() { return data() + size_; }
  const T* begin() const { return data(); }
  const T* end() const { return data() + size_; }
  void fill(T value) {
    for (std::size_t i = 0; i < size_; ++i) data()[i] = value;
  }
};

}  // namespace quern
