// CRC-32, as zlib has it: every flip of up to 32 neighbouring bits shows.
#include "io/seal.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <vector>

#include "soa/base.h"

namespace quern {
namespace {

constexpr std::string_view kMark = "quernsum";
constexpr std::size_t kSealBytes = 16;  // the mark and the checksum in 8 bytes

// Of the next `size` bytes.
std::uint64_t checksum(std::istream& file, std::uint64_t size) {
  std::vector<char> part(std::size_t{1} << 20);
  uLong sum = crc32(0, nullptr, 0);
  while (size > 0 && file) {
    file.read(part.data(),
              static_cast<std::streamsize>(std::min<std::uint64_t>(size, part.size())));
    const auto n = static_cast<std::uint64_t>(file.gcount());
    sum = crc32(sum, reinterpret_cast<const Bytef*>(part.data()), static_cast<uInt>(n));
    size -= n;
  }
  return sum;
}

std::uint64_t size_of(std::istream& file) {
  file.seekg(0, std::ios::end);
  const std::streamoff size = file.tellg();
  file.seekg(0);
  return size < 0 ? 0 : static_cast<std::uint64_t>(size);
}

[[noreturn]] void fail(const char* verb, const std::string& what, const std::string& path,
                       const std::string& reason) {
  throw SystemError(fmt::format("cannot {} {} '{}': {}", verb, what, path, reason));
}

}  // namespace

void seal_file(const std::string& what, const std::string& path) {
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
  if (!file) fail("write", what, path, fmt::format("open to seal: {}", std::strerror(errno)));
  const std::uint64_t sum = checksum(file, size_of(file));
  file.clear();
  file.seekp(0, std::ios::end);
  file.write(kMark.data(), kMark.size());
  file.write(reinterpret_cast<const char*>(&sum), sizeof sum);
  if (!file.flush()) fail("write", what, path, fmt::format("seal: {}", std::strerror(errno)));
}

void check_seal(const std::string& what, const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) fail("read", what, path, fmt::format("open: {}", std::strerror(errno)));
  const std::uint64_t size = size_of(file);
  std::uint64_t sum = 0;
  std::array<char, kSealBytes> seal{};
  if (size > kSealBytes) {
    sum = checksum(file, size - kSealBytes);
    file.read(seal.data(), kSealBytes);
  }
  std::uint64_t sealed = 0;
  std::memcpy(&sealed, seal.data() + kMark.size(), sizeof sealed);
  if (!file || std::string_view(seal.data(), kMark.size()) != kMark) {
    fail("read", what, path, "it has no seal: it was cut off, or is of another version");
  }
  if (sealed != sum) fail("read", what, path, "it is damaged (wrong checksum)");
}

}  // namespace quern
