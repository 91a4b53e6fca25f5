// What the page of a sweep carries (io/report/src/sections/sweep.js shows it): the table as JSON,
// and the pictures of the mills with the least and the most of each response.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apps/quern/sweep_table.h"
#include "io/file_commit.h"
#include "io/html_report.h"
#include "io/packed.h"

namespace quern {

namespace {

constexpr std::size_t kMostPictures = 10;

template <class T, class Text>
std::string list_json(const std::vector<T>& items, const Text& text) {
  std::string json;
  for (const T& item : items) json += (json.empty() ? "" : ",") + text(item);
  return "[" + json + "]";
}

// The cases with the least and the most, by the mean of their point: its first case stands for it.
std::vector<std::size_t> ends_of(const SweepPlan& plan, const SweepResponse& response) {
  struct Point {
    std::size_t first = 0;
    double sum = 0, count = 0;
    double mean() const { return sum / count; }
  };
  std::vector<Point> points;
  for (std::size_t k = 0; k < plan.cases.size(); ++k) {
    const std::size_t p = plan.cases[k].place.point;
    if (p >= points.size()) points.resize(p + 1);
    if (!std::isfinite(response.value[k])) continue;
    if (points[p].count == 0) points[p].first = k;
    points[p].sum += response.value[k];
    points[p].count += 1;
  }
  std::erase_if(points, [](const Point& p) { return p.count == 0; });
  if (points.size() < 2) return {};
  const auto [least, most] =
      std::minmax_element(points.begin(), points.end(),
                          [](const Point& a, const Point& b) { return a.mean() < b.mean(); });
  return {least->first, most->first};
}

// Row of `shown` of the case; -1 where there is no room for it.
int picture_of(std::size_t k, std::vector<std::size_t>& shown) {
  const auto found = std::find(shown.begin(), shown.end(), k);
  if (found != shown.end()) return static_cast<int>(found - shown.begin());
  if (shown.size() == kMostPictures) return -1;
  shown.push_back(k);
  return static_cast<int>(shown.size()) - 1;
}

std::string responses_json(const SweepPlan& plan, const SweepTable& table,
                           std::vector<std::size_t>& shown) {
  return list_json(table.responses, [&](const SweepResponse& r) {
    std::vector<int> ends;
    for (const std::size_t k : ends_of(plan, r)) ends.push_back(picture_of(k, shown));
    if (std::find(ends.begin(), ends.end(), -1) != ends.end()) ends.clear();
    return fmt::format("{{\"name\":{},\"unit\":{},\"value\":{},\"error\":{},\"ends\":[{}]}}",
                       json_string(r.name), json_string(r.unit), list_json(r.value, json_number),
                       list_json(r.error, json_number), fmt::join(ends, ","));
  });
}

std::string factors_json(const SweepPlan& plan, const SweepTable& table) {
  std::size_t row = 0;
  return list_json(table.factors, [&](const SweepColumn& c) {
    return fmt::format("{{\"key\":{},\"keys\":{},\"unit\":{},\"texts\":{},\"numbers\":{}}}",
                       json_string(c.key), list_json(plan.spec.factors[row++].keys, json_string),
                       json_string(c.unit), list_json(c.texts, json_string),
                       list_json(c.numbers, json_number));
  });
}

std::string cases_json(const SweepPlan& plan, const SweepTable& table) {
  std::size_t row = 0;
  return list_json(plan.cases, [&](const SweepRun& run) {
    return fmt::format("{{\"name\":{},\"status\":{},\"point\":{},\"seed\":{}}}",
                       json_string(run.place.name), json_string(table.status[row++]),
                       run.place.point, run.place.seed);
  });
}

}  // namespace

void write_sweep_page(const SweepPlan& plan, const SweepTable& table) {
  std::vector<std::size_t> shown;
  const std::string responses = responses_json(plan, table, shown);
  PageContents page;
  const std::string& title = plan.cases.front().scene.run.title;
  page.title = "Sweep: " + (title.empty() ? plan.spec.scene : title);
  page.kind = "sweep";
  page.data = fmt::format(
      "{{\"file\":{},\"scene\":{},\"commit\":{},\"set\":{},\"factors\":{},\"responses\":{},"
      "\"cases\":{}}}",
      json_string(plan.spec.file), json_string(plan.spec.scene),
      json_string(QUERN_VERSION " " QUERN_COMMIT), list_json(plan.spec.set, json_string),
      factors_json(plan, table), responses, cases_json(plan, table));
  for (const std::size_t k : shown) {
    page.pictures.push_back({plan.cases[k].folder, plan.cases[k].place.name});
  }
  write_text_file("page", plan.out + "/sweep.html", html_page(page), Durability::kKill);
}

}  // namespace quern
