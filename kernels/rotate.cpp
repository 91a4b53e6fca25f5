// Rotation of bodies: the lanes' loop for every SIMD target, and the plain scalar code.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/rotate.cpp"
#include "kernels/rotate.h"

#include <hwy/foreach_target.h>

#include "kernels/rotate-inl.h"

HWY_BEFORE_NAMESPACE();
namespace quern {
namespace HWY_NAMESPACE {

using V64R = hn::Vec<D64>;

Vec3V<V64R> load3(const double* const (&column)[3], std::size_t at) {
  const D64 d;
  return {hn::LoadU(d, column[0] + at), hn::LoadU(d, column[1] + at), hn::LoadU(d, column[2] + at)};
}

void rotate_lanes(const RotationView& b, double kick, double dt) {
  const D64 d;
  const std::size_t lanes = hn::Lanes(d);
  for (std::size_t at = 0; at < b.count; at += lanes) {
    const auto live = hn::FirstN(d, b.count - at);
    const auto store = [&](V64R v, double* column) { hn::BlendedStore(v, live, d, column + at); };
    const Vec3V<V64R> inverse = load3(b.inverse_inertia, at);
    const double* const momentum_in[3] = {b.momentum[0], b.momentum[1], b.momentum[2]};
    const Vec3V<V64R> momentum =
        add_scaled(load3(momentum_in, at), hn::Set(d, kick), load3(b.torque, at));
    QuatV<V64R> q = {hn::LoadU(d, b.orientation[0] + at), hn::LoadU(d, b.orientation[1] + at),
                     hn::LoadU(d, b.orientation[2] + at), hn::LoadU(d, b.orientation[3] + at)};
    q = rotate_freely(q, momentum, inverse, hn::Set(d, dt));
    const Vec3V<V64R> spin = spin_of(q, momentum, inverse);
    store(q.w, b.orientation[0]);
    store(q.x, b.orientation[1]);
    store(q.y, b.orientation[2]);
    store(q.z, b.orientation[3]);
    store(momentum.x, b.momentum[0]);
    store(momentum.y, b.momentum[1]);
    store(momentum.z, b.momentum[2]);
    store(spin.x, b.spin[0]);
    store(spin.y, b.spin[1]);
    store(spin.z, b.spin[2]);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace quern
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace quern {
namespace {

HWY_EXPORT(rotate_lanes);

constexpr double kNoInertia = 1e-12;  // of the largest principal moment

// The turn about principal axis a by theta = rate * p[a].
void turn_about(Eigen::Index a, double rate, Vec3& p, Quat& q) {
  const double angle = rate * p[a];
  const Eigen::Index b = (a + 1) % 3, c = (a + 2) % 3;
  const double sine = std::sin(angle), cosine = std::cos(angle);
  const double pb = p[b];
  p[b] = cosine * pb + sine * p[c];
  p[c] = cosine * p[c] - sine * pb;
  Quat turn(std::cos(0.5 * angle), 0, 0, 0);
  turn.vec()[a] = std::sin(0.5 * angle);
  q = q * turn;
}

}  // namespace

Vec3 inverse_inertia_of(const Vec3& inertia) noexcept {
  const double least = kNoInertia * inertia.maxCoeff();
  Vec3 inverse = Vec3::Zero();
  for (Eigen::Index a = 0; a < 3; ++a) {
    if (inertia[a] > least) inverse[a] = 1 / inertia[a];
  }
  return inverse;
}

Quat rotate_freely(const Quat& orientation, const Vec3& momentum, const Vec3& inverse_inertia,
                   double dt) noexcept {
  Quat q = orientation;
  Vec3 p = q.conjugate() * momentum;
  const Vec3 rate = dt * inverse_inertia;
  turn_about(0, 0.5 * rate[0], p, q);
  turn_about(1, 0.5 * rate[1], p, q);
  turn_about(2, rate[2], p, q);
  turn_about(1, 0.5 * rate[1], p, q);
  turn_about(0, 0.5 * rate[0], p, q);
  return q.normalized();
}

Vec3 spin_of(const Quat& q, const Vec3& momentum, const Vec3& inverse_inertia) noexcept {
  return q * Vec3(inverse_inertia.cwiseProduct(q.conjugate() * momentum));
}

void rotate_bodies(const RotationView& bodies, double kick, double dt) noexcept {
  HWY_DYNAMIC_DISPATCH(rotate_lanes)(bodies, kick, dt);
}

}  // namespace quern
#endif
