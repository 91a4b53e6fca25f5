// `quern report DIR` and `quern compare DIR DIR ...`: pages of runs, of which one may be going on.
#pragma once

#include <string>
#include <vector>

namespace quern {

struct ReportCommand {
  std::vector<std::string> folders;
  std::string out;  // the page; empty: DIR/report.html or compare.html
};

int report_command(const ReportCommand& command);
int compare_command(const ReportCommand& command);

// The page at the end of a run; that it cannot be written is a warning, as the results are there.
void write_report_of_run(const std::string& folder);

}  // namespace quern
