// All printing of the program: messages, and the line of progress.
//
// Results and information go to standard output; warnings, errors and progress to standard error.
// On a terminal the progress line is redrawn in place ('\r') and messages first clear it; else one
// line is printed every few seconds, so that a log file stays short. What is not known (NaN, or a
// negative age) is left out; on a narrow terminal the less important parts are.
#pragma once

#include <cstdio>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace quern {

void log_info(std::string_view text);   // stdout, as it is
void log_warn(std::string_view text);   // stderr, "warning: ..."
void log_error(std::string_view text);  // stderr, "error: ..."

struct ProgressLine {
  static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  double time = 0;                // s
  double until = kUnknown;        // s; percent is time / until
  double revolutions = kUnknown;  // of the mill
  double rate = kUnknown;         // particle-steps per s of wall clock
  double contacts = kUnknown;
  double max_overlap = kUnknown;   // relative to the smaller radius
  double power = kUnknown;         // W
  double energy_error = kUnknown;  // relative
  double elapsed = 0;              // s of wall clock
  double eta = kUnknown;           // s of wall clock still to go
  double checkpoint_age = -1;      // s of wall clock; negative: none yet
  bool settling = false;
};

// `width`: most characters allowed, 0 for any.
std::string format_progress(const ProgressLine& line, std::size_t width = 0);

std::string format_power(double watts);    // "812 kW"
std::string format_count(double count);    // "1.9M"
std::string format_clock(double seconds);  // "1:01:40", "22:13"
std::string format_age(double seconds);    // "3m"

class Progress {
 public:
  // `period` in s; 0: 0.2 s on a terminal, 5 s elsewhere.
  explicit Progress(std::FILE* out = stderr, double period = 0);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  bool due() const;                       // whether show() would print; asking is cheap
  void show(const ProgressLine& line);    // prints if due
  void finish(const ProgressLine& line);  // prints in any case and ends the line

 private:
  void print(const ProgressLine& line, bool last);

  std::FILE* out_;
  bool terminal_;
  double period_;
  double next_ = 0;  // s, steady clock
};

// Progress of several runs: a heading and a line for each. On a terminal the lines are redrawn in
// place; else the heading alone is printed now and then.
class ProgressTable {
 public:
  explicit ProgressTable(std::FILE* out = stderr);

  bool due() const;
  void show(const std::string& heading, const std::vector<std::string>& lines);
  void clear();  // makes room for a message

 private:
  std::FILE* out_;
  bool terminal_;
  bool shown_ = false;
  double next_ = 0;  // s, steady clock
};

}  // namespace quern
