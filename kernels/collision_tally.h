// CollisionTally: what the contacts of a tile, or of a stretch of polyhedra, tell of their
// collisions in one step. Tiles fill theirs side by side; they are added to World's Collisions in
// order, so that sums do not depend on threads.
#pragma once

#include <vector>

#include "kernels/liner_histogram.h"
#include "soa/collisions.h"
#include "soa/groups.h"

namespace quern {

// The bin of an energy; NaN is below all.
std::size_t energy_bin(double energy) noexcept;
// J, lower edge of a bin; 0 of the first.
double energy_bin_from(std::size_t bin) noexcept;

class CollisionTally {
 public:
  // `groups` outlives what is told until the next reset; `liner_time` (s): of a contact with a
  // mill's liner in this step, see liner_time().
  void reset(const Groups& groups, double liner_time) {
    groups_ = &groups;
    liner_time_ = liner_time;
    kinds_.assign(groups.kinds(), ContactEnergies());
    ended_.clear();
    begun_.clear();
    liner_.clear();
  }
  const Groups& groups() const { return *groups_; }
  void add(std::size_t kind, const ContactEnergies& energies) { kinds_[kind].add(energies); }
  void begin_episode(std::size_t kind, double impact);
  void end_episode(std::size_t kind, double dissipated, double approach);

  // Whether slow contacts with the liner are told in this step.
  bool samples_liner() const { return liner_time_ > 0; }
  // A contact with a mill's liner at (x, y) from the axis that lost so much (J) to damping along
  // the normal in this step.
  void touch_liner(double x, double y, double normal_dissipation, LinerTouch touch) {
    liner_.push_back({normal_dissipation, static_cast<std::uint16_t>(liner_bin(x, y)), touch});
  }

  // To the sums of now: the opening step sets the energies of the springs and counts nothing.
  void add_to(Collisions& all) const;

 private:
  struct Binned {
    std::uint32_t kind;
    std::uint16_t bin, approach_bin;
    double energy, approach;  // J
  };
  const Groups* groups_ = nullptr;
  double liner_time_ = 0;  // s
  std::vector<ContactEnergies> kinds_;
  struct OnLiner {
    double normal_dissipation;
    std::uint16_t bin;
    LinerTouch touch;
  };
  std::vector<Binned> ended_, begun_;
  std::vector<OnLiner> liner_;
};

}  // namespace quern
