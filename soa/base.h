// Basic types, constants and checks that every folder uses.
//
// Set-up code works with Eigen's vectors; hot code works with columns of scalars. All quantities are
// SI. QUERN_CHECK is for our own invariants in cold code and is always on; QUERN_ASSERT is for hot
// code and exists in debug builds only. Both throw InvariantError, which only apps/ turns into text.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace quern {

using Index = std::uint32_t;
using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using Quat = Eigen::Quaterniond;

inline constexpr double kPi = 3.14159265358979323846;
inline constexpr Index kNoIndex = 0xffffffffu;

// Everything allocated for vectors starts at a multiple of this and is padded to it (bytes).
inline constexpr std::size_t kAlignment = 128;

struct InvariantError : std::logic_error {
  using std::logic_error::logic_error;
};

// The user's request cannot be met (a fill that does not fit, a file that cannot be read ...).
// The message is complete and is shown as it is.
struct UserError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// The system failed an operation on a path (disk full, unreadable HDF5). Exit code 3.
struct SystemError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

[[noreturn]] inline void fail_check(const char* what, const char* file, int line) {
  throw InvariantError(std::string(file) + ":" + std::to_string(line) + ": broken invariant: " +
                       what);
}

}  // namespace quern

#define QUERN_CHECK(condition) \
  ((condition) ? (void)0 : ::quern::fail_check(#condition, __FILE__, __LINE__))
#ifdef NDEBUG
#define QUERN_ASSERT(condition) ((void)0)
#else
#define QUERN_ASSERT(condition) QUERN_CHECK(condition)
#endif
