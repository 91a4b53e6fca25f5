// Wall contacts of a tile, from candidates to lanes and back.
//
// collect_wall_contacts() runs the narrow phase for the tile's candidates in each body's frame, hands
// springs over from feature to feature, and lays the contacts out as lanes for the force kernel;
// contacts that were open and are gone get a closing lane. return_wall_contacts() stores what the
// kernel wrote as the springs of the next step and books forces on the walls.
#pragma once

#include <span>
#include <vector>

#include "kernels/contact.h"
#include "soa/world.h"

namespace quern {

// A wall's velocity over the step where a contact is and where it was before, and its spin.
struct WallMotion {
  Vec3 velocity, velocity_old, spin;
};


// Lanes of one tile; kept by a worker between tiles.
class WallLanes {
 public:
  void clear() { meta_.clear(); }
  std::size_t size() const { return meta_.size(); }
  void push(const WallSpring& meta, const Vec3& normal_old, double overlap_old,
            const WallMotion& wall, std::uint32_t material);
  // Pads to whole vectors (overlap 0, no force, particle `idle`) and shows the lanes to a kernel.
  WallContacts view(Index idle);
  WallSpring& meta(std::size_t k) { return meta_[k]; }

 private:
  void reserve(std::size_t n);

  std::vector<WallSpring> meta_;
  std::vector<double> numbers_;  // kGeometry + 10 rows of `stride_`
  std::vector<Index> particle_;
  std::vector<std::uint32_t> material_;
  std::size_t stride_ = 0;
};

template <class Real>
void collect_wall_contacts(const World<Real>& world, std::size_t tile, WallLanes& lanes);

// `totals` has a row per wall and is added to.
void return_wall_contacts(const WallContacts& contacts, WallLanes& lanes,
                          const std::vector<Wall>& walls, const std::vector<Body>& bodies,
                          TileWalls& tile, std::span<WallTotal> totals);

}  // namespace quern
