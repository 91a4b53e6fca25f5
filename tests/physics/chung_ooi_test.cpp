// The eight benchmark impacts of Chung and Ooi (Granular Matter 13 (2011) 643-656), as far as a
// linear law has closed forms. Theirs are for Hertz contacts; the set-ups are the same, the
// stiffnesses are ours.
//
//   1 two equal spheres, elastic, head-on       5 sphere on plane, v_n fixed, v_t varies
//   2 sphere on rigid plane, elastic            6 sphere on plane, v_n fixed, spin varies
//   3 the same with restitution                 7 two equal spheres, spin varies
//   4 sphere on plane, speed fixed, angle varies 8 two spheres of different size, spin varies
//
// Gross sliding: the tangential impulse is mu times the normal one, mu m_e (1 + e) v_n; it slides
// from the first step if the dashpots' trial force is over the cone (slip over mu v_n sqrt(3.5
// kn/kt)) and to the last if slip remains. Sticking: with kt = 2/7 kn, e = 1 and no dashpot, normal
// and tangential springs swing in phase, so the contact sticks for slip below 3.5 mu v_n and the
// slip is turned round exactly. Arms end at the contact point: R - overlap / 2; radii below are
// exact in f64.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/support/small_scene.h"

namespace quern::test {
namespace {

constexpr double kRadius = 0.01;
constexpr double kSteps = 400;  // per contact

// What is left of an oblique impact in the plane x-z, on a plane z = 0 or of two spheres along z.
struct Impact {
  Law law;
  double radius1 = kRadius, radius2 = 0;  // 0: a fixed plane
  double vn = 1, vt = 0;                  // m/s, of sphere 1, v = (vt, 0, -vn)
  double vn2 = 0;                         // m/s, of sphere 2, v = (0, 0, vn2)
  double spin1 = 0, spin2 = 0;            // rad/s about y

  double mass1() const { return sphere_mass(2 * radius1); }
  double mass2() const { return sphere_mass(2 * radius2); }
  double reduced_mass() const {
    return radius2 > 0 ? mass1() * mass2() / (mass1() + mass2()) : mass1();
  }
  double contact_time() const { return normal_contact_time(reduced_mass(), law.kn); }
  double closing() const { return vn + vn2; }
  double largest_overlap() const { return closing() * std::sqrt(reduced_mass() / law.kn); }
  // Slip of sphere 1 over its partner at the contact: v_t - R w for spins about y.
  double slip() const { return vt - radius1 * spin1 - radius2 * spin2; }
};

struct Outcome {
  double vt1, vn1, spin1, vt2 = 0, vn2 = 0, spin2 = 0;
  double duration, largest_overlap;  // s; m
};

template <class Real = double>
Outcome run(const Impact& impact) {
  const double dt = impact.contact_time() / kSteps;
  Scene scene = small_scene(impact.law, dt, 0.5);
  const Vec3 v1(impact.vt, 0, -impact.vn);
  const double gap = 0.5 * impact.closing() * dt;
  const Vec3 place(0.0625, 0.03125, 0);  // away from the edge between the triangles of the plane
  add_sphere(scene, 2 * impact.radius1, place + Vec3(0, 0, impact.radius1 + gap), v1,
             {0, impact.spin1, 0});
  if (impact.radius2 > 0) {
    add_sphere(scene, 2 * impact.radius2, place - Vec3(0, 0, impact.radius2), {0, 0, impact.vn2},
               {0, impact.spin2, 0});
  } else {
    add_plane(scene, Vec3::Zero(), Vec3::UnitZ());
  }
  World<Real> world = world_of<Real>(scene);
  Stepper<Real> stepper(world, 1);
  Outcome out{};
  int touching = 0;
  for (int k = 0; k < static_cast<int>(1.6 * kSteps); ++k) {
    out.largest_overlap = std::max(
        out.largest_overlap,
        stepper.step().max_overlap *
            std::min(impact.radius1, impact.radius2 > 0 ? impact.radius2 : impact.radius1));
    touching += world.totals.pair_contacts + world.totals.wall_contacts > 0 ? 1 : 0;
  }
  out.duration = touching * dt;
  out.vt1 = velocity_of(world, 0).x();
  out.vn1 = velocity_of(world, 0).z();
  out.spin1 = spin_of(world, 0).y();
  // The normal of a face is exact; rounding of a few hundred steps.
  EXPECT_NEAR(velocity_of(world, 0).y(), 0,
              1e-12 * (1 + impact.law.restitution) * impact.closing());
  if (impact.radius2 > 0) {
    out.vt2 = velocity_of(world, 1).x();
    out.vn2 = velocity_of(world, 1).z();
    out.spin2 = spin_of(world, 1).y();
  }
  return out;
}

Law elastic_law() {
  Law law;
  law.restitution = 1;
  return law;
}
Law sliding_law(double restitution, double mu) {
  Law law;
  law.restitution = restitution;
  law.sliding = mu;
  return law;
}
// Springs in phase: kt = 2/7 kn, no loss.
Law sticking_law(double mu) {
  Law law = peer_law(1, mu);
  law.kt = law.kn * 2 / 7;
  return law;
}

// Leapfrog at N steps a contact: durations to a step at either end, overlaps to (w dt)^2 / 8.
void expect_elastic(const Impact& impact, const Outcome& out) {
  const double dt = impact.contact_time() / kSteps;
  EXPECT_NEAR(out.duration, impact.contact_time(), 1.01 * dt);
  EXPECT_NEAR(out.largest_overlap / impact.largest_overlap(), 1,
              std::pow(kPi / kSteps, 2) / 4 + 1e-6);
}

TEST(ChungOoi, T1ElasticImpactOfEqualSpheresTakesPiRootMOverK) {
  for (const double v : {0.02, 0.5, 10.0}) {
    Impact impact;
    impact.law = elastic_law();
    impact.radius2 = kRadius;
    impact.vn = impact.vn2 = v;
    const Outcome out = run(impact);
    expect_elastic(impact, out);
    // (w dt)^2 / 8 of the speed.
    EXPECT_NEAR(out.vn1, v, 1e-5 * v);
    EXPECT_NEAR(out.vn2, -v, 1e-5 * v);
  }
}

TEST(ChungOoi, T2ElasticImpactOnARigidPlaneTakesPiRootMOverK) {
  for (const double v : {0.02, 0.2, 5.0}) {
    Impact impact;
    impact.law = elastic_law();
    impact.vn = v;
    const Outcome out = run(impact);
    expect_elastic(impact, out);
    EXPECT_NEAR(out.vn1, v, 1e-5 * v);
  }
}

TEST(ChungOoi, T3ReboundSpeedIsRestitutionTimesImpactSpeed) {
  for (double e = 0.2; e < 1.01; e += 0.1) {
    for (const NormalForce mode : {NormalForce::kClamped, NormalForce::kUnclamped}) {
      Impact impact;
      impact.law.restitution = std::min(e, 1.0);
      impact.law.normal_force = mode;
      impact.vn = 3.9;
      // Entry in the middle of a step: half of half a step of the dashpot, 2 zeta w dt e / 2.
      const double limit = mode == NormalForce::kClamped ? 1e-4 : 0.7 * kPi / kSteps;
      EXPECT_NEAR(run(impact).vn1 / impact.vn, e, limit) << e;
    }
  }
}

// Two spheres turn about each other while they touch: by their relative v_t times the contact time
// over their distance, by which the normal impulse gains a tangential part and friction a normal
// one.
double turn_of(const Impact& i, const Outcome& out) {
  const double vt = std::max(std::abs(i.vt), std::abs(out.vt1 - out.vt2));
  return i.radius2 > 0 ? vt * i.contact_time() / (i.radius1 + i.radius2) : 0;
}

// Sliding all through: impulses to rounding from the normal velocities that were delivered.
void expect_sliding(const Impact& i, const Outcome& out) {
  const double mu = i.law.sliding, side = i.slip() > 0 ? 1 : -1;
  const double normal_impulse = i.mass1() * (out.vn1 + i.vn);
  // e = 0.3 ... 1 at 400 steps: the clamped scheme delivers e to 1e-4 (T3).
  EXPECT_NEAR((out.vn1 - out.vn2) / i.closing(), i.law.restitution, 2e-4);
  const double impulse = side * mu * normal_impulse;
  const double turn = turn_of(i, out);
  const double scale = 2 * i.reduced_mass() * i.closing();
  EXPECT_NEAR(i.mass1() * (i.vt - out.vt1), impulse, scale * (1e-9 + turn));
  // Arms are shorter than the radius by half the overlap at most.
  const double arm = 0.5 * i.largest_overlap();
  const double inertia1 = 0.4 * i.mass1() * i.radius1 * i.radius1;
  EXPECT_NEAR(inertia1 * (out.spin1 - i.spin1), i.radius1 * impulse,
              std::abs(impulse) * arm + scale * i.radius1 * (1e-9 + turn));
  if (i.radius2 == 0) return;
  const double inertia2 = 0.4 * i.mass2() * i.radius2 * i.radius2;
  EXPECT_NEAR(i.mass2() * out.vt2, impulse, scale * (1e-9 + turn));
  EXPECT_NEAR(inertia2 * (out.spin2 - i.spin2), i.radius2 * impulse,
              std::abs(impulse) * arm + scale * i.radius2 * (1e-9 + turn));
}

// Sticking all through: the slip turned round; momentum and the moment about the contact kept.
void expect_sticking(const Impact& i, const Outcome& out) {
  const double slip_after = out.vt1 - out.vt2 - i.radius1 * out.spin1 - i.radius2 * out.spin2;
  // Arms enter slip and torque: half the overlap over the radius. Leapfrog: (w dt)^2 / 8 each, and
  // a quarter step of the spring at either end, pi / 400 / 4 squared.
  const double smaller = i.radius2 > 0 ? std::min(i.radius1, i.radius2) : i.radius1;
  const double arm = i.largest_overlap() / smaller;
  const double turn = turn_of(i, out);
  const double limit = arm + turn * i.closing() / std::max(std::abs(i.slip()), 1e-9) + 1e-4;
  EXPECT_NEAR(slip_after / i.slip(), -1, limit) << "slip " << i.slip();
  // The impulse that turns the slip round: 2 m_t slip, m_t = 2/7 m_e.
  const double impulse = 4.0 / 7 * i.reduced_mass() * i.slip();
  const double allowed = limit * std::abs(impulse) + 2 * turn * i.reduced_mass() * i.closing();
  EXPECT_NEAR(i.mass1() * (i.vt - out.vt1), impulse, allowed);
  EXPECT_NEAR(0.4 * i.mass1() * i.radius1 * (out.spin1 - i.spin1), impulse, allowed);
  if (i.radius2 > 0) {
    EXPECT_NEAR(i.mass2() * out.vt2, impulse, allowed);
    EXPECT_NEAR(0.4 * i.mass2() * i.radius2 * (out.spin2 - i.spin2), impulse, allowed);
  }
}

// Slip over approach above which dashpots and springs slide from the first step to the last.
double sliding_slip(const Impact& i) {
  const double to_the_last = 3.5 * i.law.sliding * (1 + i.law.restitution);
  const double from_the_first = i.law.sliding * std::sqrt(3.5 * i.law.kn / i.law.kt);
  return 1.05 * std::max(to_the_last, from_the_first);
}
double sticking_slip(const Impact& i) { return 0.95 * 3.5 * i.law.sliding; }

TEST(ChungOoi, T4OfConstantSpeedAtAnyAngleSlidesOrSticksInClosedForm) {
  const double speed = 3.9;
  int slid = 0, stuck = 0;
  for (double degrees = 5; degrees < 88; degrees += 5) {
    const double angle = degrees * kPi / 180;
    for (const Law& law : {sliding_law(0.98, 0.092), sliding_law(0.5, 0.3), sticking_law(0.3)}) {
      Impact impact;
      impact.law = law;
      impact.vn = speed * std::cos(angle);
      impact.vt = speed * std::sin(angle);
      const bool slides = law.tangential_damping && std::tan(angle) > sliding_slip(impact);
      const bool sticks = !law.tangential_damping && std::tan(angle) < sticking_slip(impact);
      if (!slides && !sticks) continue;
      const Outcome out = run(impact);
      if (sticks) {
        expect_sticking(impact, out);
        ++stuck;
        continue;
      }
      expect_sliding(impact, out);
      ++slid;
      // The form of the paper's figure: tangential restitution over the angle of incidence; e is
      // delivered to 1e-4.
      const double et = 1 - law.sliding * (1 + law.restitution) / std::tan(angle);
      EXPECT_NEAR(out.vt1 / impact.vt, et, 1e-4) << degrees;
      const double spin = 2.5 * law.sliding * (1 + law.restitution) * impact.vn / kRadius;
      EXPECT_NEAR(out.spin1 / spin, 1, 1e-4 + 0.5 * impact.largest_overlap() / kRadius) << degrees;
    }
  }
  EXPECT_GT(slid, 10);
  EXPECT_GT(stuck, 5);
}

TEST(ChungOoi, T5OfConstantNormalSpeedAtAnyTangentialSpeedSlidesOrSticksInClosedForm) {
  for (const double ratio : {-2.0, -1.0, 1.0, 1.5, 4.0, 20.0}) {
    Impact slide;
    slide.law = sliding_law(0.5, 0.3);
    slide.vn = 5;
    slide.vt = ratio * sliding_slip(slide) * slide.vn;
    expect_sliding(slide, run(slide));
    Impact stick;
    stick.law = sticking_law(0.4);
    stick.vn = 5;
    stick.vt = sticking_slip(stick) * stick.vn / ratio;
    if (std::abs(ratio) >= 1) expect_sticking(stick, run(stick));
  }
}

TEST(ChungOoi, T6OfASpinningSphereOnAPlaneThrowsItSideways) {
  for (const double ratio : {-5.0, -1.0, 1.0, 2.0, 10.0}) {
    Impact slide;
    slide.law = sliding_law(0.5, 0.4);
    slide.vn = 0.2;
    slide.spin1 = ratio * sliding_slip(slide) * slide.vn / slide.radius1;
    const Outcome out = run(slide);
    expect_sliding(slide, out);
    const double side = ratio > 0 ? 1 : -1;
    EXPECT_NEAR(out.vt1 / (side * 0.4 * 1.5 * slide.vn), 1, 1e-4) << ratio;
    Impact stick;
    stick.law = sticking_law(0.4);
    stick.vn = 0.2;
    stick.spin1 = sticking_slip(stick) * stick.vn / stick.radius1 / ratio;
    expect_sticking(stick, run(stick));
  }
}

TEST(ChungOoi, T7OfEqualSpheresWithEqualSpinsIsSymmetric) {
  for (const double ratio : {-4.0, -1.0, 1.0, 3.0, 10.0}) {
    for (const bool sticks : {false, true}) {
      Impact impact;
      impact.law = sticks ? sticking_law(0.4) : sliding_law(0.5, 0.4);
      impact.radius2 = kRadius;
      impact.vn = impact.vn2 = 0.2;
      const double slip = (sticks ? sticking_slip(impact) / ratio : sliding_slip(impact) * ratio) *
                          impact.closing();
      impact.spin1 = impact.spin2 = 0.5 * slip / kRadius;
      const Outcome out = run(impact);
      sticks ? expect_sticking(impact, out) : expect_sliding(impact, out);
      // Rounding of a hundred steps.
      EXPECT_NEAR(out.vt1, -out.vt2, 1e-12);
      EXPECT_NEAR(out.vn1, -out.vn2, 1e-12);
      EXPECT_NEAR(out.spin1, out.spin2, 1e-12 * std::abs(out.spin1));
    }
  }
}

TEST(ChungOoi, T8OfDifferentSpheresSharesTheImpulseByMassAndInertia) {
  for (const double ratio : {-4.0, -1.0, 1.0, 3.0, 10.0}) {
    for (const bool sticks : {false, true}) {
      Impact impact;
      impact.law = sticks ? sticking_law(0.4) : sliding_law(0.5, 0.4);
      impact.radius2 = 5 * kRadius;
      impact.vn = 0.2;
      const double slip = (sticks ? sticking_slip(impact) / ratio : sliding_slip(impact) * ratio) *
                          impact.closing();
      impact.spin1 = slip / impact.radius1;
      const Outcome out = run(impact);
      sticks ? expect_sticking(impact, out) : expect_sliding(impact, out);
      const double momentum = impact.mass1() * out.vn1 + impact.mass2() * out.vn2;
      EXPECT_NEAR(momentum / (-impact.mass1() * impact.vn), 1, 1e-12);
    }
  }
}

TEST(ChungOoi, MixedPrecisionFollowsDouble) {
  Impact impact;
  impact.law = sliding_law(0.5, 0.4);
  impact.radius2 = 2 * kRadius;
  impact.vn = 1;
  impact.vt = 0.7;
  impact.spin1 = 50;
  const Outcome a = run<float>(impact), b = run<double>(impact);
  // f32 forces: 400 steps of 20 operations at 2^-24, errors adding as their root.
  EXPECT_NEAR(a.vt1, b.vt1, 1e-5);
  EXPECT_NEAR(a.vn1, b.vn1, 1e-5);
  EXPECT_NEAR(kRadius * a.spin1, kRadius * b.spin1, 1e-5);
}

}  // namespace
}  // namespace quern::test
