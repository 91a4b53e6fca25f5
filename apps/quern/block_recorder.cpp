#include "apps/quern/block_recorder.h"

#include <vector>

#include "apps/quern/snapshot_clock.h"

namespace quern {

namespace {

constexpr std::uint64_t kBlocks = 10;

}  // namespace

// Whole tenths of the window that are over after this step.
std::uint64_t BlockRecorder::block_of(std::uint64_t step) const {
  return step > first_ ? (step - first_) * kBlocks / window_ : 0;
}

bool BlockRecorder::due(std::uint64_t step) const {
  if (window_ == 0 || step <= first_ || step > first_ + window_) return false;
  return block_of(step) > block_of(step - 1);
}

template <class Real>
void BlockRecorder::write(const World<Real>& world, SeriesWriter& series) const {
  const Collisions& c = world.collisions;
  std::vector<double> count, energy;
  for (const KindSpectra& kind : c.spectra) {
    count.insert(count.end(), kind.dissipated.count.begin(), kind.dissipated.count.end());
    energy.insert(energy.end(), kind.dissipated.energy.begin(), kind.dissipated.energy.end());
  }
  std::vector<double> wear(kWearSums, 0);
  for (std::size_t k = 0; k < world.wear.cells.size(); ++k) {
    wear[k % kWearSums] += world.wear.cells[k];
  }
  std::vector<TableColumn> columns;
  if (!count.empty()) {
    columns.push_back(table_column<double>(
        {"count", "1", "ended collisions so far by what they dissipated, kinds x bins"}, count,
        kEnergyBins));
    columns.push_back(table_column<double>({"energy", "J", "dissipated in them, kinds x bins"},
                                           energy, kEnergyBins));
  }
  if (world.wear.asked()) {
    columns.push_back(table_column<double>(
        {"wear", "J, N m, N s", "sums of the wear models over all cells so far"}, wear));
  }
  if (columns.empty()) return;
  series.write_table(SnapshotClock::name("sum_blocks", block_of(world.clock.step)), columns);
}

template void BlockRecorder::write(const World<float>&, SeriesWriter&) const;
template void BlockRecorder::write(const World<double>&, SeriesWriter&) const;

}  // namespace quern
