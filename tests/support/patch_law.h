// The contact law of polyhedra as plain scalar f64 code: the oracle of the engine's.
//
// Written from kernels/README.md: implicit damping bounded by the contacts of the last step,
// clamped normal force with the share of a fresh contact, tangential spring with Coulomb's cap on
// spring and dashpot together, and the moments of the patch. Forces act in the contact point; a
// wall is a body with inverse mass and inertia of zero. Masses are kept as inverses as the engine
// keeps them, the lever of m_t is the contact point's distance from the centre over the least
// principal moment.
#pragma once

#include <algorithm>
#include <cmath>

#include "kernels/laws/patch_damping.h"

namespace quern::law {

struct Constants {
  double kn = 0, kt = 0;  // N/m
  double zeta_n = 0, zeta_t = 0;
  double mu = 0;
  double dt = 0;  // s
  bool patch_damping = true;
};

struct Body {
  Vec3 place = Vec3::Zero(), velocity = Vec3::Zero(), spin = Vec3::Zero();  // half step
  double inverse_mass = 0;
  double inverse_inertia = 0;  // of the least principal moment
  double contacts = 0;         // of the last step
};

// Contact of i and j; the normal points from j to i.
struct Touch {
  Vec3 normal = Vec3::UnitZ(), point = Vec3::Zero();
  double overlap = 0, area = 0;
};

struct History {
  bool open = false;
  Vec3 spring = Vec3::Zero(), normal = Vec3::UnitZ();
};

struct Response {
  Vec3 force = Vec3::Zero();                              // on i
  Vec3 torque_i = Vec3::Zero(), torque_j = Vec3::Zero();  // about the centres
};

inline Vec3 carried_spring(const History& old, const Vec3& n, const Vec3& mean_spin, double dt) {
  const Vec3 turned = Quat::FromTwoVectors(old.normal, n) * old.spring;
  return Eigen::AngleAxisd(dt * mean_spin.dot(n), n) * turned;
}

// Force and new history. A contact that was not open begins with no spring.
inline Response respond(const Constants& k, const Body& i, const Body& j, const Touch& touch,
                        History& history) {
  const Vec3& n = touch.normal;
  const Vec3 arm_i = touch.point - i.place, arm_j = touch.point - j.place;
  const Vec3 v = i.velocity + i.spin.cross(arm_i) - j.velocity - j.spin.cross(arm_j);
  const double vn = n.dot(v);
  const Vec3 vt = v - vn * n;

  const double turning_i = i.inverse_mass + arm_i.squaredNorm() * i.inverse_inertia;
  const double turning_j = j.inverse_mass + arm_j.squaredNorm() * j.inverse_inertia;
  const double mobility_n = i.inverse_mass + j.inverse_mass, mobility_t = turning_i + turning_j;
  const double crowd_n =
      std::max(mobility_n, i.contacts * i.inverse_mass + j.contacts * j.inverse_mass);
  const double crowd_t = std::max(mobility_t, i.contacts * turning_i + j.contacts * turning_j);
  const double cn = 2 * k.zeta_n * std::sqrt(k.kn / mobility_n);
  const double ct = 2 * k.zeta_t * std::sqrt(k.kt / mobility_t);
  const double kn = k.kn / (1 + 0.5 * k.dt * cn * mobility_n);
  const double kt = k.kt / (1 + 0.5 * k.dt * ct * mobility_t);
  const double cn_bound = cn / (1 + 0.5 * k.dt * cn * crowd_n);
  const double ct_bound = ct / (1 + 0.5 * k.dt * ct * crowd_t);

  const bool fresh = vn < 0 && touch.overlap < -vn * k.dt;
  const double share = fresh ? 0.5 + touch.overlap / (-vn * k.dt) : 1;
  const double fn = std::max(0.0, kn * touch.overlap - share * cn_bound * vn);

  const Vec3 old =
      history.open ? carried_spring(history, n, 0.5 * (i.spin + j.spin), k.dt) : Vec3(Vec3::Zero());
  const Vec3 trial_spring = old + k.dt * vt;
  const Vec3 trial = -kt * trial_spring - ct_bound * vt;
  const double cap = k.mu * fn;
  const bool slides = trial.norm() > cap;
  const double spring_force = kt * trial_spring.norm();
  const Vec3 ft = slides ? Vec3(cap / trial.norm() * trial) : trial;
  history.spring =
      slides && spring_force > cap ? Vec3(cap / spring_force * trial_spring) : trial_spring;
  history.normal = n;
  history.open = true;

  Response r;
  r.force = fn * n + ft;
  Vec3 moment = Vec3::Zero();
  if (k.patch_damping) {
    const PatchDashpot dashpot{
        cn, ct, k.mu, patch_mobility(i.inverse_inertia, i.contacts, j.inverse_inertia, j.contacts),
        k.dt};
    moment = patch_moment(dashpot, n, i.spin - j.spin, touch.area, fn);
  }
  r.torque_i = arm_i.cross(r.force) + moment;
  r.torque_j = -arm_j.cross(r.force) - moment;
  return r;
}

}  // namespace quern::law
