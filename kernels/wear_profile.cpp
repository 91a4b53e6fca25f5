#include "kernels/wear_profile.h"

#include <algorithm>
#include <cmath>

namespace quern {

namespace {

using Vec2 = Eigen::Vector2d;

// A straight part of the section of one pitch: of edge `edge` of a lifter's run of the profile,
// from `from` to `to` (m along it), in equal bins.
struct Part {
  std::size_t edge;
  double from, to;
  bool of_next;  // behind the middle of the shell: it belongs to the pitch of the next lifter
  std::size_t first_bin, bins;
  double width() const { return (to - from) / static_cast<double>(bins); }
};

class Section {
 public:
  Section(const MillSpec& mill, double size)
      : mill_(mill),
        profile_(mill_profile(mill)),
        edges_(profile_.size() / static_cast<std::size_t>(mill.lifters->count)) {
    const std::size_t arcs = edges_ - 3;
    const auto whole = [&](std::size_t edge, bool of_next) {
      add(edge, 0, length(edge), of_next, size);
    };
    const auto half = [&](bool of_next) {
      const std::size_t edge = 3 + arcs / 2;
      const double middle = 0.5 * length(edge);
      add(edge, of_next ? middle : 0, of_next ? length(edge) : middle, of_next, size);
    };
    if (arcs % 2 == 1) half(true);
    for (std::size_t a = (arcs + 1) / 2; a < arcs; ++a) whole(3 + a, true);
    for (std::size_t edge = 0; edge < 3; ++edge) whole(edge, false);
    for (std::size_t a = 0; a < arcs / 2; ++a) whole(3 + a, false);
    if (arcs % 2 == 1) half(false);
  }

  const std::vector<Part>& parts() const { return parts_; }
  std::size_t bins() const { return parts_.back().first_bin + parts_.back().bins; }
  std::size_t lifters() const { return static_cast<std::size_t>(mill_.lifters->count); }
  std::size_t edges() const { return edges_; }
  Vec2 begin(std::size_t corner) const { return profile_[corner % profile_.size()]; }
  Vec2 along(std::size_t corner) const { return (begin(corner + 1) - begin(corner)).normalized(); }

  // The corner of the profile at which the edge nearest to x begins.
  std::size_t edge_at(const Vec2& x) const {
    std::size_t nearest = 0;
    double least = HUGE_VAL;
    for (std::size_t k = 0; k < profile_.size(); ++k) {
      const Vec2 e = begin(k + 1) - begin(k), d = x - begin(k);
      const double t = std::clamp(d.dot(e) / e.squaredNorm(), 0.0, 1.0);
      const double distance2 = (d - t * e).squaredNorm();
      if (distance2 >= least) continue;
      least = distance2;
      nearest = k;
    }
    return nearest;
  }

  void describe(WearProfile& out) const {
    double arc = 0;
    for (const Part& p : parts_) {
      const Eigen::Rotation2Dd turn(p.of_next ? -2 * kPi / mill_.lifters->count : 0);
      for (std::size_t b = 0; b < p.bins; ++b) {
        const double middle = p.width() * (static_cast<double>(b) + 0.5);
        const Vec2 at = turn * Vec2(begin(p.edge) + (p.from + middle) * along(p.edge));
        out.arc.push_back(arc + middle);
        out.width.push_back(p.width());
        out.x.push_back(at.x());
        out.y.push_back(at.y());
      }
      arc += p.to - p.from;
    }
  }

 private:
  double length(std::size_t edge) const { return (begin(edge + 1) - begin(edge)).norm(); }
  void add(std::size_t edge, double from, double to, bool of_next, double size) {
    const std::size_t first = parts_.empty() ? 0 : bins();
    const double count = std::max(1.0, std::round((to - from) / size));
    parts_.push_back({edge, from, to, of_next, first, static_cast<std::size_t>(count)});
  }

  const MillSpec& mill_;
  std::vector<Vec2> profile_;
  std::size_t edges_;  // of one pitch
  std::vector<Part> parts_;
};

// The share of a triangle's area below s, of corners at low <= middle <= high.
double share_below(const std::array<double, 3>& at, double s) {
  const auto [low, middle, high] = at;
  if (s <= low) return 0;
  if (s >= high) return 1;
  if (s < middle) return (s - low) * (s - low) / ((high - low) * (middle - low));
  return 1 - (high - s) * (high - s) / ((high - low) * (high - middle));
}

// Adds the cells to the sums of each lifter's bins.
void spread_cells(const Section& section, const WallWear& liner, std::vector<WearRow>& sums) {
  Index facet = kNoIndex;
  std::size_t corner = 0;
  for (std::size_t k = 0; k < liner.cells.size(); ++k) {
    const WearCell& cell = liner.cells[k];
    if (cell.facet != facet) {  // the nearest edge of a cell of it is that of all
      const Vec3 middle = (cell.corner[0] + cell.corner[1] + cell.corner[2]) / 3;
      corner = section.edge_at(middle.head<2>());
      facet = cell.facet;
    }
    const std::size_t lifter = corner / section.edges(), edge = corner % section.edges();
    std::array<double, 3> at;
    for (std::size_t c = 0; c < 3; ++c) {
      at[c] = section.along(corner).dot(Vec2(cell.corner[c].head<2>() - section.begin(corner)));
    }
    std::sort(at.begin(), at.end());
    for (const Part& p : section.parts()) {
      if (p.edge != edge) continue;
      const std::size_t of = (lifter + (p.of_next ? 1 : 0)) % section.lifters();
      for (std::size_t b = 0; b < p.bins; ++b) {
        const double from = p.from + static_cast<double>(b) * p.width();
        const double share = share_below(at, from + p.width()) - share_below(at, from);
        if (share == 0) continue;
        WearRow& sum = sums[of * section.bins() + p.first_bin + b];
        for (std::size_t m = 0; m < kWearSums; ++m) sum[m] += share * liner.made[k][m];
      }
    }
  }
}

}  // namespace

WearProfile wear_profile(const MillSpec& mill, const WallWear& liner, double size) {
  const Section section(mill, size);
  WearProfile out;
  section.describe(out);
  std::vector<WearRow> sums(section.lifters() * section.bins(), WearRow{});
  spread_cells(section, liner, sums);
  const double n = static_cast<double>(section.lifters());
  for (std::size_t bin = 0; bin < section.bins(); ++bin) {
    WearRow mean{}, spread{};
    const double area = out.width[bin] * mill.length;
    for (std::size_t m = 0; m < kWearSums; ++m) {
      const bool impulse = m == kNormalImpulse || m == kShearImpulse;
      const double factor =
          liner.time > 0 ? (impulse ? 1 : kMmPer1000Hours) / (area * liner.time) : 0;
      const auto rate = [&](std::size_t lifter) {
        return factor * sums[lifter * section.bins() + bin][m];
      };
      for (std::size_t l = 0; l < section.lifters(); ++l) mean[m] += rate(l) / n;
      for (std::size_t l = 0; l < section.lifters() && n > 1; ++l) {
        spread[m] += (rate(l) - mean[m]) * (rate(l) - mean[m]) / (n - 1);
      }
      spread[m] = std::sqrt(spread[m]);
    }
    out.mean.push_back(mean);
    out.spread.push_back(spread);
  }
  return out;
}

}  // namespace quern
