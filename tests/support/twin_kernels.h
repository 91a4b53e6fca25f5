// Twins: every SIMD kernel once more as plain scalar f64 code, the oracle of the kernel tests.
//
// Written from the equations (kernels/README.md: the implicit damping, friction with history,
// rolling, the ledger), with masses and moments of inertia where the kernels use their inverses,
// and a rotation matrix where they use a short cut. Beside each result stands its scale: what an
// error of one unit in the last place of every intermediate result may amount to, so that a test
// says |kernel - twin| <= n * scale. `eps` is the spacing of the precision under test; positions
// are f64 in every precision, hence the second term of `force_error`.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "kernels/body_contacts.h"

namespace quern::twin {

struct Coefficients {
  double kn, kt, normal_damping, tangential_damping, mu, mur;
  ForceLaw law = ForceLaw::kLinearSpringDashpot;
  bool hertz() const { return law == ForceLaw::kHertzMindlin; }
  // What the normal spring stores over its force times the overlap.
  double share() const { return hertz() ? 0.4 : 0.5; }
};

// Stiffnesses and dashpots at an overlap: those of Hertz and Mindlin go as the radius of the
// contact and as its root.
inline Coefficients at_overlap(Coefficients k, double overlap, double reduced_radius) {
  if (!k.hertz()) return k;
  const double a = std::sqrt(reduced_radius * std::max(0.0, overlap));
  k.kn *= a;
  k.kt *= a;
  k.normal_damping *= std::sqrt(a);
  k.tangential_damping *= std::sqrt(a);
  return k;
}

template <class Real>
Coefficients coefficients(const LawTable<Real>& law, Index a, Index b) {
  const std::size_t row = a * law.materials + b;
  return {law.normal_stiffness[row],
          law.tangential_stiffness[row],
          law.normal_damping[row],
          law.tangential_damping[row],
          law.sliding_friction[row],
          law.rolling_friction[row],
          law.kind};
}

// One side of a contact. A wall has no mass (inverse_mass 0), no lever and an infinite radius.
struct Side {
  Vec3 spin = Vec3::Zero();
  double inverse_mass = 0, radius = HUGE_VAL, contacts = 0;
  // r^2/I: what the lever adds to the mobility of the contact point. Spheres: over the whole
  // radius, I = 2/5 m r^2; polyhedra: lever^2 over the least principal moment.
  double turning = 0;
  Vec3 lever = Vec3::Zero(), lever_old = Vec3::Zero();  // centre to contact point; a step ago
  double inverse_inertia() const { return 2.5 * inverse_mass / (radius * radius); }
};

// A normal spring that is not kn times the overlap: capped, or of the volume model.
struct NormalSpring {
  double force = 0, stored = 0;  // N, J, at full stiffness
};
inline NormalSpring capped_spring(const Coefficients& k, double overlap, double reduced_radius,
                                  double cap) {
  const double depth = std::min(overlap, cap);
  const double force = at_overlap(k, depth, reduced_radius).kn * depth;
  return {force, k.share() * force * depth + force * (overlap - depth)};
}

struct Contact {
  Side i, j;
  Vec3 normal = Vec3::UnitX(), normal_old = Vec3::UnitX();
  Vec3 velocity = Vec3::Zero();      // of centre i - centre j (wall: contact point)
  Vec3 velocity_old = Vec3::Zero();  // the same, where the contact point of a wall was a step ago
  double overlap = 0, overlap_old = 0;
  std::optional<NormalSpring> spring;  // none: kn times the overlap
  double extent = 0;                   // m, lengths whose f64 rounding enters the overlap
  double rock_radius = HUGE_VAL;       // m, of j, where it is a polyhedron
  bool touching = false;
  // Overlaps are judged by it; of two spheres i is the smaller.
  double least_radius() const { return std::min(i.radius, rock_radius); }
  double reduced_radius() const { return 1 / (1 / i.radius + 1 / std::min(j.radius, rock_radius)); }
};

struct History {
  Vec3 spring = Vec3::Zero(), force = Vec3::Zero(), rest = Vec3::Zero(), moment = Vec3::Zero();
};

struct Options {
  double dt = 0;
  bool clamped = true, rolling = false;
  double eps = 0;
  double history_eps = 0;  // the spacing of stored springs and normals, where it is another
  double overlap_cap = 0;  // m, of spheres and walls, whose contacts have no `spring`; 0: none
};

struct Response {
  Vec3 force = Vec3::Zero(), tangential = Vec3::Zero(), moment = Vec3::Zero();
  Vec3 spring = Vec3::Zero(), torque_i = Vec3::Zero(), torque_j = Vec3::Zero();
  double work = 0, elastic = 0, slide = 0, tangential_damping = 0, numerical_loss = 0;
  double model_work = 0;
  double reduction = 1;  // kn' / kn
  // Scales of the errors of the above.
  double force_error = 0, moment_error = 0, spring_error = 0, torque_error = 0;
  double work_error = 0, elastic_error = 0, slide_error = 0, damping_error = 0, loss_error = 0;
  double model_error = 0;
  bool fresh = false, slides = false;
  double fresh_margin = 1, slide_margin = 1;  // relative distance from the branch points
};

// The rotation that takes unit vector a to unit vector b the short way.
inline Mat3 rotation_between(const Vec3& a, const Vec3& b) {
  const Vec3 k = a.cross(b);
  Mat3 turn;
  turn << 0, -k.z(), k.y(), k.z(), 0, -k.x(), -k.y(), k.x(), 0;
  return Mat3::Identity() + turn + turn * turn / (1 + a.dot(b));
}

// What the pieces of the law share.
struct Terms {
  double kn, kt, cn, ct;  // as they act
  double reduction;       // kn over what it is without damping
  double kt_old = 0;      // a step ago, likewise
  bool damped = false;    // along the surface
  Vec3 slip, slip_old;    // velocity of the contact point, tangential and (old) whole
  Vec3 at_point;
  double vn, speed;              // speed: bound of all velocities at the contact
  double elastic_force, stored;  // of the normal spring, as it acts
};

inline Terms terms(const Coefficients& k, const Contact& c, double dt) {
  const double m_e = 1 / (c.i.inverse_mass + c.j.inverse_mass);
  const double m_t = 1 / (1 / m_e + c.i.turning + c.j.turning);
  const double cn = k.normal_damping * std::sqrt(m_e);
  // The table holds 2 zeta sqrt(2/7 kt), for spheres, whose m_t is 2/7 m_e.
  const double ct = k.tangential_damping * std::sqrt(3.5 * m_t);
  const double load_n = c.i.contacts * c.i.inverse_mass + c.j.contacts * c.j.inverse_mass;
  const double load_t = c.i.contacts * (c.i.inverse_mass + c.i.turning) +
                        c.j.contacts * (c.j.inverse_mass + c.j.turning);
  Terms t;
  t.reduction = 1 / (1 + dt * cn / (2 * m_e));
  t.kn = k.kn * t.reduction;
  t.kt = k.kt / (1 + dt * ct / (2 * m_t));
  t.cn = cn / (1 + 0.5 * dt * cn / m_e * std::max(1.0, m_e * load_n));
  t.ct = ct / (1 + 0.5 * dt * ct / m_t * std::max(1.0, m_t * load_t));
  const Vec3& n = c.normal;
  t.at_point = c.velocity + c.i.spin.cross(c.i.lever) - c.j.spin.cross(c.j.lever);
  t.slip = t.at_point - n.dot(t.at_point) * n;
  t.slip_old = c.velocity_old + c.i.spin.cross(c.i.lever_old) - c.j.spin.cross(c.j.lever_old);
  t.vn = n.dot(t.at_point);
  t.speed =
      c.velocity.norm() + c.i.lever.norm() * c.i.spin.norm() + c.j.lever.norm() * c.j.spin.norm();
  const NormalSpring plain = {k.kn * c.overlap, k.share() * k.kn * c.overlap * c.overlap};
  t.elastic_force = t.reduction * c.spring.value_or(plain).force;
  t.stored = t.reduction * c.spring.value_or(plain).stored;
  return t;
}

inline double normal_force(const Contact& c, const Options& o, const Terms& t, Response& r) {
  if (!c.touching) return 0;
  const double closing = -t.vn * o.dt;
  r.fresh = t.vn < 0 && c.overlap < closing;
  r.fresh_margin = std::abs(c.overlap - closing) / (c.overlap + std::abs(closing));
  const double weight = o.clamped && r.fresh ? 0.5 + c.overlap / closing : 1;
  const double force = t.elastic_force - weight * t.cn * t.vn;
  return o.clamped ? std::max(0.0, force) : force;
}

inline void friction(const Coefficients& k, const Contact& c, const History& old, const Options& o,
                     const Terms& t, double fn, Response& r, Vec3& spring_old, Vec3& spring_trial) {
  spring_old = spring_trial = Vec3::Zero();
  if (!c.touching) return;
  const Vec3& n = c.normal;
  const Vec3 carried = rotation_between(c.normal_old, n) * old.spring;
  const double theta = 0.5 * o.dt * (c.i.spin + c.j.spin).dot(n);
  spring_old = carried * (1 - 0.5 * theta * theta) + theta * n.cross(carried);
  spring_trial = spring_old + old.rest + o.dt * t.slip;
  const Vec3 trial = -t.kt * spring_trial - t.ct * t.slip;
  const double cap = k.mu * std::abs(fn), size = trial.norm();
  r.slides = size > cap;
  r.slide_margin = std::abs(size - cap) / std::max(size + cap, 1e-300);
  r.tangential = trial;
  r.spring = spring_trial;
  if (!r.slides) return;
  r.tangential = trial * (cap / size);
  const double held = t.kt * spring_trial.norm();
  if (held > cap) r.spring = spring_trial * (cap / held);
}

inline Vec3 rolling_moment(const Coefficients& k, const Contact& c, const Options& o, double fn) {
  const Vec3 spin = c.i.spin - c.j.spin;
  const Vec3 roll = spin - spin.dot(c.normal) * c.normal;
  const double rate = roll.norm();
  if (!c.touching || !o.rolling || rate == 0) return Vec3::Zero();
  const double curvature = 1 / c.i.radius + 1 / c.j.radius;  // 1/R*
  const double inertia = 1 / (c.i.inverse_inertia() + c.j.inverse_inertia());
  const double stop = inertia * rate / (o.dt * std::max(2.0, c.i.contacts + c.j.contacts));
  return -roll / rate * std::min(k.mur / curvature * std::max(fn, 0.0), stop);
}

// Work of the contact over the last step and where it went. The numerical loss is that of a linear
// spring, whatever the spring is.
inline void ledger(const Coefficients& k, const Contact& c, const History& old, const Options& o,
                   const Terms& t, const Vec3& spring_old, const Vec3& spring_trial, Response& r) {
  const Vec3 spin = c.i.spin - c.j.spin;
  r.work = 0.5 * o.dt * (old.force.dot(t.slip_old) + r.force.dot(t.at_point));
  if (o.rolling) r.work += 0.5 * o.dt * (old.moment + r.moment).dot(spin);
  const double fn_old = old.force.dot(c.normal_old);
  Vec3 dashpot = old.force - fn_old * c.normal_old + t.kt_old * old.spring;
  // Trapezoid of the spring's work less what it stores.
  const double half_way = 0.5 * o.dt * t.vn;
  if (c.touching) {
    r.elastic = t.stored + 0.5 * t.kt * r.spring.squaredNorm();
    r.slide = 0.5 * (t.kt_old * spring_old + t.kt * r.spring).dot(spring_trial - r.spring);
    r.model_work = 0.5 * (t.kt - t.kt_old) * spring_old.dot(r.spring);
    dashpot += r.tangential + t.kt * r.spring;
    if (r.fresh) r.numerical_loss = -t.kn * c.overlap * (half_way + k.share() * c.overlap);
  } else {
    r.slide = 0.5 * t.kt_old * old.spring.squaredNorm();
    if (fn_old > 0) {
      r.numerical_loss = t.kn * c.overlap_old * (k.share() * c.overlap_old - half_way);
    }
  }
  // Without a dashpot the spring carries all of the force; random histories need not say so.
  r.tangential_damping = t.damped ? -0.5 * o.dt * dashpot.dot(t.slip) : 0;
}

// An upper bound of what one unit in the last place of each intermediate result can do.
// What rounding of an overlap makes of stiffnesses: share of the ones of now, kn and kt (N/m) of a
// step ago.
struct StiffnessErrors {
  double share = 0, kn_old = 0, kt_old = 0;
};
inline StiffnessErrors stiffness_errors(const Coefficients& table, const Contact& c,
                                        const Options& o, const Terms& t, double slack) {
  StiffnessErrors e;
  if (!table.hertz()) return e;
  if (c.touching) e.share = slack / c.overlap;
  const double before = std::max(0.0, c.overlap_old), off = o.eps * o.dt * t.speed + slack;
  const double grown =
      std::sqrt(c.reduced_radius()) * (std::sqrt(before + off) - std::sqrt(before));
  e.kn_old = table.kn * grown + o.eps * at_overlap(table, before, c.reduced_radius()).kn;
  e.kt_old = table.kt * grown + o.eps * t.kt_old;
  return e;
}

inline void set_errors(const Coefficients& table, const Coefficients& k, const Contact& c,
                       const History& old, const Options& o, const Terms& t, Response& r) {
  const double slack = 0x1p-52 * c.extent;  // of the overlap, from f64 positions
  const StiffnessErrors grown = stiffness_errors(table, c, o, t, slack);
  const double spring = old.spring.norm() + o.dt * t.speed;
  const double reach = std::abs(c.overlap) + o.dt * t.speed;
  const double size = std::max(t.kn * std::abs(c.overlap), std::abs(t.elastic_force)) +
                      1.5 * t.cn * t.speed + t.kt * spring + t.ct * t.speed;
  const double carried = o.history_eps * old.spring.norm();
  const double before = old.force.norm();
  const Vec3 spin = c.i.spin - c.j.spin;
  const double spins = c.i.spin.norm() + c.j.spin.norm();
  const double roll = (spin - spin.dot(c.normal) * c.normal).norm();
  const double rolling_radius = 1 / (1 / c.i.radius + 1 / c.j.radius);
  r.force_error = (1 + k.mu) * ((o.eps + grown.share) * size + t.kn * slack + t.kt * carried);
  r.spring_error = o.eps * spring + carried + (t.kt > 0 ? k.mu / t.kt * r.force_error : 0);
  r.moment_error = k.mur * rolling_radius * r.force_error +
                   o.eps * r.moment.norm() * (1 + spins / std::max(roll, 1e-300));
  const double arm = std::max(c.i.lever.norm(), c.j.lever.norm());
  r.torque_error = arm * (r.force_error + o.eps * size) + r.moment_error;
  r.work_error = o.dt * (t.speed * (r.force_error + o.eps * (size + before)) +
                         spins * (r.moment_error + o.eps * (r.moment + old.moment).norm()));
  const double pressed = t.kn * std::abs(c.overlap) * (o.eps * std::abs(c.overlap) + slack);
  r.elastic_error =
      std::max(pressed, o.eps * t.stored) + t.kt * spring * (r.spring_error + o.eps * spring);
  const double stiffest = std::max(t.kt, t.kt_old);
  const double old_spring = grown.kt_old * spring;
  r.slide_error =
      spring * (stiffest * (r.spring_error + (o.eps + grown.share) * spring) + old_spring);
  if (table.hertz()) r.model_error = r.slide_error;
  r.damping_error =
      o.dt * t.speed *
      (r.force_error + stiffest * r.spring_error + o.eps * (size + before) + old_spring);
  const double deep = std::max(reach, std::abs(c.overlap_old));
  r.loss_error = deep * (t.kn * (o.eps * deep + slack) + grown.kn_old * deep);
}

// `table` is of the pair of materials. What is lost gives back what it was a step ago.
inline Response respond(const Coefficients& table, Contact c, const History& old,
                        const Options& o) {
  Response r;
  const double reduced = c.reduced_radius(), cap = o.overlap_cap > 0 ? o.overlap_cap : HUGE_VAL;
  const Coefficients k_old = at_overlap(table, std::min(c.overlap_old, cap), reduced);
  const Coefficients k = c.touching ? at_overlap(table, std::min(c.overlap, cap), reduced) : k_old;
  if (o.overlap_cap > 0) c.spring = capped_spring(table, c.overlap, reduced, cap);
  Terms t = terms(k, c, o.dt);
  t.kt_old = terms(k_old, c, o.dt).kt;
  t.damped = table.tangential_damping > 0;
  r.reduction = t.reduction;
  const double fn = normal_force(c, o, t, r);
  Vec3 spring_old, spring_trial;
  friction(k, c, old, o, t, fn, r, spring_old, spring_trial);
  r.force = fn * c.normal + r.tangential;
  r.moment = rolling_moment(k, c, o, fn);
  r.torque_i = c.i.lever.cross(r.force) + r.moment;
  r.torque_j = c.j.lever.cross(-r.force) - r.moment;
  ledger(k, c, old, o, t, spring_old, spring_trial, r);
  set_errors(table, k, c, old, o, t, r);
  return r;
}

// A sphere; `outward` is the normal of the contact on its side, from its centre.
template <class Real>
Side side_of(const ParticleView<Real>& p, Index at, const Contact& c, double outward) {
  Side s;
  const Record<Real>& r = p.record[at];
  s.spin = {static_cast<double>(r.wx), static_cast<double>(r.wy), static_cast<double>(r.wz)};
  s.inverse_mass = static_cast<double>(p.traits[at].inverse_mass);
  s.radius = static_cast<double>(r.radius);
  s.contacts = tag_contacts(p.traits[at].tag);
  s.turning = 2.5 * s.inverse_mass;
  s.lever = outward * (s.radius - 0.5 * c.overlap) * c.normal;
  s.lever_old = outward * (s.radius - 0.5 * c.overlap_old) * c.normal_old;
  return s;
}

// The contact of spheres i and j, nearest image.
template <class Real>
Contact sphere_sphere(const StepConstants<Real>& step, const ParticleView<Real>& p, Index i,
                      Index j) {
  const Record<Real>&a = p.record[i], &b = p.record[j];
  Vec3 dx(a.x - b.x, a.y - b.y, a.z - b.z);
  Contact c;
  const double reach = static_cast<double>(a.radius) + static_cast<double>(b.radius);
  c.extent = reach;
  for (Eigen::Index k = 0; k < 3; ++k) {
    if (step.period[k] > 0) {
      dx[k] = std::remainder(dx[k], step.period[k]);
      c.extent += step.period[k];
    }
  }
  c.velocity = Vec3(a.vx - b.vx, a.vy - b.vy, a.vz - b.vz);
  c.velocity_old = c.velocity;
  const Vec3 dx_old = dx - step.dt * c.velocity;
  c.normal = dx.normalized();
  c.normal_old = dx_old.normalized();
  c.overlap = reach - dx.norm();
  c.overlap_old = reach - dx_old.norm();
  c.touching = c.overlap > 0;
  c.i = side_of(p, i, c, -1);
  c.j = side_of(p, j, c, 1);
  return c;
}

// Lane k of the wall contacts. The particle is i, the wall has the velocity of the contact point.
template <class Real>
Contact sphere_facet(const ParticleView<Real>& p, const WallContacts& walls, std::size_t k) {
  const auto row = [&](int from) {
    return Vec3(walls.geometry[from][k], walls.geometry[from + 1][k], walls.geometry[from + 2][k]);
  };
  const Record<Real>& a = p.record[walls.particle[k]];
  Contact c;
  c.normal = row(0);
  c.overlap = walls.geometry[3][k];
  c.normal_old = row(4);
  c.overlap_old = walls.geometry[7][k];
  c.velocity = Vec3(a.vx, a.vy, a.vz) - row(8);
  c.velocity_old = Vec3(a.vx, a.vy, a.vz) - row(14);
  c.touching = c.overlap > 0;
  c.i = side_of(p, walls.particle[k], c, -1);
  c.j.spin = row(11);
  return c;
}

// Lane k of the contacts of spheres (i) with polyhedra (j); the law is for the capped spring.
template <class Real>
Contact sphere_polyhedron(const ParticleView<Real>& p, const NearContacts<Real>& near,
                          std::size_t k, const Coefficients& law) {
  const NearTouch& found = near.touch[k];
  const auto motion = [&](int first) {
    return Vec3(Eigen::Map<const Vec3>(near.motion[k] + first));
  };
  const auto old = [&](std::size_t h) { return static_cast<double>(near.history[k][h]); };
  const Record<Real>& a = p.record[near.sphere[k]];
  Contact c;
  c.normal = Eigen::Map<const Vec3>(found.normal);
  c.overlap = found.overlap;
  c.normal_old = {old(6), old(7), old(8)};
  c.overlap_old = old(9);
  c.velocity = c.velocity_old = Vec3(a.vx, a.vy, a.vz) - motion(0);
  c.touching = c.overlap > 0;
  c.i = side_of(p, near.sphere[k], c, -1);
  c.j.spin = motion(3);
  c.j.inverse_mass = near.motion[k][6];
  c.j.contacts = found.body_contacts;
  c.j.lever = Eigen::Map<const Vec3>(found.point);
  c.j.lever_old = {old(10), old(11), old(12)};
  c.j.turning = c.j.lever.squaredNorm() * near.motion[k][7];
  c.rock_radius = near.radius[k];
  if (near.overlap_cap > 0) {
    c.spring = capped_spring(law, c.overlap, c.reduced_radius(), near.overlap_cap);
  }
  return c;
}

// One particle moved by a step; `sums` is its accumulator row.
struct Moved {
  Vec3 place, velocity, spin;
  double translational, rotational, drag_loss, deviation2;
};

template <class Real>
Moved move_sphere(const MoveView<Real>& m, std::size_t k, const double* sums, double dt) {
  const Record<Real>& r = m.now[k];
  const double mass = 1 / static_cast<double>(m.traits_now[k].inverse_mass);
  const double radius = static_cast<double>(r.radius), inertia = 0.4 * mass * radius * radius;
  const Vec3 x(r.x, r.y, r.z), v(r.vx, r.vy, r.vz);
  const Vec3 w(m.spin[0][k], m.spin[1][k], m.spin[2][k]);
  const Vec3 force(sums[0], sums[1], sums[2]), torque(sums[3], sums[4], sums[5]);
  const Vec3 gravity(m.gravity[0], m.gravity[1], m.gravity[2]);
  const Vec3 kicked = v + m.kick * (force / mass + gravity);
  Moved out;
  out.velocity = m.drag * kicked;
  const Vec3 rest = Eigen::Vector3f(m.rest[0][k], m.rest[1][k], m.rest[2][k]).cast<double>();
  out.place = x + (rest + dt * out.velocity);
  const Vec3 spin_kicked = w + m.kick * torque / inertia;
  out.spin = m.drag * spin_kicked;
  out.translational = 0.5 * mass * v.dot(kicked);
  out.rotational = 0.5 * inertia * w.dot(spin_kicked);
  out.drag_loss = 0.5 * mass * (kicked.squaredNorm() - out.velocity.squaredNorm()) +
                  0.5 * inertia * (spin_kicked.squaredNorm() - out.spin.squaredNorm());
  Vec3 line;
  for (int a = 0; a < 3; ++a) {
    line[a] = m.list_place[a][k] + m.list_time * static_cast<double>(m.list_velocity[a][k]);
  }
  out.deviation2 = (out.place - line).squaredNorm();
  return out;
}

}  // namespace quern::twin
