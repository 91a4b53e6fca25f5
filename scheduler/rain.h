// Rain: particles inserted from above over fill.over seconds (fill.method = kRain, over > 0).
//
// Particles arrive in a shuffled order, so that classes do not lie in layers; the number due grows
// linearly in time. A batch puts those due into the zone near the top, free of what is there; the
// first that finds no place ends the batch and is tried again with the next one. The only state is
// the number inserted, so a restart needs that one integer. Which particle comes when is a function
// of the seed; where it appears is a function of (seed, particle, time).
//
//   zone: above the rim of an open box; fill.low/high; else the upper half of the region
#pragma once

#include <span>
#include <vector>

#include "scheduler/fill_region.h"
#include "scheduler/sizes.h"

namespace quern {

// A sphere, or the one around a polyhedron.
struct PlacedSphere {
  Vec3 position;
  double radius;
};

class Rain {
 public:
  // `walls` outlive this; they are taken in their pose of t = 0. `particles`: all of the scene.
  Rain(const Scene& scene, std::span<const Facets* const> walls,
       std::span<const ParticleSeed> particles);

  std::size_t waiting() const { return order_.size() - inserted_; }
  std::size_t inserted() const { return inserted_; }
  void resume_after(std::size_t inserted);  // of a checkpoint

  // The first `inserted` particles to arrive, in order of arrival.
  std::span<const std::size_t> arrivals() const { return {order_.data(), inserted_}; }

  // How many are to be in at `time` seconds after the rain began.
  std::size_t due(double time) const;

  // Bounds of the zone: spheres elsewhere need not be among `present`.
  const Vec3& zone_low() const { return region_.low(); }
  const Vec3& zone_high() const { return region_.high(); }

  // Inserts what is due and fits; sets those particles' positions and returns their numbers.
  std::vector<std::size_t> insert(double time, std::span<const PlacedSphere> present,
                                  std::vector<ParticleSeed>& particles);

 private:
  std::uint64_t seed_ = 0;
  double over_ = 0;  // s
  FillRegion region_;
  std::vector<std::size_t> order_;
  std::size_t inserted_ = 0;
};

}  // namespace quern
