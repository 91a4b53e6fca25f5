// THE table of particle columns: everything a run knows of a particle, one line each.
//
//   X(type, name, unit, doc)
//
// Particles declares its members from this table, permutes by it and is saved by it; `quern info`
// prints it. To store another quantity, add a line. `Real` is float in `mixed`, double in `double`.
#pragma once

#define QUERN_PARTICLE_FIELDS(X)                                                             \
  X(Record<Real>, record, "m, rad/s, m/s", "place, radius, half-step spin and velocity")     \
  X(Traits<Real>, traits, "1/kg, 1", "inverse mass; material, group, contacts of last step") \
  X(Index, id, "1", "identity for life, 0 ... n-1")                                          \
  X(std::uint16_t, species, "1", "row of the scene's [[particles]]")                         \
  X(double, spin_x, "rad/s", "half-step spin in full precision")                             \
  X(double, spin_y, "rad/s", "half-step spin in full precision")                             \
  X(double, spin_z, "rad/s", "half-step spin in full precision")                             \
  X(float, rest_x, "m", "what rounding has left of the place")                               \
  X(float, rest_y, "m", "what rounding has left of the place")                               \
  X(float, rest_z, "m", "what rounding has left of the place")                               \
  X(double, list_x, "m", "place when the lists were built")                                  \
  X(double, list_y, "m", "place when the lists were built")                                  \
  X(double, list_z, "m", "place when the lists were built")                                  \
  X(float, list_vx, "m/s", "velocity the lists were built with")                             \
  X(float, list_vy, "m/s", "velocity the lists were built with")                             \
  X(float, list_vz, "m/s", "velocity the lists were built with")                             \
  X(float, list_allowance, "m", "how far it may leave its line before the lists are stale")  \
  X(Index, pair_first, "1", "first own slot in the pair batch; the others follow 16 apart")  \
  X(Index, pair_count, "1", "own slots in the pair batch")
