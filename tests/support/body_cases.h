// Random contacts for the tests of the law kernels of polyhedra, with what their twins make of
// them: fresh, sticking, sliding and closing ones, away from the branch points of the law.
//
// Beside the lanes in use lie lanes of padding, filled as the engine fills them, and behind those
// lanes that nobody may touch.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "soa/polyhedra.h"
#include "tests/support/kernel_checks.h"

namespace quern::test {

// Three vectors of the widest target and one more.
inline constexpr std::size_t kMostBodyContacts = 3 * kShapePad + 1;
inline constexpr double kUntouched = -777;  // what lies behind the lanes

inline std::size_t padded(std::size_t count) {
  return (count + kShapePad - 1) / kShapePad * kShapePad;
}

// No rolling; law and polyhedra know no period.
inline std::vector<CaseOptions> body_options() {
  std::vector<CaseOptions> all;
  for (const CaseOptions& o : all_options()) {
    if (!o.rolling && !o.periodic) all.push_back(o);
  }
  return all;
}

// Away from what jumps at the law's branch points.
inline bool is_clear(const twin::Contact& c, const twin::Response& r) {
  return !c.touching || (r.fresh_margin > 1e-3 && r.slide_margin > 1e-3 &&
                         std::abs(c.overlap / c.least_radius() - 0.5) > 1e-3);
}

// What a contact is to be: depths, velocity of i from j at the contact point, history.
struct Wanted {
  Vec3 normal, normal_old, at_point;
  double overlap, overlap_old;
  twin::History history;
};
inline Wanted wanted_contact(const twin::Coefficients& law, double size, Random& random) {
  const TouchState state = static_cast<TouchState>(random.below(3));
  const bool fresh = state == TouchState::kFresh, lost = state == TouchState::kLost;
  Wanted w;
  const double depth = size * std::pow(10, fresh ? random(-6, -2) : random(-6, -0.2));
  w.normal = random.in_cube(1).normalized();
  w.normal_old = fresh ? Vec3(Vec3::Zero()) : Vec3((w.normal + random.in_cube(1e-3)).normalized());
  w.overlap = lost ? -depth * random(0, 1) : depth;
  w.overlap_old = fresh ? 0 : depth * random(0.5, 2);
  const double approach =
      fresh ? depth / kCaseStep * random(1.01, 4) : random(-10, 1) * 1e4 * depth;
  const Vec3 any = random.in_cube(0.5);
  w.at_point = any - (approach + any.dot(w.normal)) * w.normal;
  if (!fresh) {
    w.history =
        random_history(twin::at_overlap(law, depth, size), w.normal_old, depth, false, random);
  }
  return w;
}

// Spheres near polyhedra: about two contacts a sphere, the last sphere is the idle one of padding;
// kGroup contacts after another share a row of sums.
template <class Real>
struct NearCases {
  static constexpr Index kFirst = 2;  // the tile's first particle
  static constexpr std::size_t kGroup = 3;
  static constexpr std::size_t kHistory = PolyhedronSphereBatch<Real>::kHistoryStride;
  static constexpr std::size_t kSums = PolyhedronSphereBatch<Real>::kSums;

  CaseOptions options;
  RandomLaw<double> law;
  StepConstants<double> step;
  std::size_t count, all;
  Column<Record<Real>> record;
  Column<Traits<Real>> traits;
  std::vector<NearTouch> touch;
  std::vector<BodyState> body;
  Column<Real> history;  // kHistory a lane
  Column<double> sums;   // kSums a lane, of which the first of a group is used
  Column<Index> sphere;
  Column<std::uint32_t> material;
  std::vector<double> rock_radius;
  std::vector<const double*> motion;
  std::vector<Real*> history_of;
  std::vector<double*> sums_of;
  std::size_t odd = ~std::size_t{0};
  std::vector<twin::Contact> contact;
  std::vector<twin::Response> expected;
  double cap;

  NearCases(const CaseOptions& o, double overlap_cap, std::size_t contacts, unsigned seed)
      : options(o),
        law(o, seed),
        step(constants(o, law)),
        count(contacts),
        all(padded(contacts) + kShapePad),
        cap(overlap_cap) {
    Random random(seed);
    make_spheres(random);
    touch.resize(all);
    body.resize(all);
    history.reset(kHistory * all);
    sums.reset(kSums * all);
    sphere.reset(all);
    material.reset(all);
    rock_radius.assign(all, 1);
    history.fill(static_cast<Real>(kUntouched));
    sums.fill(kUntouched);
    sphere.fill(idle());
    material.fill(0);
    for (std::size_t k = 0; k < all; ++k) {
      const std::size_t group = k < count ? k / kGroup * kGroup : k;
      motion.push_back(body[k].motion());
      history_of.push_back(&history[k * kHistory]);
      sums_of.push_back(&sums[group * kSums]);
      if (k >= padded(count)) continue;
      std::fill_n(history_of[k], kHistory, Real(0));
      std::fill_n(sums_of[k], kSums, 0.0);
    }
    for (std::size_t k = 0; k < count; ++k) {
      do {
        make_contact(k, random);
      } while (!is_clear(contact.back(), expected.back()));
    }
  }
  Index spheres() const { return static_cast<Index>(count / 2 + 2); }
  Index idle() const { return kFirst + spheres() - 1; }
  ParticleView<Real> particles() const { return {record.data(), traits.data()}; }
  NearContacts<Real> view() {
    return {touch.data(),    sphere.data(),      motion.data(),
            material.data(), rock_radius.data(), history_of.data(),
            sums_of.data(),  padded(count),      cap,
            nullptr,         &odd};
  }
  Vec3 sum(std::size_t first, std::size_t k) const {
    return Eigen::Map<const Vec3>(sums_of[k] + first);
  }
  Vec3 stored(std::size_t h, std::size_t k) const {
    const Real* row = history_of[k] + h;
    return {static_cast<double>(row[0]), static_cast<double>(row[1]), static_cast<double>(row[2])};
  }

 private:
  void make_spheres(Random& random) {
    record.reset(kFirst + spheres());
    traits.reset(kFirst + spheres());
    for (std::size_t s = 0; s < record.size(); ++s) {
      const double radius = random(0.005, 0.01);
      const Vec3 x = random.in_cube(4), v = random.in_cube(5), w = random.in_cube(50);
      record[s] = record_of<Real>(x, v, w, radius);
      const double mass = random(1000, 8000) * 4.19 * radius * radius * radius;
      traits[s] = {static_cast<Real>(1 / mass),
                   make_tag(static_cast<std::uint32_t>(random.below(options.materials)),
                            static_cast<std::uint32_t>(random.below(12)))};
    }
  }

  void make_contact(std::size_t k, Random& random) {
    contact.resize(k);
    expected.resize(k);
    sphere[k] = static_cast<Index>(kFirst + random.below(spheres() - 1));
    material[k] = static_cast<std::uint32_t>(random.below(options.materials));
    const Record<Real>& r = record[sphere[k]];
    const twin::Coefficients law_here =
        twin::coefficients(step.law, tag_material(traits[sphere[k]].tag), material[k]);
    const double radius = static_cast<double>(r.radius);
    const Wanted w = wanted_contact(law_here, radius, random);
    const Vec3 point = random.in_cube(0.1), spin = random.in_cube(20);
    const Vec3 arm = -(radius - 0.5 * w.overlap) * w.normal;
    const Vec3 sphere_spin(r.wx, r.wy, r.wz);
    touch[k] = {{w.normal.x(), w.normal.y(), w.normal.z()},
                w.overlap,
                {point.x(), point.y(), point.z()},
                static_cast<double>(random.below(12))};
    body[k].spin = spin;
    body[k].velocity =
        Vec3(r.vx, r.vy, r.vz) + sphere_spin.cross(arm) - spin.cross(point) - w.at_point;
    body[k].inverse_mass = random(0.1, 10);
    body[k].mobility = random(10, 1e4);
    rock_radius[k] = random(0.004, 0.02);
    const Vec3 point_old =
        w.overlap_old > 0 ? Vec3(point + random.in_cube(1e-4)) : Vec3(Vec3::Zero());
    const Vec3 groups[4] = {w.history.spring, w.history.force, w.normal_old, point_old};
    for (std::size_t g = 0; g < 4; ++g) {
      for (std::size_t a = 0; a < 3; ++a) {
        history_of[k][3 * g + (g == 3 ? 1 : 0) + a] =
            static_cast<Real>(groups[g][static_cast<Eigen::Index>(a)]);
      }
    }
    history_of[k][9] = static_cast<Real>(w.overlap_old);
    contact.push_back(twin::sphere_polyhedron(particles(), view(), k, law_here));
    const twin::History old = {stored(0, k), stored(3, k), Vec3::Zero(), Vec3::Zero()};
    const double history_eps = sizeof(Real) == 4 ? kEps<float> : 0;
    expected.push_back(twin::respond(law_here, contact[k], old,
                                     {step.dt, options.clamped, false, kEps<double>, history_eps}));
  }
};

// Polyhedra among themselves and with walls: lanes as the narrow phase fills them.
struct BodyCases {
  using B = BodyContacts;
  CaseOptions options;
  RandomLaw<double> law;
  StepConstants<double> step;
  std::size_t count, stride;
  Column<double> numbers;
  Column<Index> law_row;
  std::vector<twin::Contact> contact;
  std::vector<twin::Response> expected;

  BodyCases(const CaseOptions& o, std::size_t contacts, unsigned seed)
      : options(o),
        law(o, seed),
        step(constants(o, law)),
        count(contacts),
        stride(padded(contacts) + kShapePad) {
    numbers.reset(B::kRows * stride);
    law_row.reset(stride);
    numbers.fill(kUntouched);
    law_row.fill(0);
    for (std::size_t k = count; k < padded(count); ++k) {
      for (int row = 0; row < B::kRows; ++row) view().row(row)[k] = 0;
      for (const int row : {B::kNormal, B::kNormalOld, B::kInverseMass, B::kTangentialInverse}) {
        view().row(row)[k] = 1;
      }
    }
    Random random(seed);
    for (std::size_t k = 0; k < count; ++k) {
      do {
        contact.resize(k);
        expected.resize(k);
        make_contact(k, random);
      } while (!is_clear(contact.back(), expected.back()));
    }
  }
  BodyContacts view() { return {numbers.data(), stride, law_row.data(), padded(count)}; }
  double number(int row, std::size_t k) { return view().row(row)[k]; }
  Vec3 vector(int row, std::size_t k) {
    return {number(row, k), number(row + 1, k), number(row + 2, k)};
  }

 private:
  void put(int row, std::size_t k, const Vec3& v) {
    for (int a = 0; a < 3; ++a) view().row(row + a)[k] = v[a];
  }
  static twin::Side body_side(Random& random) {
    twin::Side s;
    s.spin = random.in_cube(20);
    s.radius = 0.05;  // for depths
    s.inverse_mass = random(0.1, 10);
    s.contacts = static_cast<double>(random.below(12));
    s.lever = random.in_cube(0.1);
    s.lever_old = s.lever + random.in_cube(1e-4);
    s.turning = s.lever.squaredNorm() * random(10, 1e4);
    return s;
  }
  // Linear, capped, or any force and energy as of the volume model.
  static twin::NormalSpring normal_spring(const twin::Coefficients& law, const twin::Contact& c,
                                          Random& random) {
    const std::size_t kind = random.below(3);
    const double radius = c.reduced_radius(), size = twin::at_overlap(law, c.overlap, radius).kn;
    if (kind == 2) {
      return {size * c.overlap * random(0.1, 3), size * c.overlap * c.overlap * random(0.1, 3)};
    }
    return twin::capped_spring(law, c.overlap, radius, kind == 0 ? HUGE_VAL : 3e-5);
  }
  void make_contact(std::size_t k, Random& random) {
    twin::Contact c;
    c.i = body_side(random);
    c.j = body_side(random);
    if (random.below(3) == 0) {  // a wall
      c.j = twin::Side();
      c.j.spin = random.in_cube(3);
    } else {
      c.rock_radius = random(0.01, 0.05);
    }
    law_row[k] = static_cast<Index>(random.below(options.materials * options.materials));
    const twin::Coefficients here = twin::coefficients(step.law, law_row[k] / options.materials,
                                                       law_row[k] % options.materials);
    const Wanted w = wanted_contact(here, 0.05, random);
    c.normal = w.normal;
    c.overlap = std::max(0.0, w.overlap);
    c.touching = c.overlap > 0;
    c.normal_old = w.overlap_old > 0 ? w.normal_old : w.normal;
    c.overlap_old = w.overlap_old;
    c.velocity = w.at_point - c.i.spin.cross(c.i.lever) + c.j.spin.cross(c.j.lever);
    c.velocity_old = c.velocity + random.in_cube(1e-3);
    c.spring = normal_spring(here, c, random);
    contact.push_back(c);
    expected.push_back(
        twin::respond(here, c, w.history, {step.dt, options.clamped, false, kEps<double>}));
    fill_lane(k, w.history);
  }
  void fill_lane(std::size_t k, const twin::History& old) {
    const twin::Contact& c = contact[k];
    const auto at = [&](const Vec3& velocity, const Vec3& lever_i, const Vec3& lever_j) {
      return Vec3(velocity + c.i.spin.cross(lever_i) - c.j.spin.cross(lever_j));
    };
    const double turning_i = c.i.inverse_mass + c.i.turning;
    const double turning_j = c.j.inverse_mass + c.j.turning;
    put(B::kNormal, k, c.normal);
    put(B::kNormalOld, k, c.normal_old);
    put(B::kAtPoint, k, at(c.velocity, c.i.lever, c.j.lever));
    put(B::kAtOld, k, at(c.velocity_old, c.i.lever_old, c.j.lever_old));
    put(B::kSpinI, k, c.i.spin);
    put(B::kSpinJ, k, c.j.spin);
    put(B::kSpring, k, old.spring);
    put(B::kForce, k, old.force);
    const std::pair<int, double> single[] = {
        {B::kOverlap, c.overlap},
        {B::kOverlapOld, c.overlap_old},
        {B::kInverseMass, c.i.inverse_mass + c.j.inverse_mass},
        {B::kTangentialInverse, turning_i + turning_j},
        {B::kCountRate, c.i.contacts * c.i.inverse_mass + c.j.contacts * c.j.inverse_mass},
        {B::kTangentialCountRate, c.i.contacts * turning_i + c.j.contacts * turning_j},
        {B::kElasticForce, c.spring->force},
        {B::kStored, c.spring->stored},
        {B::kReducedRadius, c.reduced_radius()}};
    for (const auto& [row, value] : single) view().row(row)[k] = value;
  }
};

}  // namespace quern::test
