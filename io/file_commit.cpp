// Plain POSIX calls, because the standard library has no fsync and its streams hide the reason of
// an error. Every call is checked: a disk may fill at write, at fsync and at close alike.
#include "io/file_commit.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <string_view>
#include <utility>

#include "soa/base.h"

namespace quern {
namespace {

[[noreturn]] void fail(const char* verb, const std::string& what, const std::string& path,
                       const char* operation, int reason) {
  throw SystemError(
      fmt::format("cannot {} {} '{}': {}: {}", verb, what, path, operation, std::strerror(reason)));
}

class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  Descriptor(Descriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  Descriptor& operator=(Descriptor&&) = delete;
  ~Descriptor() { close(); }
  int get() const { return fd_; }
  int close() { return fd_ < 0 ? 0 : ::close(std::exchange(fd_, -1)); }

 private:
  int fd_;
};

Descriptor create(const std::string& what, const std::string& path, const PendingFile& pending) {
  Descriptor file(
      ::open(pending.temporary().c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
  if (file.get() < 0) fail("write", what, path, "open", errno);
  return file;
}

Descriptor open_to_read(const std::string& what, const std::string& path) {
  Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.get() < 0) fail("read", what, path, "open", errno);
  return file;
}

void write_all(const Descriptor& file, std::string_view text, const std::string& what,
               const std::string& path) {
  while (!text.empty()) {
    const ssize_t n = ::write(file.get(), text.data(), text.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail("write", what, path, "write", errno);
    text.remove_prefix(static_cast<std::size_t>(n));
  }
}

// Into `part`, as much as there is; 0 at the end.
std::size_t read_some(const Descriptor& file, std::string& part, const std::string& what,
                      const std::string& path) {
  ssize_t n = -1;
  do {
    n = ::read(file.get(), part.data(), part.size());
  } while (n < 0 && errno == EINTR);
  if (n < 0) fail("read", what, path, "read", errno);
  return static_cast<std::size_t>(n);
}

// Gives a file a second name, so that the first is there at every moment until it is replaced. A
// file system without links has a moment without it.
void keep_as(const std::string& what, const std::string& path, const std::string& kept) {
  const std::string second = kept + ".tmp";
  ::unlink(second.c_str());  // of a program killed here
  if (::link(path.c_str(), second.c_str()) != 0) {
    rename_file(what, path, kept);
    return;
  }
  rename_file(what, second, kept);
  ::unlink(second.c_str());  // stays if `kept` was the same file already
}

}  // namespace

PendingFile::PendingFile(std::string what, std::string path)
    : what_(std::move(what)), path_(std::move(path)), temporary_(path_ + ".tmp") {}

PendingFile::~PendingFile() {
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void PendingFile::commit(Durability durability, const std::string& previous) {
  const bool sync = durability == Durability::kPowerCut;
  if (sync) sync_path(what_, temporary_);
  if (!previous.empty() && std::filesystem::exists(path_)) keep_as(what_, path_, previous);
  rename_file(what_, temporary_, path_);
  temporary_.clear();
  if (sync) sync_path(what_, folder_of(path_));
}

std::string folder_of(const std::string& path) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

void make_folder(const std::string& what, const std::string& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) fail("write", what, path, "make folder", error.value());
}

void rename_file(const std::string& what, const std::string& from, const std::string& to) {
  if (std::rename(from.c_str(), to.c_str()) != 0) fail("write", what, to, "rename", errno);
}

void sync_path(const std::string& what, const std::string& path) {
  Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.get() < 0) fail("write", what, path, "open to sync", errno);
  if (::fsync(file.get()) != 0) fail("write", what, path, "sync", errno);
}

void write_text_file(const std::string& what, const std::string& path, const std::string& text,
                     Durability durability) {
  PendingFile pending(what, path);
  Descriptor file = create(what, path, pending);
  write_all(file, text, what, path);
  if (file.close() != 0) fail("write", what, path, "close", errno);
  pending.commit(durability);
}

void copy_file(const std::string& what, const std::string& from, const std::string& to) {
  Descriptor source = open_to_read(what, from);
  PendingFile pending(what, to);
  Descriptor file = create(what, to, pending);
  std::string part(std::size_t{1} << 20, '\0');
  while (const std::size_t n = read_some(source, part, what, from)) {
    write_all(file, std::string_view(part).substr(0, n), what, to);
  }
  if (file.close() != 0) fail("write", what, to, "close", errno);
  pending.commit(Durability::kKill);
}

std::string read_text_file(const std::string& what, const std::string& path) {
  Descriptor file = open_to_read(what, path);
  std::string text, part(65536, '\0');
  while (const std::size_t n = read_some(file, part, what, path)) text.append(part, 0, n);
  return text;
}

}  // namespace quern
