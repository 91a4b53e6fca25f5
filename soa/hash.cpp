#include "soa/hash.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstring>
#include <vector>

namespace quern {

namespace {

class Hasher {
 public:
  void add(std::uint64_t word) {
    state_ = (state_ ^ word) * 0x100000001b3u;
    state_ ^= state_ >> 29;
  }
  void add(double v) { add(std::bit_cast<std::uint64_t>(v)); }
  void add(float v) { add(std::uint64_t{std::bit_cast<std::uint32_t>(v)}); }
  void add(const Vec3& v) {
    for (int a = 0; a < 3; ++a) add(v[a]);
  }
  std::uint64_t result() const {
    std::uint64_t z = state_ * 0x9e3779b97f4a7c15u;
    return z ^ (z >> 32);
  }

 private:
  std::uint64_t state_ = 0xcbf29ce484222325u;
};

struct Key {
  std::uint64_t a, b;
  Index slot, tile;
  bool operator<(const Key& o) const { return a != o.a ? a < o.a : b < o.b; }
};

template <class Real>
void add_particles(const World<Real>& world, Hasher& h) {
  const Particles<Real>& p = world.particles;
  std::vector<Index> row(p.size());
  for (std::size_t k = 0; k < p.size(); ++k) row[p.id[k]] = static_cast<Index>(k);
  for (const Index k : row) {
    const Record<Real>& r = p.record[k];
    for (const double v : {r.x, r.y, r.z, r.vx, r.vy, r.vz}) h.add(v);
    for (const double v : {p.spin_x[k], p.spin_y[k], p.spin_z[k]}) h.add(v);
    for (const float v : {p.rest_x[k], p.rest_y[k], p.rest_z[k]}) h.add(v);
    h.add(r.radius);
    h.add(std::uint64_t{p.traits[k].tag});
  }
}

template <class Real>
void add_pairs(const World<Real>& world, Hasher& h) {
  const PairBatch<Real>& pairs = world.pairs;
  struct PairKey {  // identities: there are many
    Index i, j, slot;
  };
  std::vector<PairKey> keys;
  for (std::size_t tile = 0; tile < pairs.tiles(); ++tile) {
    pairs.for_each(tile, PairBatch<Real>::Part::kOwn, [&](std::size_t slot, Index i, Index j) {
      if (!pairs.is_open(slot)) return;
      keys.push_back({world.particles.id[i], world.particles.id[j], static_cast<Index>(slot)});
    });
  }
  std::sort(keys.begin(), keys.end(),
            [](const PairKey& a, const PairKey& b) { return a.i != b.i ? a.i < b.i : a.j < b.j; });
  for (const PairKey& key : keys) {
    h.add(std::uint64_t{key.i} << 32 | key.j);
    const std::size_t tile = pairs.tile_of(key.slot);
    for (std::size_t k = 0; k < pairs.law_history(); ++k) h.add(pairs.number(tile, key.slot, k));
  }
}

template <class Real>
void add_walls(const World<Real>& world, Hasher& h) {
  std::vector<Key> keys;
  for (std::size_t tile = 0; tile < world.tile_walls.size(); ++tile) {
    const std::vector<WallSpring>& springs = world.tile_walls[tile].springs;
    for (std::size_t k = 0; k < springs.size(); ++k) {
      const WallSpring& s = springs[k];
      keys.push_back({world.particles.id[s.particle], std::uint64_t{s.wall} << 32 | s.feature,
                      static_cast<Index>(k), static_cast<Index>(tile)});
    }
  }
  std::sort(keys.begin(), keys.end());
  for (const Key& key : keys) {
    const WallSpring& s = world.tile_walls[key.tile].springs[key.slot];
    h.add(key.a);
    h.add(key.b);
    for (const Vec3* v : {&s.spring, &s.force, &s.moment, &s.normal, &s.point}) h.add(*v);
    h.add(s.overlap);
  }
}

// A row that is saved as bytes, from byte `first` on.
template <class Row>
void add_words(const Row& row, std::size_t first, Hasher& h) {
  static_assert(sizeof(Row) % 8 == 0);
  std::uint64_t words[sizeof(Row) / 8];
  std::memcpy(words, static_cast<const void*>(&row), sizeof(Row));
  for (std::size_t k = first / 8; k < std::size(words); ++k) h.add(words[k]);
}

template <class Real>
void add_polyhedra(const Polyhedra<Real>& p, Hasher& h) {
  for (std::size_t k = 0; k < p.size(); ++k) {
    h.add(p.place(k));
    h.add(p.velocity(k));
    for (const double v : {p.qw[k], p.qx[k], p.qy[k], p.qz[k]}) h.add(v);
    h.add(p.momentum(k));
    h.add(p.scale[k]);
    h.add(std::uint64_t{p.shape[k]} << 32 | p.material[k]);
    h.add(std::uint64_t{p.contacts[k]});
  }
}

bool is_open(const PolyhedronPair& pair) {
  return pair.touching != 0 || pair.force != Vec3::Zero() || pair.spring != Vec3::Zero() ||
         pair.moment != Vec3::Zero();
}

template <class Real>
void add_polyhedron_pairs(const Polyhedra<Real>& p, Hasher& h) {
  std::vector<Key> keys;
  for (std::size_t k = 0; k < p.pairs.size(); ++k) {
    if (!is_open(p.pairs[k])) continue;
    keys.push_back({p.pairs[k].j, p.pairs[k].i, static_cast<Index>(k), 0});
  }
  std::sort(keys.begin(), keys.end());
  for (const Key& key : keys) {
    h.add(key.a << 32 | key.b);
    h.add(std::uint64_t{p.pairs[key.slot].touching});
    add_words(p.pairs[key.slot], offsetof(PolyhedronPair, spring), h);  // behind the cached axis
  }
}

template <class Real>
void add_polyhedron_walls(const Polyhedra<Real>& p, Hasher& h) {
  std::vector<Key> keys;
  for (std::size_t k = 0; k < p.walls.size(); ++k) {
    const WallSpring& s = p.walls[k];
    keys.push_back({s.particle, std::uint64_t{s.wall} << 32 | s.feature, static_cast<Index>(k), 0});
  }
  std::sort(keys.begin(), keys.end());
  for (const Key& key : keys) add_words(p.walls[key.slot], 0, h);
}

template <class Real>
void add_polyhedron_spheres(const World<Real>& world, Hasher& h) {
  const PolyhedronSphereBatch<Real>& batch = world.polyhedra.spheres;
  std::vector<Key> keys;
  for (std::size_t g = 0; g < batch.polyhedron.size(); ++g) {
    for (Index slot = batch.begin[g]; slot < batch.begin[g] + batch.count[g]; ++slot) {
      if (!batch.is_open(slot)) continue;
      keys.push_back({batch.polyhedron[g], world.particles.id[batch.sphere[slot]], slot, 0});
    }
  }
  std::sort(keys.begin(), keys.end());
  for (const Key& key : keys) {
    h.add(key.a << 32 | key.b);
    for (std::size_t k = 0; k < batch.kHistory; ++k) h.add(batch.number(key.slot, k));
  }
}

}  // namespace

template <class Real>
std::uint64_t state_hash(const World<Real>& world) {
  Hasher h;
  add_particles(world, h);
  add_pairs(world, h);
  add_walls(world, h);
  h.add(world.clock.step);
  h.add(world.clock.total_steps);
  for (const Body& body : world.bodies) {
    // Of this moment: the body's own pose is that of the last step, and not restored.
    const Pose pose = pose_at(body.motion, world.wall_time());
    for (int k = 0; k < 9; ++k) h.add(pose.rotation(k / 3, k % 3));
    h.add(pose.shift);
  }
  const Ledger& l = world.ledger;
  for (const double v : {l.kinetic, l.elastic, l.wall_work, l.gravity_work, l.contact_work, l.slide,
                         l.tangential_damping, l.numerical_loss}) {
    h.add(v);
  }
  if (world.shapes.empty()) return h.result();
  add_polyhedra(world.polyhedra, h);
  add_polyhedron_pairs(world.polyhedra, h);
  add_polyhedron_walls(world.polyhedra, h);
  add_polyhedron_spheres(world, h);
  h.add(l.model_work);
  return h.result();
}

template std::uint64_t state_hash(const World<float>&);
template std::uint64_t state_hash(const World<double>&);

}  // namespace quern
