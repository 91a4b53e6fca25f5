#include "io/html_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "io/file_commit.h"
#include "io/packed.h"
#include "io/report_assets.h"
#include "io/report_tables.h"
#include "io/scene_reader.h"
#include "soa/facets.h"
#include "soa/groups.h"

namespace quern {

namespace {

namespace fs = std::filesystem;

constexpr double kDegree = kPi / 180;

std::string schedule_json(const Schedule& schedule) {
  std::string json;
  for (const Schedule::Point& p : schedule.points) {
    json += fmt::format("{}[{:.9g},{:.9g}]", json.empty() ? "" : ",", p.time, p.value);
  }
  return "[" + json + "]";
}

const char* ends_name(EndKind ends) {
  switch (ends) {
    case EndKind::kWalls:
      return "walls";
    case EndKind::kPeriodic:
      return "periodic";
    default:
      return "open";
  }
}

std::string mill_json(const Scene& scene) {
  if (!scene.mill) return "null";
  const MillSpec& mill = *scene.mill;
  std::string profile, lifters = "null";
  for (const Eigen::Vector2d& corner : mill_profile(mill)) {
    profile += fmt::format("{}[{:.6g},{:.6g}]", profile.empty() ? "" : ",", corner[0], corner[1]);
  }
  if (mill.lifters) {
    lifters = fmt::format(
        "{{\"count\":{},\"height\":{:.6g},\"face_angle_deg\":{:.6g},\"top_width\":{:.6g}}}",
        mill.lifters->count, mill.lifters->height, mill.lifters->face_angle / kDegree,
        mill.lifters->top_width);
  }
  return fmt::format(
      "{{\"diameter\":{:.9g},\"length\":{:.9g},\"ends\":\"{}\",\"rotation\":{},\"lifters\":{},"
      "\"profile\":[{}]}}",
      mill.diameter, mill.length, ends_name(mill.ends), schedule_json(mill.rotation), lifters,
      profile);
}

std::string range_json(const char* shape, double from, double to) {
  return fmt::format("{{\"shape\":\"{}\",\"from\":{},\"to\":{}}}", shape, json_number(from),
                     json_number(to));
}

const char* shape_name(ShapeKind shape) {
  return shape == ShapeKind::kSphere ? "sphere" : "polyhedron";
}

// Species with their size classes, numbered as in soa/size_classes.h.
std::string species_json(const Scene& scene) {
  std::string json;
  for (const ParticleSpec& species : scene.particles) {
    std::string classes;
    for (const SizeClass& size : species.sizes) {
      classes += (classes.empty() ? "" : ",") +
                 range_json(shape_name(shape_of(species, size)), size.from, size.to);
    }
    if (species.sizes.empty()) {
      const double d = species.diameter.value_or(std::nan(""));
      classes = range_json(shape_name(species.shape), d, d);
    }
    json += fmt::format("{}{{\"name\":{},\"group\":{},\"material\":{},\"classes\":[{}]}}",
                        json.empty() ? "" : ",", json_string(species.name),
                        json_string(group_of(species)), json_string(species.material), classes);
  }
  return "[" + json + "]";
}

double record_from(const RunSpec& run) { return run.record_from.value_or(0); }

// What the page needs of the scene besides its text; "null" where this version cannot read it.
std::string scene_json(const SceneResult& read) {
  if (!read.errors.empty()) return "null";
  const Scene& scene = read.scene;
  return fmt::format(
      "{{\"title\":{},\"record_from\":{:.9g},\"record_from_revolution\":{},\"gravity\":{:.6g},"
      "\"time_step\":{},\"mill\":{},\"species\":{}}}",
      json_string(scene.run.title), record_from(scene.run),
      json_number(scene.run.record_from_revolution.value_or(std::nan(""))),
      scene.run.gravity.norm(), json_number(scene.run.time_step.value_or(std::nan(""))),
      mill_json(scene), species_json(scene));
}

std::string list_json(const std::vector<std::string>& texts) {
  std::string json;
  for (const std::string& text : texts) json += (json.empty() ? "" : ",") + json_string(text);
  return "[" + json + "]";
}

std::string name_of(const ReportRun& run) {
  if (!run.name.empty()) return run.name;
  const fs::path folder = fs::absolute(run.folder).lexically_normal();
  return (folder.has_filename() ? folder.filename() : folder.parent_path().filename()).string();
}

struct Page {
  std::string runs;  // JSON of each run, comma between
  std::vector<std::string> blobs;
  std::string title;  // of the first scene
};

enum class RunParts { kAll, kPicture };

void add_run(const ReportRun& run, const ViewBudget& budget, RunParts parts, Page& page) {
  RunTables tables = read_run_tables(run.folder, run.closed);
  if (parts == RunParts::kPicture) tables.arrays = tables.texts = "{}";
  const SceneResult scene =
      parse_scene(tables.scene, "scene", run.folder, {}, StartFile::kReadBefore);
  RunView view;
  view.json = "null";
  if (scene.errors.empty()) {
    view = read_run_view(run.folder, scene.scene, budget, page.blobs.size(), run.closed);
    if (page.title.empty()) page.title = scene.scene.run.title;
  } else {
    tables.notes.push_back(
        "The scene is not one that this version reads, so the picture of the "
        "charge is left out: " +
        scene.errors.front());
  }
  for (std::string& blob : view.packed) page.blobs.push_back(std::move(blob));
  std::vector<std::string> notes = tables.notes;
  notes.insert(notes.end(), view.notes.begin(), view.notes.end());
  const fs::path summary = fs::path(run.folder) / "summary.json";
  const std::string summary_text =
      fs::exists(summary) ? read_text_file("summary", summary.string()) : std::string();
  page.runs += fmt::format(
      "{}{{\"name\":{},\"summary\":{},\"scene_text\":{},\"scene\":{},\"provenance\":{},"
      "\"notes\":{},\"arrays\":{},\"texts\":{},\"view\":{}}}",
      page.runs.empty() ? "" : ",", json_string(name_of(run)), json_string(summary_text),
      json_string(tables.scene), scene_json(scene), tables.provenance, list_json(notes),
      tables.arrays, tables.texts, view.json);
}

// `budget`: of all of them.
void add_runs(const std::vector<ReportRun>& runs, ViewBudget budget, RunParts parts, Page& page) {
  if (runs.empty()) return;
  budget.bytes /= runs.size();
  budget.most_particles = std::max<std::size_t>(1, budget.most_particles / runs.size());
  for (const ReportRun& run : runs) add_run(run, budget, parts, page);
}

std::string title_of(const std::vector<ReportRun>& runs, const ReportOptions& options,
                     const Page& page) {
  if (!options.title.empty()) return options.title;
  if (runs.size() == 1) return page.title.empty() ? name_of(runs.front()) : page.title;
  std::string title;
  for (const ReportRun& run : runs) title += (title.empty() ? "" : ", ") + name_of(run);
  return title;
}

// The policy lets the page run what is in it and hand out what it made; nothing is fetched.
constexpr const char* kHead = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data: blob:">
)";

}  // namespace

std::string html_page(const PageContents& contents) {
  Page page;
  page.blobs = contents.blobs;
  add_runs(contents.pictures, {}, RunParts::kPicture, page);
  const std::string pictures =
      contents.pictures.empty() ? "" : fmt::format(",\"pictures\":[{}]", page.runs);
  const std::string data = fmt::format("{{\"title\":{},{}:{}{}}}", json_string(contents.title),
                                       json_string(contents.kind), contents.data, pictures);
  std::string html = kHead;
  html += fmt::format("<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n",
                      html_text(contents.title), report_style());
  html +=
      "<main id=\"page\"><p class=\"loading\">Reading the page ...</p>"
      "<noscript><p>This page draws its plots with JavaScript, which is off.</p></noscript>"
      "</main>\n";
  html += fmt::format("<script type=\"text/plain\" id=\"data\">{}</script>\n", packed(data));
  for (std::size_t k = 0; k < page.blobs.size(); ++k) {
    html +=
        fmt::format("<script type=\"text/plain\" id=\"blob{}\">{}</script>\n", k, page.blobs[k]);
  }
  html += "<script>";
  html += report_program();
  html += "</script>\n</body>\n</html>\n";
  return html;
}

std::string html_report(const std::vector<ReportRun>& runs, const ReportOptions& options) {
  QUERN_CHECK(!runs.empty());
  Page page;
  add_runs(runs, options.view, RunParts::kAll, page);
  return html_page(
      {title_of(runs, options, page), "runs", "[" + page.runs + "]", std::move(page.blobs)});
}

void write_html_report(const std::string& path, const std::vector<ReportRun>& runs,
                       const ReportOptions& options) {
  write_text_file("report", path, html_report(runs, options), Durability::kKill);
}

}  // namespace quern
