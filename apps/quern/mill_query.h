// What the finders of angles need to know of a scene's mill.
#pragma once

#include <cmath>

#include "soa/charge_shape.h"
#include "soa/motion.h"
#include "soa/scene.h"

namespace quern {

// The mill's turn from one time to another, rad.
inline double turn_of(const MillSpec& mill, double from, double to) {
  return schedule_integral(mill.rotation, to) - schedule_integral(mill.rotation, from);
}

// The scene has a mill. `particle_size`: the median diameter, m.
inline ChargeQuery mill_query(const Scene& scene, double from, double to, double particle_size) {
  ChargeQuery query;
  query.direction = turn_of(*scene.mill, from, to) < 0 ? -1 : 1;
  query.lifter_height = scene.mill->lifters ? scene.mill->lifters->height : 0;
  query.particle_size = particle_size;
  const Vec3& g = scene.run.gravity;
  if (std::hypot(g.x(), g.y()) > 0) query.up = std::atan2(-g.y(), -g.x());
  return query;
}

}  // namespace quern
