#include "scheduler/list_allowance.h"

#include <algorithm>
#include <cmath>

namespace quern {

namespace {

constexpr double kQuietShare = 0.05; // of half the slack: what a sphere among resting ones may do

float relative_speed(const SearchPoint& a, const SearchPoint& b) {
  float v2 = 0;
  for (std::size_t k = 0; k < 3; ++k) v2 += (a.v[k] - b.v[k]) * (a.v[k] - b.v[k]);
  return std::sqrt(v2);
}

}  // namespace

template <class Real>
void set_allowances(World<Real>& world, const std::vector<SearchPoint>& points, std::size_t tile,
                    const TileMeetings& meetings, std::vector<float>& speed) {
  Particles<Real>& p = world.particles;
  const std::size_t n = p.size(), first = tile * world.tile_size;
  const std::size_t last = std::min<std::size_t>(n, first + world.tile_size);
  const auto raise = [&](std::size_t k, float to) { speed[k] = std::max(speed[k], to); };
  for (const CandidatePair& pair : meetings.own) {
    raise(pair.i, pair.speed);
    if (pair.j < last && pair.j >= first) raise(pair.j, pair.speed);
  }
  for (const CandidatePair& pair : meetings.imported) raise(pair.j, pair.speed);
  if (meetings.near != nullptr) {
    for (const NearSphere& near : *meetings.near) {
      raise(near.sphere, relative_speed(points[near.sphere], points[n + near.polyhedron]));
    }
  }
  const double window = static_cast<double>(world.clock.list_window) * world.clock.dt;
  // Rounding must not lift it above half the slack, which the search went by.
  const double most = 0.5 * (1 - 1e-6) * world.clock.slack;
  for (std::size_t k = first; k < last; ++k) {
    const double way = kQuietShare * most + window * static_cast<double>(speed[k]);
    p.list_allowance[k] = static_cast<float>(std::min(most, way));
  }
}

void drop_apart(const Column<float>& allowance, std::vector<CandidatePair>& pairs) {
  std::erase_if(pairs, [&](const CandidatePair& pair) {
    return static_cast<double>(pair.gap) >
           static_cast<double>(allowance[pair.i]) + static_cast<double>(allowance[pair.j]);
  });
}

template void set_allowances(World<float>&, const std::vector<SearchPoint>&, std::size_t,
                             const TileMeetings&, std::vector<float>&);
template void set_allowances(World<double>&, const std::vector<SearchPoint>&, std::size_t,
                             const TileMeetings&, std::vector<float>&);

}  // namespace quern
