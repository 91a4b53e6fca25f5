#include "apps/quern/report.h"

#include <fmt/format.h>

#include <filesystem>

#include "io/html_report.h"
#include "io/log.h"

namespace quern {

namespace {

namespace fs = std::filesystem;

void print_page(const std::string& path) {
  std::error_code unknown;
  const auto bytes = static_cast<double>(fs::file_size(path, unknown));
  log_info(fmt::format("report       {} ({:.1f} MB)", path, bytes / 1e6));
}

std::string page_of(const std::string& folder) {
  return (fs::path(folder) / "report.html").string();
}

}  // namespace

int report_command(const ReportCommand& command) {
  const std::string& folder = command.folders.front();
  const std::string path = command.out.empty() ? page_of(folder) : command.out;
  write_html_report(path, {{folder, ""}}, {});
  print_page(path);
  return 0;
}

int compare_command(const ReportCommand& command) {
  std::vector<ReportRun> runs;
  for (const std::string& folder : command.folders) runs.push_back({folder, ""});
  const std::string path = command.out.empty() ? "compare.html" : command.out;
  write_html_report(path, runs, {});
  print_page(path);
  return 0;
}

void write_report_of_run(const std::string& folder) {
  try {
    const std::string path = page_of(folder);
    write_html_report(path, {{folder, "", true}}, {});
    print_page(path);
  } catch (const std::exception& error) {
    log_warn(fmt::format("no report page: {}", error.what()));
  }
}

}  // namespace quern
