// Wall contacts of a tile, from candidates to lanes and back.
//
// collect_wall_contacts() runs the narrow phase for the tile's candidates in each body's frame,
// hands springs over from feature to feature, and lays the contacts out as lanes for the force
// kernel; contacts that were open and are gone get a closing lane. What is known from an earlier
// step is not searched for again, see KnownTouch. return_wall_contacts() stores what the kernel
// wrote as the springs of the next step and books forces on the walls.
#pragma once

#include <span>
#include <vector>

#include "kernels/contact.h"
#include "soa/world.h"

namespace quern {

// What is known of a sphere near facets since it was last looked at: while its centre stays close
// to `place` it touches `facet` alone, in front of its face, or nothing. Derived from the state and
// never saved; whether it is known changes no result.
struct KnownTouch {
  Vec3 place = Vec3::Zero();   // m, in the frame of the walls
  double free = 0;             // m, how far it may go; 0: nothing is known
  Index facet = kNoIndex;      // kNoIndex: it touches nothing
  Index wear_cell = kNoIndex;  // on the facet, where wear is recorded; kNoIndex: not known
};

// What a contact is in this step.
struct WallTouchNow {
  Index particle, wall, feature;
  Index facet;      // one that the point is on; kNoIndex: not known, of a contact that closes
  Index wear_cell;  // kNoIndex: not known
  Vec3 normal, point;
  double overlap;
};

// Lanes of one tile; kept by a worker between tiles.
class WallLanes {
 public:
  static constexpr std::size_t kPoint = WallContacts::kGeometry + 10;  // row

  void clear() { size_ = 0; }
  // Where the spheres of all candidates are in the frames of their bodies, and whether what is
  // known of them still holds.
  template <class Real>
  void find_centers(const World<Real>& world, const WallCandidates& candidates,
                    std::span<const KnownTouch> known);
  Vec3 center(std::size_t entry) const {
    return {center_[0][entry], center_[1][entry], center_[2][entry]};
  }
  bool holds(std::size_t entry) const { return holds_[entry] != 0; }
  std::size_t size() const { return size_; }
  // `old` is the contact of the last step that this one continues, or null.
  void push(const WallTouchNow& now, const WallSpring* old, const Body& body, double dt,
            std::uint32_t material);
  // Pads to whole vectors (overlap 0, no force, particle `idle`) and shows the lanes to a kernel.
  WallContacts view(Index idle);
  // Lane k as the kernel left it.
  WallSpring spring(std::size_t k) const;
  Index wall(std::size_t k) const { return wall_[k]; }
  Vec3 point(std::size_t k) const {  // m
    const double* const lane = numbers_.data() + kPoint * stride_ + k;
    return {lane[0], lane[stride_], lane[2 * stride_]};
  }
  Index facet(std::size_t k) const { return facet_[k]; }
  Index wear_cell(std::size_t k) const { return wear_cell_[k]; }
  // The spring that it goes on from, of those that were collected from, or null.
  const WallSpring* old(std::size_t k) const { return old_[k]; }
  // Memory for the episodes of a tile, whatever it holds.
  std::vector<Episode>& episodes() { return episodes_; }
  bool is_open(std::size_t k) const { return numbers_[3 * stride_ + k] > 0; }

 private:
  void reserve(std::size_t n);

  // kPoint rows of `stride_`, three of points, four of energies, kWearSums of wear
  std::vector<double> numbers_;
  std::vector<Index> particle_, wall_, feature_, facet_, wear_cell_;
  std::vector<const WallSpring*> old_;
  std::vector<Episode> episodes_;
  std::vector<std::uint32_t> material_;
  std::size_t size_ = 0, stride_ = 0;
  std::vector<double> center_[3];
  std::vector<std::uint8_t> holds_;
};

// `known` has one for each entry of the tile's candidates.
template <class Real>
void collect_wall_contacts(const World<Real>& world, std::size_t tile, std::span<KnownTouch> known,
                           WallLanes& lanes);

// `totals` has a row per wall and is added to.
void return_wall_contacts(const WallContacts& contacts, const WallLanes& lanes,
                          const std::vector<Wall>& walls, const std::vector<Body>& bodies,
                          TileWalls& tile, std::span<WallTotal> totals);

}  // namespace quern
