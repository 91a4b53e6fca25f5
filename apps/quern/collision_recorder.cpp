#include "apps/quern/collision_recorder.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "io/statistics.h"
#include "kernels/collision_tally.h"
#include "scheduler/open_episodes.h"

namespace quern {

namespace {

// What is told of a kind.
struct Part {
  const char *name, *series, *doc;
  double (*energy)(const Collisions&, std::size_t kind);
};
constexpr std::array<Part, 4> kParts = {
    {{"total", "dissipation_by_kind", "dissipated in collisions of one kind",
      [](const Collisions& c, std::size_t kind) { return c.dissipated(kind); }},
     {"normal", "normal_by_kind", "of it by normal damping",
      [](const Collisions& c, std::size_t kind) { return c.normal_damping(kind); }},
     {"sliding", "sliding_by_kind", "of it by sliding",
      [](const Collisions& c, std::size_t kind) { return c.kinds[kind].slide; }},
     {"tangential", "tangential_by_kind", "of it by tangential damping",
      [](const Collisions& c, std::size_t kind) { return c.kinds[kind].tangential_damping; }}}};

// Standard error of the rate at which a series grows, from the rows after `first`.
double rate_error(const std::vector<double>& time, const std::vector<double>& energy,
                  std::size_t first) {
  std::vector<double> rates;
  for (std::size_t k = first + 1; k < time.size(); ++k) {
    rates.push_back((energy[k] - energy[k - 1]) / (time[k] - time[k - 1]));
  }
  return block_mean(rates).standard_error;
}

double sum_of(const std::array<double, kEnergyBins>& bins) {
  double sum = 0;
  for (const double bin : bins) sum += bin;
  return sum;
}

}  // namespace

CollisionRecorder::CollisionRecorder(const Groups& groups) {
  for (std::size_t kind = 0; kind < groups.kinds(); ++kind) {
    kinds_.push_back(groups.kind_name(kind));
  }
}

std::vector<Quantity> CollisionRecorder::quantities() const {
  std::vector<Quantity> all;
  for (const Part& part : kParts) {
    for (const std::string& kind : kinds_) {
      all.push_back({fmt::format("{}/{}", part.series, kind), "J",
                     fmt::format("{}, since recording began", part.doc)});
    }
  }
  return all;
}

void CollisionRecorder::append(const Collisions& collisions, std::vector<double>& row) const {
  for (const Part& part : kParts) {
    for (std::size_t kind = 0; kind < kinds_.size(); ++kind) {
      row.push_back(collisions.on() ? part.energy(collisions, kind) : 0);
    }
  }
}

template <class Real>
void CollisionRecorder::write(const World<Real>& world, double record_from, SeriesWriter& series,
                              Summary& summary) const {
  const Collisions& c = world.collisions;
  if (c.recording != Recording::kOn) return;
  const double time = c.steps * world.clock.dt;
  write_power(c, time, record_from, series, summary);
  write_spectra(world, time, series, summary);
  // The account of the window: what the walls gave is dissipated or stored.
  const Ledger &now = world.ledger, &then = c.start;
  const double given = now.wall_work - then.wall_work + now.gravity_work - then.gravity_work;
  const double dissipated = now.dissipated() - then.dissipated();
  const double stored = now.kinetic - then.kinetic + now.elastic - then.elastic;
  double of_kinds = 0;
  for (std::size_t kind = 0; kind < kinds_.size(); ++kind) of_kinds += c.dissipated(kind);
  summary.set("recorded_time_s", time);
  summary.set("recorded_dissipation_J", dissipated);
  summary.set("recorded_work_J", given);
  summary.set("recorded_stored_change_J", stored);
  const auto relative = [](double a, double b) { return b > 0 ? std::abs(a - b) / b : 0; };
  summary.set("recorded_balance_error", relative(dissipated + stored, given));
  summary.set("kinds_sum_error", relative(of_kinds, dissipated));
}

void CollisionRecorder::write_power(const Collisions& collisions, double time, double record_from,
                                    SeriesWriter& series, Summary& summary) const {
  const std::vector<double> times = series.read("time");
  const auto first = static_cast<std::size_t>(
      std::upper_bound(times.begin(), times.end(), record_from + 1e-9) - times.begin());
  std::array<std::vector<double>, kParts.size()> power, error;
  for (std::size_t p = 0; p < kParts.size(); ++p) {
    for (std::size_t kind = 0; kind < kinds_.size(); ++kind) {
      const std::string name = fmt::format("{}/{}", kParts[p].series, kinds_[kind]);
      power[p].push_back(time > 0 ? kParts[p].energy(collisions, kind) / time : 0);
      error[p].push_back(rate_error(times, series.read(name), first));
    }
  }
  std::vector<TableColumn> columns;
  for (std::size_t p = 0; p < kParts.size(); ++p) {
    const std::string doc = fmt::format("{}, mean over the recorded window", kParts[p].doc);
    columns.push_back(table_column<double>({kParts[p].name, "W", doc}, power[p]));
    columns.push_back(table_column<double>(
        {fmt::format("{}_standard_error", kParts[p].name), "W", "from ten blocks"}, error[p]));
  }
  series.write_table("power_by_kind", columns);
  series.text("power_by_kind/kind", fmt::format("{}", fmt::join(kinds_, "\n")));
  for (std::size_t kind = 0; kind < kinds_.size(); ++kind) {
    summary.set_mean(fmt::format("power_{}_W", kinds_[kind]), power[0][kind], error[0][kind]);
  }
}

template <class Real>
void CollisionRecorder::write_spectra(const World<Real>& world, double time, SeriesWriter& series,
                                      Summary& summary) const {
  const Collisions& c = world.collisions;
  std::vector<double> from, open_count, open_energy;
  for (std::size_t bin = 0; bin < kEnergyBins; ++bin) from.push_back(energy_bin_from(bin));
  for (const OpenEpisodes& open : open_episodes(world)) {
    open_count.push_back(open.count);
    open_energy.push_back(open.dissipated);
  }
  const TableColumn columns[] = {
      table_column<double>({"energy_from", "J", "lower edge of each bin; below the first: 0"},
                           from),
      table_column<double>({"open_count", "1", "collisions that go on at the end, of each kind"},
                           open_count),
      table_column<double>({"open_energy", "J", "dissipated in these so far, of each kind"},
                           open_energy),
      table_column<double>({"recorded_time", "s", "that was recorded"}, std::span(&time, 1))};
  series.write_table("spectra", columns);
  series.text("spectra/kind", fmt::format("{}", fmt::join(kinds_, "\n")));
  double told = 0, dissipated = 0;
  for (std::size_t kind = 0; kind < kinds_.size(); ++kind) {
    const KindSpectra& s = c.spectra[kind];
    const TableColumn bins[] = {
        table_column<double>({"count", "1", "collisions by what they dissipated"},
                             s.dissipated.count),
        table_column<double>({"energy", "J", "dissipated in them"}, s.dissipated.energy),
        table_column<double>({"approach_count", "1", "ended ones by 1/2 m_e v_n^2 at first touch"},
                             s.approach.count),
        table_column<double>({"approach_energy", "J", "sum of it"}, s.approach.energy),
        table_column<double>({"impact_count", "1", "begun ones by 1/2 m_e v^2 at first touch"},
                             s.impact.count),
        table_column<double>({"impact_energy", "J", "sum of it"}, s.impact.energy)};
    series.write_table("spectra/" + kinds_[kind], bins);
    told += sum_of(s.dissipated.energy) + open_energy[kind];
    dissipated += c.dissipated(kind);
  }
  summary.set("spectra_sum_error", dissipated > 0 ? std::abs(told - dissipated) / dissipated : 0);
}

template void CollisionRecorder::write(const World<float>&, double, SeriesWriter&, Summary&) const;
template void CollisionRecorder::write(const World<double>&, double, SeriesWriter&, Summary&) const;

}  // namespace quern
