// Brute force over pairs and facets, and look-ups in the running lists by the identity of the pair.
#include "scheduler/check_lists.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>

#include "soa/facet_closest.h"

namespace quern {

namespace {

constexpr std::size_t kMostLines = 20;

std::uint64_t key_of(Index i, Index j) { return std::uint64_t{i} << 32 | j; }

struct ListedPair {
  Index i, j, slot;
};
using SlotOfPair = std::unordered_map<std::uint64_t, ListedPair>;

// Slots of one tile by pair; `own` or imported part.
struct TileSlots {
  SlotOfPair own, imported;
  bool repeats = false;
};

template <class Real>
std::vector<TileSlots> slots_of_tiles(const World<Real>& world) {
  const PairBatch<Real>& pairs = world.pairs;
  std::vector<TileSlots> tiles(world.tiles());
  for (std::size_t t = 0; t < tiles.size(); ++t) {
    for (const auto part : {PairBatch<Real>::Part::kOwn, PairBatch<Real>::Part::kImported}) {
      SlotOfPair& to = part == PairBatch<Real>::Part::kOwn ? tiles[t].own : tiles[t].imported;
      pairs.for_each(t, part, [&](std::size_t slot, Index i, Index j) {
        const ListedPair pair = {i, j, static_cast<Index>(slot)};
        if (!to.emplace(key_of(i, j), pair).second) tiles[t].repeats = true;
      });
    }
  }
  return tiles;
}

template <class Real>
std::string name_of_pair(const World<Real>& world, Index i, Index j) {
  return "particles " + std::to_string(world.particles.id[i]) + " and " +
         std::to_string(world.particles.id[j]);
}

// What is wrong with the listing of the touching pair (i, j); empty if nothing.
template <class Real>
std::string listing_fault(const World<Real>& world, const std::vector<TileSlots>& tiles, Index i,
                          Index j) {
  const std::size_t home = i / world.tile_size, other = j / world.tile_size;
  if (!tiles[home].own.contains(key_of(i, j))) return "not listed by the owner's tile";
  if (home != other && !tiles[other].imported.contains(key_of(i, j))) {
    return "not listed by the partner's tile";
  }
  return "";
}

// A particle or one of its periodic images.
struct Ball {
  double low_x;  // of the bounding box
  double x[3], radius;
  Index particle;
  bool image;
};

// Particles at their place in the domain, and an image beyond a periodic face for each that could
// reach across it.
template <class Real>
std::vector<Ball> balls_and_images(const World<Real>& world) {
  const Particles<Real>& p = world.particles;
  double reach = 0;
  for (std::size_t k = 0; k < p.size(); ++k) {
    reach = std::max(reach, 2 * static_cast<double>(p.record[k].radius));
  }
  std::vector<Ball> balls;
  for (std::size_t k = 0; k < p.size(); ++k) {
    const Record<Real>& r = p.record[k];
    Ball s{0, {r.x, r.y, r.z}, static_cast<double>(r.radius), static_cast<Index>(k), false};
    for (std::size_t a = 0; a < 3; ++a) {
      if (!world.periodic[a]) continue;
      const Eigen::Index e = static_cast<Eigen::Index>(a);
      const double length = world.high[e] - world.low[e];
      s.x[a] -= length * std::floor((s.x[a] - world.low[e]) / length);
    }
    balls.push_back(s);
  }
  for (std::size_t a = 0; a < 3; ++a) {
    if (!world.periodic[a]) continue;
    const Eigen::Index e = static_cast<Eigen::Index>(a);
    const std::size_t before = balls.size();
    for (std::size_t k = 0; k < before; ++k) {
      Ball s = balls[k];
      s.image = true;
      const double length = world.high[e] - world.low[e];
      if (s.x[a] - world.low[e] < reach) {
        s.x[a] += length;
        balls.push_back(s);
        s.x[a] -= length;
      }
      if (world.high[e] - s.x[a] < reach) {
        s.x[a] -= length;
        balls.push_back(s);
      }
    }
  }
  for (Ball& s : balls) s.low_x = s.x[0] - s.radius;
  return balls;
}

bool overlap(const Ball& a, const Ball& b) {
  double d2 = 0;
  for (int k = 0; k < 3; ++k) d2 += (a.x[k] - b.x[k]) * (a.x[k] - b.x[k]);
  // A touch within rounding of the positions is no contact that could be missed.
  const double reach = (a.radius + b.radius) * (1 - 1e-12);
  return d2 < reach * reach;
}

template <class Real>
void check_pairs(const World<Real>& world, std::vector<std::string>& faults) {
  const Particles<Real>& p = world.particles;
  const std::vector<TileSlots> tiles = slots_of_tiles(world);
  std::vector<Ball> balls = balls_and_images(world);
  std::sort(balls.begin(), balls.end(),
            [](const Ball& a, const Ball& b) { return a.low_x < b.low_x; });
  for (std::size_t a = 0; a < balls.size(); ++a) {
    const double high_x = balls[a].x[0] + balls[a].radius;
    for (std::size_t b = a + 1; b < balls.size() && balls[b].low_x < high_x; ++b) {
      if (balls[a].image && balls[b].image) continue;
      Index i = balls[a].particle, j = balls[b].particle;
      if (i == j || !overlap(balls[a], balls[b])) continue;
      const double ri = static_cast<double>(p.record[i].radius);
      const double rj = static_cast<double>(p.record[j].radius);
      if (ri > rj || (ri == rj && p.id[i] > p.id[j])) std::swap(i, j);
      const std::string fault = listing_fault(world, tiles, i, j);
      if (!fault.empty()) faults.push_back(name_of_pair(world, i, j) + " touch: " + fault);
    }
  }
}

// Facets of the candidates of every particle and body, ascending.
template <class Real>
std::vector<Index> candidates_of(const World<Real>& world, Index particle, Index body) {
  const WallCandidates& c = world.tile_walls[particle / world.tile_size].candidates;
  std::vector<Index> found;
  for (std::size_t e = 0; e < c.particle.size(); ++e) {
    if (c.particle[e] != particle || c.body[e] != body) continue;
    found.insert(found.end(), c.facet.begin() + c.first[e], c.facet.begin() + c.first[e + 1]);
  }
  std::sort(found.begin(), found.end());
  return found;
}

template <class Real>
void check_walls(const World<Real>& world, std::vector<std::string>& faults) {
  for (Index b = 0; b < world.bodies.size(); ++b) {
    const Body& body = world.bodies[b];
    const Pose pose = pose_at(body.motion, world.wall_time());
    std::vector<Vec3> middle;
    std::vector<double> size;  // of the facet about its middle
    for (const FacetRecord& f : body.facets.record) {
      middle.push_back((f.corner[0] + f.corner[1] + f.corner[2]) / 3);
      double most = 0;
      for (const Vec3& c : f.corner) most = std::max(most, (c - middle.back()).norm());
      size.push_back(most);
    }
    for (Index k = 0; k < world.particles.size(); ++k) {
      const Record<Real>& r = world.particles.record[k];
      const Vec3 x = pose.rotation.transpose() * (Vec3(r.x, r.y, r.z) - pose.shift);
      const double radius = static_cast<double>(r.radius) * (1 - 1e-12);
      std::vector<Index> listed;
      bool looked_up = false;
      for (Index f = 0; f < body.facets.record.size(); ++f) {
        const double far = radius + size[f];
        if ((middle[f] - x).squaredNorm() > far * far) continue;
        if (closest_on_facet(body.facets.record[f], x).distance2 >= radius * radius) continue;
        if (!looked_up) listed = candidates_of(world, k, b);
        looked_up = true;
        if (std::binary_search(listed.begin(), listed.end(), f)) continue;
        faults.push_back("particle " + std::to_string(world.particles.id[k]) + " touches facet " +
                         std::to_string(f) + " of wall '" +
                         world.walls[body.facets.record[f].wall].name + "': not a candidate");
      }
    }
  }
}

void shorten(std::vector<std::string>& faults) {
  if (faults.size() <= kMostLines) return;
  const std::size_t more = faults.size() - kMostLines;
  faults.resize(kMostLines);
  faults.push_back("and " + std::to_string(more) + " more");
}

}  // namespace

template <class Real>
std::vector<std::string> missed_contacts(const World<Real>& world) {
  std::vector<std::string> faults;
  if (world.clock.list_stale != 0) return faults;
  check_pairs(world, faults);
  check_walls(world, faults);
  const std::vector<std::string> more = missed_polyhedron_contacts(world);
  faults.insert(faults.end(), more.begin(), more.end());
  shorten(faults);
  return faults;
}

template <class Real>
std::vector<std::string> unequal_twins(const World<Real>& world) {
  std::vector<std::string> faults;
  if (world.clock.list_stale != 0) return faults;
  const PairBatch<Real>& pairs = world.pairs;
  const std::vector<TileSlots> tiles = slots_of_tiles(world);
  std::size_t cross = 0, imported = 0;
  for (std::size_t t = 0; t < tiles.size(); ++t) {
    if (tiles[t].repeats) faults.push_back("tile " + std::to_string(t) + " lists a pair twice");
    imported += tiles[t].imported.size();
    for (const auto& [key, pair] : tiles[t].own) {
      const auto& [i, j, slot] = pair;
      const std::size_t other = j / world.tile_size;
      if (other == t) continue;
      ++cross;
      const auto twin = tiles[other].imported.find(key);
      if (twin == tiles[other].imported.end()) {
        faults.push_back(name_of_pair(world, i, j) + ": no copy in the partner's tile");
        continue;
      }
      bool equal = true;
      for (std::size_t k = 0; k < pairs.law_history(); ++k) {
        equal = equal && pairs.number(t, slot, k) == pairs.number(other, twin->second.slot, k);
      }
      if (!equal) faults.push_back(name_of_pair(world, i, j) + ": the copies differ");
    }
  }
  if (cross != imported) faults.push_back("more imported copies than pairs between tiles");
  shorten(faults);
  return faults;
}

template <class Real>
Vec3 sum_of_pair_forces(const World<Real>& world) {
  const PairBatch<Real>& pairs = world.pairs;
  const std::vector<TileSlots> tiles = slots_of_tiles(world);
  Vec3 sum = Vec3::Zero();
  for (std::size_t t = 0; t < tiles.size(); ++t) {
    for (const auto& [key, pair] : tiles[t].own) {
      const std::size_t other = pair.j / world.tile_size;
      Index twin = pair.slot;
      if (other != t) {
        const auto found = tiles[other].imported.find(key);
        twin = found == tiles[other].imported.end() ? kNoIndex : found->second.slot;
      }
      for (std::size_t a = 0; a < 3; ++a) {
        const double on_i = static_cast<double>(pairs.number(t, pair.slot, 3 + a));
        const double on_j =
            twin == kNoIndex ? 0 : -static_cast<double>(pairs.number(other, twin, 3 + a));
        sum[static_cast<Eigen::Index>(a)] += on_i + on_j;
      }
    }
  }
  return sum;
}

template std::vector<std::string> missed_contacts(const World<float>&);
template std::vector<std::string> missed_contacts(const World<double>&);
template std::vector<std::string> unequal_twins(const World<float>&);
template std::vector<std::string> unequal_twins(const World<double>&);
template Vec3 sum_of_pair_forces(const World<float>&);
template Vec3 sum_of_pair_forces(const World<double>&);

}  // namespace quern
