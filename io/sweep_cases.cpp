// The cases of a sweep: levels combined by its design, and names for their folders.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>

#include "io/quantity.h"
#include "io/sweep_reader.h"

namespace quern {
namespace {

using Levels = std::vector<std::vector<std::string>>;  // of each factor the text of each key

void combine_grid(const SweepSpec& spec, std::vector<Levels>& points) {
  points.push_back({});
  for (const SweepFactor& factor : spec.factors) {
    std::vector<Levels> more;
    for (const Levels& point : points) {
      for (const auto& level : factor.values) {
        more.push_back(point);
        more.back().push_back(level);
      }
    }
    points = std::move(more);
  }
}

void combine_list(const SweepSpec& spec, std::vector<Levels>& points) {
  for (std::size_t k = 0; k < spec.factors.front().values.size(); ++k) {
    Levels& point = points.emplace_back();
    for (const SweepFactor& factor : spec.factors) point.push_back(factor.values[k]);
  }
}

// Of a factor: its place in [0, 1) of each sample, one in each n-th.
std::vector<double> strata(std::size_t factor, std::size_t n, const SweepRandom& random) {
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t k = n; k > 1; --k) {  // Fisher and Yates
    const auto other = static_cast<std::size_t>(random(factor, k) * static_cast<double>(k));
    std::swap(order[k - 1], order[std::min(other, k - 1)]);
  }
  std::vector<double> places;
  for (std::size_t k = 0; k < n; ++k) {
    const double within = random(factor, n + 1 + k);
    places.push_back((static_cast<double>(order[k]) + within) / static_cast<double>(n));
  }
  return places;
}

std::string text_at(const SweepFactor& factor, std::size_t key, double place) {
  const double low = factor.from[key], high = factor.to[key];
  double value = low + place * (high - low);
  if (factor.whole[key]) {  // each whole number of the range has an equal part of it
    const double first = std::min(low, high), count = std::abs(high - low) + 1;
    value = first + std::floor((high > low ? place : 1 - place) * count);
    value = std::clamp(value, first, first + count - 1);
  }
  const std::string number = fmt::format("{:.6g}", value);
  return factor.units[key].empty() ? number : number + " " + factor.units[key];
}

void combine_hypercube(SweepSpec& spec, const SweepRandom& random, std::vector<Levels>& points) {
  const auto n = static_cast<std::size_t>(spec.samples);
  points.resize(n);
  for (std::size_t f = 0; f < spec.factors.size(); ++f) {
    const SweepFactor& factor = spec.factors[f];
    const std::vector<double> places = strata(f, n, random);
    for (std::size_t k = 0; k < n; ++k) {
      std::vector<std::string>& level = points[k].emplace_back();
      if (!factor.ranges()) {
        const auto count = static_cast<double>(factor.values.size());
        level = factor.values[static_cast<std::size_t>(places[k] * count)];
        continue;
      }
      for (std::size_t key = 0; key < factor.keys.size(); ++key) {
        level.push_back(text_at(factor, key, places[k]));
        spec.places[factor.keys[key] + "=" + level.back()] = factor.place;
      }
    }
  }
}

// "mill.lifters.face_angle" -> "face_angle", unless another factor would be called the same.
std::string short_key(const SweepSpec& spec, const std::string& key) {
  const auto last = [](const std::string& k) { return k.substr(k.find_last_of('.') + 1); };
  const auto same = std::count_if(spec.factors.begin(), spec.factors.end(),
                                  [&](const auto& f) { return last(f.keys.front()) == last(key); });
  return same > 1 ? key : last(key);
}

std::string plain(const std::string& text) {
  std::string out;
  for (const char c : text) {
    const bool kept = std::isalnum(static_cast<unsigned char>(c)) || c == '.' || c == '-';
    if (kept) out += c;
    if (!kept && c != ' ' && !out.empty() && out.back() != '_') out += '_';
  }
  return out;
}

// Of values where these are short; else the number of the point.
std::string name_of(const SweepSpec& spec, std::size_t number, const Levels& point) {
  std::string name;
  for (std::size_t f = 0; f < point.size(); ++f) {
    name += (f == 0 ? "" : "_") + plain(short_key(spec, spec.factors[f].keys.front())) + "_" +
            plain(point[f].front());
  }
  constexpr std::size_t kLongest = 80;
  const bool by_number = spec.design == SweepDesign::kLatinHypercube || name.size() > kLongest;
  return by_number ? fmt::format("point_{:04}", number + 1) : name;
}

}  // namespace

std::vector<SweepCase> sweep_cases(SweepSpec& spec, std::uint64_t seed, const SweepRandom& random) {
  std::vector<Levels> points;
  if (spec.design == SweepDesign::kGrid) combine_grid(spec, points);
  if (spec.design == SweepDesign::kList) combine_list(spec, points);
  if (spec.design == SweepDesign::kLatinHypercube) combine_hypercube(spec, random, points);
  std::vector<std::string> names;
  for (std::size_t p = 0; p < points.size(); ++p) {
    std::string name = name_of(spec, p, points[p]);
    if (std::find(names.begin(), names.end(), name) != names.end())
      name = fmt::format("point_{:04}_{}", p + 1, name);
    names.push_back(name);
  }
  std::vector<SweepCase> cases;
  for (std::size_t p = 0; p < points.size(); ++p) {
    for (long r = 0; r < spec.replicates; ++r) {
      SweepCase& c = cases.emplace_back();
      c.name = names[p];
      c.point = p;
      c.seed = seed + static_cast<std::uint64_t>(r);
      c.set = spec.set;
      for (std::size_t f = 0; f < points[p].size(); ++f) {
        c.values.push_back(points[p][f].front());
        for (std::size_t k = 0; k < points[p][f].size(); ++k)
          c.set.push_back(spec.factors[f].keys[k] + "=" + points[p][f][k]);
      }
      if (spec.replicates == 1) continue;
      c.name += fmt::format("_seed_{}", c.seed);
      c.set.push_back(fmt::format("run.seed={}", c.seed));
    }
  }
  return cases;
}

bool split_quantity(const std::string& text, double& number, std::string& unit) {
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || !std::isfinite(number)) return false;
  unit.assign(stop, end);
  unit.erase(0, unit.find_first_not_of(' ') == std::string::npos ? unit.size()
                                                                 : unit.find_first_not_of(' '));
  return true;
}

}  // namespace quern
