// What a run hands to the files: plain arrays in order of identity, independent of precision.
//
// scheduler/ fills these from the World, io/ writes them; neither includes the other.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "soa/base.h"

namespace quern {

// One moment of the charge: the spheres, then the polyhedra, both in order of identity. Vectors are
// n x 3, row-major.
struct ParticleFrame {
  double time = 0;                   // s after the mill starts; negative while settling
  std::size_t spheres = 0;           // the first so many; all others are polyhedra
  std::vector<double> position;      // m
  std::vector<float> radius;         // m; of a polyhedron: of the sphere of equal volume
  std::vector<float> velocity;       // m/s
  std::vector<float> spin;           // rad/s
  std::vector<std::uint32_t> id;     // for life
  std::vector<std::uint16_t> species;   // row of the scene's [[particles]]
  std::vector<std::uint16_t> size_class;  // over the scene, see soa/size_classes.h
  std::vector<std::uint16_t> contacts;  // touching partners, walls included
};

// What goes with a ParticleFrame where energies are asked for, in its order.
struct EnergyFrame {
  std::vector<double> mass;               // kg
  std::vector<double> rotational_energy;  // J, from the half-step spin
};

// The polyhedra at the same moment, in the order of ParticleFrame, as what is seen of them.
struct PolyhedronFrame {
  std::vector<double> orientation;      // n x 4, w x y z, body to world
  std::vector<std::uint32_t> shape;     // n: row of the world's shapes
  std::vector<float> vertex;            // m x 3, world frame
  std::vector<std::uint32_t> triangle;  // k x 3
  std::vector<std::uint32_t> body;      // k: which of the n
};

// All that touched in the last step, each contact once: of i, `first`, with j, `second`, in order
// of i, with its particles before its walls, then of j. Of two spheres i is the smaller one (ties:
// lower identity), of two polyhedra that of higher identity, of a sphere and a polyhedron the
// sphere.
//
// The moment is that in which the step worked the force out: places of the particles are those
// before they moved, one time step before those of a ParticleFrame, and walls stand as in the
// WallFrame. So point, normal, overlap and force belong together.
struct ContactFrame {
  std::vector<double> point;            // m, n x 3: where the force acts
  std::vector<float> force;             // N, n x 3: on i
  std::vector<float> normal;            // n x 3: unit, from j to i
  std::vector<float> overlap;           // m
  std::vector<float> normal_force;      // N, along the normal; negative where a law pulls
  std::vector<float> tangential_force;  // N, what is left, as a length
  std::vector<std::uint32_t> first;     // identity
  std::vector<std::uint32_t> second;    // identity; of a wall: row of World's walls
  std::vector<std::uint8_t> wall;       // 1: j is a wall
  std::vector<std::uint16_t> kind;      // of collision: row of the kinds of Groups
};

// The walls at the same moment, in the world frame.
struct WallFrame {
  struct Field {  // of each triangle
    std::string name, unit;
    std::vector<float> value;
  };
  std::vector<float> vertex;            // m x 3
  std::vector<std::uint32_t> triangle;  // k x 3
  std::vector<std::uint16_t> wall;      // k: row of World's walls
  std::vector<float> speed;             // k: of the triangle's centre, m/s
  std::vector<Field> fields = {};       // more
};

// One body alone, with the face that each of its triangles belongs to.
struct SurfaceFrame {
  std::vector<double> vertex;           // m x 3
  std::vector<std::uint32_t> triangle;  // k x 3
  std::vector<std::uint16_t> face;      // k
};

struct Quantity {
  std::string name;  // the field's word, lower_snake
  std::string unit;  // "W", "N m", "1"
  std::string doc;   // one line
};

}  // namespace quern
