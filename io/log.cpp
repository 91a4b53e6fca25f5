// The only code outside apps/ that prints. One static remembers whether a progress line stands open
// on the terminal, so that a message can clear it first.
#include "io/log.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <mutex>
#include <vector>

namespace quern {
namespace {

std::mutex print_mutex;
std::FILE* open_line = nullptr;  // the terminal on which a progress line stands, without newline

void clear_line() {
  if (open_line == nullptr) return;
  std::fputs("\r\033[K", open_line);
  std::fflush(open_line);
  open_line = nullptr;
}

void print(std::FILE* out, std::string_view prefix, std::string_view text) {
  const std::lock_guard lock(print_mutex);
  clear_line();
  fmt::print(out, "{}{}\n", prefix, text);
  std::fflush(out);
}

double steady_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::size_t terminal_width(std::FILE* out) {
  winsize size{};
  if (ioctl(fileno(out), TIOCGWINSZ, &size) != 0 || size.ws_col < 2) return 0;
  return size.ws_col - 1u;  // a full line would wrap, and '\r' could not reach its beginning
}

// 1.9e6 as 1.9 and 'M'. Decided on what three digits show, so that 999.6 is 1.00 k.
struct Scaled {
  double value;
  std::string suffix;
};

Scaled scaled(double value) {
  constexpr std::array<const char*, 4> kSuffixes = {"", "k", "M", "G"};
  std::size_t scale = 0;
  while (scale + 1 < kSuffixes.size() && std::abs(value) >= 999.5) {
    value /= 1000;
    ++scale;
  }
  return {value, kSuffixes[scale]};
}

// "6.1e7": the exponent without padding.
std::string short_exponent(double value, int decimals) {
  if (value == 0 || !std::isfinite(value)) return fmt::format("{}", value);
  const std::string text = fmt::format("{:.{}e}", value, decimals);
  const std::size_t e = text.find('e');
  return text.substr(0, e + 1) + std::to_string(std::stoi(text.substr(e + 1)));
}

struct Part {
  int rank;  // the highest goes first where there is no room
  std::string text;
};

std::string join(const std::vector<Part>& parts) {
  std::string line;
  for (const Part& part : parts) line += (line.empty() ? " " : " | ") + part.text;
  return line;
}

std::string describe_time(const ProgressLine& line) {
  if (line.settling) return fmt::format("settling t {:.3f} s", line.time);
  std::string text = fmt::format("t {:.3f} s", line.time);
  if (!std::isnan(line.until) && line.until > 0)
    text += fmt::format(" {:.1f}%", 100 * line.time / line.until);
  if (!std::isnan(line.revolutions)) text += fmt::format(" rev {:.2f}", line.revolutions);
  return text;
}

std::vector<Part> progress_parts(const ProgressLine& line) {
  std::vector<Part> parts = {{0, describe_time(line)}};
  const auto add = [&](double value, int rank, auto&& format) {
    if (!std::isnan(value)) parts.push_back({rank, format()});
  };
  add(line.rate, 4, [&] { return short_exponent(line.rate, 1) + " particle-steps/s"; });
  add(line.contacts, 5, [&] { return "contacts " + format_count(line.contacts); });
  add(line.max_overlap, 3,
      [&] { return fmt::format("max overlap {:.1f}% r", 100 * line.max_overlap); });
  add(line.power, 2, [&] { return "power " + format_power(line.power); });
  add(line.energy_error, 6, [&] { return "energy error " + short_exponent(line.energy_error, 0); });
  std::string clock = "elapsed " + format_clock(line.elapsed);
  if (!std::isnan(line.eta)) clock += " ETA " + format_clock(line.eta);
  parts.push_back({1, clock});
  if (line.checkpoint_age >= 0) {
    parts.push_back({7, fmt::format("checkpoint {} ago", format_age(line.checkpoint_age))});
  }
  return parts;
}

}  // namespace

void log_info(std::string_view text) { print(stdout, "", text); }
void log_warn(std::string_view text) { print(stderr, "warning: ", text); }
void log_error(std::string_view text) { print(stderr, "error: ", text); }

std::string format_power(double watts) {
  const Scaled power = scaled(watts);
  const double size = std::abs(power.value);
  const int decimals = size >= 99.95 ? 0 : size >= 9.995 ? 1 : 2;
  return fmt::format("{:.{}f} {}W", power.value, decimals, power.suffix);
}

std::string format_count(double count) {
  const Scaled number = scaled(count);
  const int decimals = number.suffix.empty() || number.value >= 99.95 ? 0 : 1;
  return fmt::format("{:.{}f}{}", number.value, decimals, number.suffix);
}

std::string format_clock(double seconds) {
  if (!std::isfinite(seconds) || seconds > 1e9) return "-";
  const long total = std::lround(std::max(seconds, 0.0));
  const long hours = total / 3600, minutes = total / 60 % 60, rest = total % 60;
  return hours > 0 ? fmt::format("{}:{:02}:{:02}", hours, minutes, rest)
                   : fmt::format("{}:{:02}", minutes, rest);
}

std::string format_age(double seconds) {
  if (seconds < 60) return fmt::format("{:.0f}s", std::floor(seconds));
  if (seconds < 3600) return fmt::format("{:.0f}m", std::floor(seconds / 60));
  return fmt::format("{:.0f}h", std::floor(seconds / 3600));
}

std::string format_progress(const ProgressLine& line, std::size_t width) {
  std::vector<Part> parts = progress_parts(line);
  std::string text = join(parts);
  while (width > 0 && text.size() > width && parts.size() > 1) {
    parts.erase(std::max_element(parts.begin(), parts.end(),
                                 [](const Part& a, const Part& b) { return a.rank < b.rank; }));
    text = join(parts);
  }
  return width > 0 ? text.substr(0, width) : text;
}

Progress::Progress(std::FILE* out, double period)
    : out_(out), terminal_(isatty(fileno(out)) == 1), period_(period) {
  if (period_ <= 0) period_ = terminal_ ? 0.2 : 5.0;
}

Progress::~Progress() {
  const std::lock_guard lock(print_mutex);
  if (open_line != out_) return;
  std::fputc('\n', out_);
  std::fflush(out_);
  open_line = nullptr;
}

bool Progress::due() const { return steady_seconds() >= next_; }

void Progress::show(const ProgressLine& line) {
  if (due()) print(line, false);
}

void Progress::finish(const ProgressLine& line) { print(line, true); }

void Progress::print(const ProgressLine& line, bool last) {
  const std::lock_guard lock(print_mutex);
  if (terminal_) {
    fmt::print(out_, "\r{}\033[K{}", format_progress(line, terminal_width(out_)), last ? "\n" : "");
    open_line = last ? nullptr : out_;
  } else {
    fmt::print(out_, "{}\n", format_progress(line));
  }
  std::fflush(out_);
  next_ = steady_seconds() + period_;
}

ProgressTable::ProgressTable(std::FILE* out) : out_(out), terminal_(isatty(fileno(out)) == 1) {}

bool ProgressTable::due() const { return steady_seconds() >= next_; }

// The cursor is left where the table begins.
void ProgressTable::show(const std::string& heading, const std::vector<std::string>& lines) {
  const std::lock_guard lock(print_mutex);
  if (terminal_) {
    const std::size_t width = terminal_width(out_);
    fmt::print(out_, "\r\033[J{}\n", heading.substr(0, width));
    for (const std::string& line : lines) fmt::print(out_, "{}\n", line.substr(0, width));
    fmt::print(out_, "\033[{}A", lines.size() + 1);
  } else {
    fmt::print(out_, "{}\n", heading);
  }
  std::fflush(out_);
  shown_ = true;
  next_ = steady_seconds() + (terminal_ ? 0.5 : 10);
}

void ProgressTable::clear() {
  const std::lock_guard lock(print_mutex);
  if (!shown_ || !terminal_) return;
  fmt::print(out_, "\r\033[J");
  std::fflush(out_);
  shown_ = false;
}

}  // namespace quern
