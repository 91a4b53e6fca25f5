// From the sums of wear cells to volumes, depths and pressures. Set-up and end-of-run code.
#pragma once

#include <vector>

#include "kernels/wear.h"

namespace quern {

// The models, as files name them.
struct WearModel {
  WearSum sum;
  const char* name;
  const char* doc;
};
inline constexpr WearModel kWearModels[] = {
    {kSiemEnergy, "siem", "by shear impact energy"},
    {kSlidingEnergy, "sliding", "by shear impact energy, of sliding alone"},
    {kArchardWork, "archard", "by Archard"},
    {kFinnieEnergy, "finnie", "by Finnie"}};

inline constexpr double kMmPer1000Hours = 3.6e9;  // a metre per second in mm per 1000 h

// The cells of one wall. `made` has volumes (m^3) and, as summed, impulses (N s).
struct WallWear {
  std::vector<WearCell> cells;
  std::vector<double> energy;  // J, kSiemEnergy as summed
  std::vector<double> area;    // m^2
  std::vector<WearRow> made;
  double time = 0;  // s
  // Of all cells: m, or per time; Pa, of the mean force. 0 while no time is recorded.
  std::vector<double> depth(WearSum sum) const;
  std::vector<double> depth_rate(WearSum sum) const;  // mm per 1000 h
  std::vector<double> pressure() const;
  std::vector<double> shear() const;
  WearRow total() const;  // of `made`

 private:
  std::vector<double> over_area(WearSum sum, double factor) const;
  double per_time() const { return time > 0 ? 1 / time : 0; }
};

template <class Real>
WallWear wall_wear(const World<Real>& world, const Scene& scene, Index wall);

// What the walls have worn off each species of particles (m^3): the same terms with the hardness of
// its material. NaN where that has none.
template <class Real>
std::vector<WearRow> species_wear(const World<Real>& world, const Scene& scene);

}  // namespace quern
