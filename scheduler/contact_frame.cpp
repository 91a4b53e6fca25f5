#include "scheduler/contact_frame.h"

#include <algorithm>
#include <cmath>

#include "kernels/polyhedron_contacts.h"
#include "scheduler/snapshot.h"

namespace quern {

namespace {

enum class Partner : std::uint8_t { kParticle, kWall };

struct Contact {
  Vec3 point, force, normal;
  double overlap = 0;
  Index first = 0, second = 0;
  Partner partner = Partner::kParticle;
  std::size_t kind = 0;

  bool operator<(const Contact& o) const {
    if (first != o.first) return first < o.first;
    if (partner != o.partner) return partner < o.partner;
    return second < o.second;
  }
};

// Contacts of one World, as they are found.
template <class Real>
class Finder {
 public:
  explicit Finder(const World<Real>& world)
      : world_(world), particles_(world.particles), bodies_(world.polyhedra) {}

  std::vector<Contact> all() {
    find_sphere_pairs();
    find_sphere_walls();
    if (!bodies_.empty()) {
      find_body_pairs();
      find_body_walls();
      find_near_spheres();
    }
    // A body may touch a wall at several features: those stay in the order that they are kept in.
    std::stable_sort(found_.begin(), found_.end());
    return std::move(found_);
  }

 private:
  // Before the last move.
  Vec3 place(Index sphere) const {
    const Record<Real>& r = particles_.record[sphere];
    const double dt = world_.clock.dt;
    return {r.x - dt * r.vx, r.y - dt * r.vy, r.z - dt * r.vz};
  }
  Vec3 place_of_body(Index body) const {
    return bodies_.place(body) - world_.clock.dt * bodies_.velocity(body);
  }
  std::size_t group(Index sphere) const { return tag_group(particles_.traits[sphere].tag); }
  std::size_t group_of_body(Index body) const {
    return world_.groups.of_species(bodies_.species[body]);
  }
  Index id_of_body(Index body) const { return bodies_.first_id + body; }
  void add(Contact contact, std::size_t group_i, std::size_t group_j) {
    contact.point = wrapped(world_, contact.point);
    contact.kind = world_.groups.kind(group_i, group_j);
    found_.push_back(contact);
  }

  void find_sphere_pairs() {
    const PairBatch<Real>& pairs = world_.pairs;
    for (std::size_t tile = 0; tile < pairs.tiles(); ++tile) {
      pairs.for_each(tile, PairBatch<Real>::Part::kOwn, [&](std::size_t slot, Index i, Index j) {
        if (!pairs.is_open(slot)) return;
        const auto number = [&](std::size_t k) {
          return static_cast<double>(pairs.number(tile, slot, k));
        };
        const Vec3 force(number(3), number(4), number(5));
        // Some of those kept in `single` are next to touching.
        if (world_.precision == Precision::kSingle && force.isZero(0)) return;
        add_sphere_pair(i, j, force);
      });
    }
  }
  // Overlap as in kernels/pairs/sphere_sphere-inl.h; the force acts in the middle of it.
  void add_sphere_pair(Index i, Index j, const Vec3& force) {
    const double radius_i = static_cast<double>(particles_.record[i].radius);
    const double radius_j = static_cast<double>(particles_.record[j].radius);
    const Vec3 place_j = place(j), between = separation(world_, Vec3(place(i) - place_j));
    const double reach = radius_i + radius_j, d2 = between.squaredNorm(), d = std::sqrt(d2);
    Contact c;
    c.force = force;
    c.normal = between / std::max(d, 1e-25);
    c.overlap = std::max(0.0, (reach * reach - d2) / (reach + d));
    c.point = place_j + (radius_j - 0.5 * c.overlap) * c.normal;
    c.first = particles_.id[i];
    c.second = particles_.id[j];
    add(c, group(i), group(j));
  }

  void find_sphere_walls() {
    for (const TileWalls& tile : world_.tile_walls) {
      for (const WallSpring& spring : tile.springs) {
        add_wall(spring, particles_.id[spring.particle], group(spring.particle));
      }
    }
  }
  void find_body_walls() {
    for (const PolyhedronWall& wall : bodies_.walls) {
      add_wall(wall, id_of_body(wall.particle), group_of_body(wall.particle));
    }
  }
  void add_wall(const WallSpring& spring, Index first, std::size_t group_i) {
    Contact c;
    c.point = spring.point;
    c.force = spring.force;
    c.normal = spring.normal;
    c.overlap = spring.overlap;
    c.first = first;
    c.second = spring.wall;
    c.partner = Partner::kWall;
    add(c, group_i, world_.walls[spring.wall].group);
  }

  void find_body_pairs() {
    for (const PolyhedronPair& pair : bodies_.pairs) {
      if (pair.touching == 0) continue;
      Contact c;
      c.point = place_of_body(pair.j) + pair.arm_j;
      c.force = pair.force;
      c.normal = pair.normal;
      c.overlap = pair.overlap;
      c.first = id_of_body(pair.i);
      c.second = id_of_body(pair.j);
      add(c, group_of_body(pair.i), group_of_body(pair.j));
    }
  }

  void find_near_spheres() {
    using Batch = PolyhedronSphereBatch<Real>;
    const Batch& near = bodies_.spheres;
    for (std::size_t g = 0; g < near.polyhedron.size(); ++g) {
      const Index body = near.polyhedron[g];
      for (Index slot = near.begin[g]; slot < near.begin[g] + near.count[g]; ++slot) {
        if (near.number(slot, Batch::kOverlap) > 0) add_near_sphere(slot, body);
      }
    }
  }
  void add_near_sphere(Index slot, Index body) {
    const PolyhedronSphereBatch<Real>& near = bodies_.spheres;
    const auto vector = [&](std::size_t k) {
      return Vec3(static_cast<double>(near.number(slot, k)),
                  static_cast<double>(near.number(slot, k + 1)),
                  static_cast<double>(near.number(slot, k + 2)));
    };
    const Index sphere = near.sphere[slot];
    Contact c;
    c.force = vector(3);
    c.normal = vector(6);
    c.overlap = static_cast<double>(near.number(slot, near.kOverlap));
    c.point = place_of_body(body) + vector(10);
    c.first = particles_.id[sphere];
    c.second = id_of_body(body);
    add(c, group(sphere), group_of_body(body));
  }

  const World<Real>& world_;
  const Particles<Real>& particles_;
  const Polyhedra<Real>& bodies_;
  std::vector<Contact> found_;
};

void append(const Vec3& v, std::vector<float>& to) {
  for (Eigen::Index a = 0; a < 3; ++a) to.push_back(static_cast<float>(v[a]));
}

void append(const Contact& c, ContactFrame& f) {
  for (Eigen::Index a = 0; a < 3; ++a) f.point.push_back(c.point[a]);
  append(c.force, f.force);
  append(c.normal, f.normal);
  f.overlap.push_back(static_cast<float>(c.overlap));
  const double along = c.force.dot(c.normal);
  f.normal_force.push_back(static_cast<float>(along));
  f.tangential_force.push_back(static_cast<float>((c.force - along * c.normal).norm()));
  f.first.push_back(c.first);
  f.second.push_back(c.second);
  f.wall.push_back(c.partner == Partner::kWall ? 1 : 0);
  f.kind.push_back(static_cast<std::uint16_t>(c.kind));
}

}  // namespace

template <class Real>
ContactFrame contact_frame(const World<Real>& world) {
  ContactFrame frame;
  for (const Contact& contact : Finder<Real>(world).all()) append(contact, frame);
  return frame;
}

template ContactFrame contact_frame(const World<float>&);
template ContactFrame contact_frame(const World<double>&);

}  // namespace quern
