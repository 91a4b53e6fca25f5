// A run of this program as a process of its own, in the folder of its results.
//
// Its output goes to FOLDER/log.txt, which the process keeps locked (flock) while it lives: two
// processes never work in one folder, whoever started them. It ends with its parent: if that is
// killed the system sends it SIGTERM, at which a run writes a checkpoint. It is a process group of
// its own, so that Ctrl-C reaches the parent alone, which passes it on once.
#pragma once

#include <sys/types.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace quern {

class ChildRun {
 public:
  // `quern ARGUMENTS`, which are asked for once the folder is locked; nothing if another process
  // works in it, or there are none. SystemError.
  using Arguments = std::function<std::vector<std::string>()>;
  static std::optional<ChildRun> start(const std::string& folder, const Arguments& arguments);

  struct End {
    int code = 0;     // of exit; -1: ended by a signal
    std::string how;  // "exit code 4", "signal 9"
  };
  std::optional<End> poll() const;  // nothing: it goes on
  void stop() const;                // asks it to write a checkpoint and end

 private:
  explicit ChildRun(pid_t process) : process_(process) {}
  pid_t process_;
};

// Whether a process works in the folder, on this machine or another.
bool is_locked(const std::string& folder);

// The last line that a process has written into its log, of a run its progress.
std::string last_line_of_log(const std::string& folder);

// What each of `copies` processes at a time makes of `work`: a number; 0 where one fails. The
// caller has no other threads.
std::vector<double> in_processes(int copies, const std::function<double()>& work);

}  // namespace quern
