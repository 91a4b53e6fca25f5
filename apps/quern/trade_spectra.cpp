#include "apps/quern/trade_spectra.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "soa/collisions.h"

namespace quern {

namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kFigures = 5;
using Values = std::array<double, kFigures>;

// log10 of the middle of a bin.
double middle(std::size_t bin) {
  return kFirstDecade + (static_cast<double>(bin) - 0.5) / kBinsPerDecade;
}

// All kinds together, without the two open bins.
std::vector<double> of_all_kinds(const std::vector<double>& rows) {
  std::vector<double> bins(kEnergyBins, 0);
  for (std::size_t k = 0; k < rows.size(); ++k) bins[k % kEnergyBins] += rows[k];
  bins.front() = bins.back() = 0;
  return bins;
}

struct Moments {
  double mean = kUnknown, deviation = kUnknown;
};

Moments moments_of(const std::vector<double>& bins) {
  double sum = 0, first = 0, second = 0;
  for (std::size_t k = 0; k < bins.size(); ++k) {
    sum += bins[k];
    first += bins[k] * middle(k);
    second += bins[k] * middle(k) * middle(k);
  }
  if (!(sum > 0)) return {};
  const double mean = first / sum;
  return {mean, std::sqrt(std::max(0.0, second / sum - mean * mean))};
}

Values values_of(const std::vector<double>& count, const std::vector<double>& energy) {
  const Moments by_count = moments_of(count), by_energy = moments_of(energy);
  return {spectrum_peak(count), spectrum_peak(energy), by_count.mean, by_energy.mean,
          by_count.deviation};
}

std::vector<double> minus(std::vector<double> a, const std::vector<double>& b) {
  for (std::size_t k = 0; k < a.size(); ++k) a[k] -= b[k];
  return a;
}

}  // namespace

double spectrum_peak(const std::vector<double>& bins) {
  constexpr std::array<double, 5> kSmooth = {1, 4, 6, 4, 1};
  constexpr int kHalf = kBinsPerDecade / 2;
  const auto n = static_cast<int>(bins.size());
  std::vector<double> smooth(bins.size(), 0);
  for (int k = 2; k + 2 < n; ++k) {
    for (int j = -2; j <= 2; ++j) {
      smooth[static_cast<std::size_t>(k)] +=
          kSmooth[static_cast<std::size_t>(j + 2)] / 16 * bins[static_cast<std::size_t>(k + j)];
    }
  }
  const auto top =
      static_cast<int>(std::max_element(smooth.begin(), smooth.end()) - smooth.begin());
  if (!(smooth[static_cast<std::size_t>(top)] > 0)) return kUnknown;
  // Least squares of a + b x + c x^2 over x = -h ... h: odd and even sums part.
  double s2 = 0, s4 = 0, y0 = 0, y1 = 0, y2 = 0;
  for (int x = -kHalf; x <= kHalf; ++x) {
    const int k = top + x;
    const double y = k < 0 || k >= n ? 0 : smooth[static_cast<std::size_t>(k)];
    s2 += x * x;
    s4 += x * x * x * x;
    y0 += y;
    y1 += x * y;
    y2 += x * x * y;
  }
  const double m = 2 * kHalf + 1, b = y1 / s2, c = (y2 - s2 / m * y0) / (s4 - s2 * s2 / m);
  const double shift = c < 0 ? std::clamp(-0.5 * b / c, -1.0 * kHalf, 1.0 * kHalf) : 0;
  return middle(static_cast<std::size_t>(top)) + shift / kBinsPerDecade;
}

std::vector<SpectrumFigure> spectrum_figures(const std::vector<std::vector<double>>& count,
                                             const std::vector<std::vector<double>>& energy) {
  std::vector<SpectrumFigure> out = {{"spectrum_count_peak", "peak of counts"},
                                     {"spectrum_energy_peak", "peak of energy"},
                                     {"spectrum_count_mean", "mean by count"},
                                     {"spectrum_energy_mean", "mean by energy"},
                                     {"spectrum_count_deviation", "width"}};
  Values all;
  all.fill(kUnknown);
  std::vector<Values> blocks;
  std::vector<double> counted(kEnergyBins, 0), dissipated(kEnergyBins, 0);
  for (std::size_t k = 0; k < count.size() && !count[k].empty(); ++k) {
    const std::vector<double> c = of_all_kinds(count[k]), e = of_all_kinds(energy[k]);
    blocks.push_back(values_of(minus(c, counted), minus(e, dissipated)));
    all = values_of(c, e);
    counted = c;
    dissipated = e;
  }
  const auto n = static_cast<double>(blocks.size());
  for (std::size_t f = 0; f < kFigures; ++f) {
    double mean = 0, squares = 0;
    for (const Values& block : blocks) mean += block[f] / n;
    for (const Values& block : blocks) squares += (block[f] - mean) * (block[f] - mean);
    out[f].value = all[f];
    out[f].standard_error = n > 1 ? std::sqrt(squares / n / (n - 1)) : kUnknown;
  }
  return out;
}

}  // namespace quern
