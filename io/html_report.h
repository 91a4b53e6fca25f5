// The report page: one HTML file that shows one run, or several side by side.
//
// Everything is inside the file: the program of the page (io/report, bundled), its style, the
// tables of run.h5 and summary.json under their own names, and the frames of the charge. Nothing is
// fetched, and the page's own policy forbids it. All texts of a run travel as data, never as HTML.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/report_view.h"

namespace quern {

struct ReportRun {
  std::string folder;
  std::string name;     // how the page calls it; empty: the folder's own name
  bool closed = false;  // its run.h5, by who wrote it
};

// A page of another kind, of the same program and style: `kind` names the value `data` (JSON) in
// what the page carries, and the program shows what it finds there.
struct PageContents {
  std::string title, kind, data;
  std::vector<std::string> blobs;  // packed, for data that refer to them
  std::vector<ReportRun> pictures =
      {};  // runs of which the charge in motion is to be seen, no more
};
std::string html_page(const PageContents& contents);

struct ReportOptions {
  std::string title;  // empty: the title of the scene, or the names of the runs
  ViewBudget view;    // of the whole page
};

// SystemError where a folder or its run.h5 is missing or cannot be read. Of a run that goes on, or
// was killed, what was flushed is shown, and the page says so.
std::string html_report(const std::vector<ReportRun>& runs, const ReportOptions& options);

// The same to a file, which appears by renaming.
void write_html_report(const std::string& path, const std::vector<ReportRun>& runs,
                       const ReportOptions& options);

}  // namespace quern
