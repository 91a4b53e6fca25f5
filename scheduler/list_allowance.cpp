#include "scheduler/list_allowance.h"

#include <algorithm>
#include <cmath>

namespace quern {

namespace {

constexpr double kQuietShare = 0.05;  // of half the slack: what a sphere among resting ones may do

// m: the least and the most that a centre may stray, and the time it has for it.
struct Limits {
  double quiet, most, window;
  explicit Limits(const Clock& clock)
      // Rounding must not lift an allowance above half the slack, which the search went by.
      : quiet(kQuietShare * 0.5 * clock.slack),
        most((1 - 1e-6) * 0.5 * clock.slack),
        window(static_cast<double>(clock.list_window) * clock.dt) {}
  double way(float speed) const { return quiet + window * static_cast<double>(speed); }
  float allowance(float speed) const { return static_cast<float>(std::min(most, way(speed))); }
};

}  // namespace

template <class Real>
void set_allowances(World<Real>& world, std::size_t tile, const TileMeetings& meetings,
                    std::vector<float>& speed) {
  Particles<Real>& p = world.particles;
  const std::size_t n = p.size(), first = tile * world.tile_size;
  const std::size_t last = std::min<std::size_t>(n, first + world.tile_size);
  const auto raise = [&](std::size_t k, float to) { speed[k] = std::max(speed[k], to); };
  // The most that a hit by the other one changes its velocity by.
  const auto hit = [&](std::size_t k, std::size_t by, float meeting) {
    const double own = static_cast<double>(p.traits[k].inverse_mass);
    const double sum = own + static_cast<double>(p.traits[by].inverse_mass);
    raise(k, static_cast<float>(2 * own / sum * static_cast<double>(meeting)));
  };
  for (const CandidatePair& pair : meetings.own) {
    hit(pair.i, pair.j, pair.speed);
    if (pair.j < last && pair.j >= first) hit(pair.j, pair.i, pair.speed);
  }
  for (const CandidatePair& pair : meetings.imported) hit(pair.j, pair.i, pair.speed);
  if (meetings.near != nullptr) {
    for (const NearSphere& near : *meetings.near) raise(near.sphere, near.speed);
  }
  const Limits limits(world.clock);
  for (std::size_t k = first; k < last; ++k) p.list_allowance[k] = limits.allowance(speed[k]);
}

template <class Real>
void set_body_allowances(World<Real>& world, const std::vector<float>& speed) {
  Polyhedra<Real>& p = world.polyhedra;
  const Limits limits(world.clock);
  for (std::size_t k = 0; k < p.size(); ++k) {
    const double reach = p.scale[k] * world.shapes[p.shape[k]].bound_radius;
    p.list_allowance[k] = limits.allowance(speed[k]);
    p.list_turn[k] =
        static_cast<float>(limits.way(speed[k]) + limits.window * p.spin(k).norm() * reach);
  }
}

void drop_apart(const Column<float>& allowance, std::vector<CandidatePair>& pairs) {
  std::erase_if(pairs, [&](const CandidatePair& pair) {
    return static_cast<double>(pair.gap) >
           static_cast<double>(allowance[pair.i]) + static_cast<double>(allowance[pair.j]);
  });
}

template void set_allowances(World<float>&, std::size_t, const TileMeetings&, std::vector<float>&);
template void set_allowances(World<double>&, std::size_t, const TileMeetings&, std::vector<float>&);
template void set_body_allowances(World<float>&, const std::vector<float>&);
template void set_body_allowances(World<double>&, const std::vector<float>&);

}  // namespace quern
