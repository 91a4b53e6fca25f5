#include "apps/quern/child_run.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>

#include "io/file_commit.h"
#include "soa/base.h"

namespace quern {

namespace {

std::string log_of(const std::string& folder) { return folder + "/log.txt"; }

// In the child, which may call little but what the system does.
void end_with(pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent) _exit(1);  // it has ended before
}

[[noreturn]] void become(char* const* arguments, int log, pid_t parent) {
  setpgid(0, 0);
  end_with(parent);
  fcntl(log, F_SETFD, 0);  // kept, and with it the lock
  dup2(log, STDOUT_FILENO);
  dup2(log, STDERR_FILENO);
  execv("/proc/self/exe", arguments);
  _exit(127);
}

double read_number(int from) {
  double value = 0;
  return read(from, &value, sizeof(value)) == static_cast<ssize_t>(sizeof(value)) ? value : 0;
}

}  // namespace

std::optional<ChildRun> ChildRun::start(const std::string& folder, const Arguments& arguments) {
  make_folder("results", folder);
  const int log = open(log_of(folder).c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  if (log < 0)
    throw SystemError(fmt::format("cannot write log '{}': {}", log_of(folder), strerror(errno)));
  if (flock(log, LOCK_EX | LOCK_NB) != 0) {
    close(log);
    return std::nullopt;
  }
  std::vector<std::string> texts = arguments();
  if (texts.empty()) {
    close(log);
    return std::nullopt;
  }
  texts.insert(texts.begin(), "quern");
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  const pid_t parent = getpid(), process = fork();
  if (process == 0) become(pointers.data(), log, parent);
  const int error = errno;
  close(log);
  if (process < 0) throw SystemError(fmt::format("cannot start a run: {}", strerror(error)));
  return ChildRun(process);
}

std::optional<ChildRun::End> ChildRun::poll() const {
  int status = 0;
  const pid_t ended = waitpid(process_, &status, WNOHANG);
  if (ended == 0 || (ended < 0 && errno == EINTR)) return std::nullopt;
  if (ended < 0) return End{-1, strerror(errno)};
  if (WIFEXITED(status))
    return End{WEXITSTATUS(status), fmt::format("exit code {}", WEXITSTATUS(status))};
  return End{-1, fmt::format("signal {}", WTERMSIG(status))};
}

// SIGINT, because a second SIGTERM, after one from the system, would end it at once.
void ChildRun::stop() const { kill(process_, SIGINT); }

bool is_locked(const std::string& folder) {
  const int log = open(log_of(folder).c_str(), O_RDONLY | O_CLOEXEC);
  if (log < 0) return false;
  const bool locked = flock(log, LOCK_SH | LOCK_NB) != 0;
  close(log);
  return locked;
}

std::string last_line_of_log(const std::string& folder) {
  constexpr std::streamoff kTail = 2048;
  std::ifstream file(log_of(folder), std::ios::binary | std::ios::ate);
  if (!file) return "";
  const std::streamoff size = file.tellg(), begin = size > kTail ? size - kTail : 0;
  std::string text(static_cast<std::size_t>(size - begin), '\0');
  file.seekg(begin);
  file.read(text.data(), size - begin);
  while (!text.empty() && text.back() == '\n') text.pop_back();
  text.erase(0, text.find_last_of('\n') + 1);
  return text;
}

std::vector<double> in_processes(int copies, const std::function<double()>& work) {
  std::vector<std::pair<pid_t, int>> children;
  for (int k = 0; k < copies; ++k) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) break;
    const pid_t parent = getpid(), process = fork();
    if (process == 0) {
      end_with(parent);
      double value = 0;
      try {
        value = work();
      } catch (...) {  // what is wrong with the scene its run will tell
        value = 0;
      }
      const bool told =
          write(ends[1], &value, sizeof(value)) == static_cast<ssize_t>(sizeof(value));
      _exit(told ? 0 : 1);
    }
    close(ends[1]);
    if (process > 0) children.emplace_back(process, ends[0]);
    if (process < 0) close(ends[0]);
  }
  std::vector<double> values;
  for (const auto& [process, from] : children) {
    values.push_back(read_number(from));
    close(from);
    waitpid(process, nullptr, 0);
  }
  return values;
}

}  // namespace quern
