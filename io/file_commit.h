// Files that appear whole or not at all: write a temporary name, sync, rename, sync the folder.
//
// Used by checkpoints, frames and the JSON files, so that a kill or a power cut at any moment
// leaves either the old contents or the new ones. Errors are SystemError: "cannot write WHAT
// 'PATH': ...".
#pragma once

#include <string>

namespace quern {

enum class Durability {
  kKill,      // survives a kill of the program
  kPowerCut,  // also synced to the disk
};

// A file on its way: written as temporary() by whoever, then commit() gives it its name. Without
// commit (an error, a full disk) the temporary file is deleted.
class PendingFile {
 public:
  PendingFile(std::string what, std::string path);
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;
  ~PendingFile();

  const std::string& temporary() const { return temporary_; }
  // Syncs if asked, keeps an existing file as `previous` if that is not empty, renames. The path
  // names a whole file at every moment.
  void commit(Durability durability, const std::string& previous = {});

 private:
  std::string what_, path_, temporary_;
};

void rename_file(const std::string& what, const std::string& from, const std::string& to);
void sync_path(const std::string& what, const std::string& path);  // a file or a folder
void make_folder(const std::string& what, const std::string& path);
std::string folder_of(const std::string& path);

void write_text_file(const std::string& what, const std::string& path, const std::string& text,
                     Durability durability);
// The copy has its name once it is whole.
void copy_file(const std::string& what, const std::string& from, const std::string& to);
std::string read_text_file(const std::string& what, const std::string& path);

}  // namespace quern
