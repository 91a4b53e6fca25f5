// Force and torque of two polyhedra along paths through all the places where features change.
//
// A continuous quantity's greatest step between samples falls as the sampling is refined: to a
// quarter from 2,000 to 8,000 samples where it is Lipschitz, to a half at the worst kind of corner
// of a square root. A jump keeps its size. 0.35 tells them apart.
#include <gtest/gtest.h>

#include <functional>

#include "tests/support/polyhedra.h"

namespace quern {
namespace {

using Path = std::function<void(double, ShapePose&)>;  // pose of B at s in [0, 1]

struct Steps {
  double force = 0, torque = 0, largest = 0;
};

Steps largest_steps(const ShapePose& a, ShapePose b, const Path& path, OverlapMeasure measure,
                    int samples) {
  Steps out;
  Vec3 force_before = Vec3::Zero(), torque_before = Vec3::Zero();
  PairAxis axis;
  for (int k = 0; k <= samples; ++k) {
    path(double(k) / samples, b);
    PolyhedronTouch t;
    Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
    if (touch_polyhedra(a, b, {measure, NormalModel::kStiffness}, axis, t)) {
      force = t.overlap * t.normal;
      torque = (t.point - b.place).cross(force);
    }
    out.largest = std::max(out.largest, force.norm());
    if (k > 0) {
      out.force = std::max(out.force, (force - force_before).norm());
      out.torque = std::max(out.torque, (torque - torque_before).norm());
    }
    force_before = force;
    torque_before = torque;
  }
  return out;
}

void expect_continuous(const ShapePose& a, const ShapePose& b, const Path& path, const char* what) {
  for (const OverlapMeasure measure : {OverlapMeasure::kChord, OverlapMeasure::kWidth}) {
    const Steps coarse = largest_steps(a, b, path, measure, 2000);
    const Steps fine = largest_steps(a, b, path, measure, 8000);
    ASSERT_GT(coarse.largest, 1e-3) << what;
    EXPECT_LE(fine.force, 0.35 * coarse.force) << what;
    EXPECT_LE(fine.torque, 0.35 * coarse.torque) << what;
    EXPECT_LE(coarse.force, 8e-2 * coarse.largest) << what;
  }
}

Mat3 turn_about(const Vec3& axis, double angle) {
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}
double lowest(const Shape& shape, const Mat3& turn) {
  double z = 0;
  for (std::size_t v = 0; v < shape.vertices; ++v) z = std::min(z, (turn * shape.vertex(v)).z());
  return z;
}

class PolyhedronSweep : public testing::Test {
 protected:
  PolyhedronSweep() : cube_(box_shape(1, 1, 1)), plate_(box_shape(6, 6, 1)) {
    a_.shape = b_.shape = &cube_;
  }
  Shape cube_, plate_;
  ShapePose a_, b_;
};

TEST_F(PolyhedronSweep, ThroughFlatIsContinuous) {
  b_.scale = 0.6;
  expect_continuous(
      a_, b_,
      [](double s, ShapePose& b) {
        b.turn = turn_about(Vec3(1, 0.3, 0), 0.4 * (s - 0.5));
        b.place = Vec3(0.05, 0.02, 0.5 + 0.3 - 0.03);
      },
      "tilt through flat");
}

TEST_F(PolyhedronSweep, RollingOverVertexEdgeAndFaceIsContinuous) {
  a_.shape = &plate_;
  expect_continuous(
      a_, b_,
      [this](double s, ShapePose& b) {
        // From a face to an edge, along it to a vertex, and down on the next face.
        b.turn = turn_about(Vec3(0, 1, 0), kPi / 2 * std::min(1.0, 1.5 * s)) *
                 turn_about(Vec3(1, 0, 0), 0.6 * std::sin(kPi * s));
        b.place = Vec3(0.3, 0.1, 0.5 - 0.03 - 0.01 * s - lowest(cube_, b.turn));
      },
      "vertex, edge, face");
}

TEST_F(PolyhedronSweep, OfAVertexOffAnEdgeIsContinuous) {
  const Mat3 tip_down = turn_about(Vec3(1, -1, 0), std::atan(std::sqrt(2.0)));
  expect_continuous(
      a_, b_,
      [&](double s, ShapePose& b) {
        b.turn = turn_about(Vec3(0, 0, 1), 0.2) * tip_down;
        b.place = Vec3(0.2 + 0.6 * s, 0.07, 0.5 - 0.05 - lowest(cube_, b.turn));
      },
      "vertex over edge");
}

TEST_F(PolyhedronSweep, OfAFlatFaceOffAnEdgeIsContinuous) {
  expect_continuous(
      a_, b_, [](double s, ShapePose& b) { b.place = Vec3(0.5 + 0.6 * s, 0.1, 0.95); },
      "face off edge");
}

TEST_F(PolyhedronSweep, OfEdgesThroughParallelIsContinuous) {
  a_.turn = turn_about(Vec3(1, 0, 0), kPi / 4);
  expect_continuous(
      a_, b_,
      [this](double s, ShapePose& b) {
        b.turn = turn_about(Vec3(0, 0, 1), 0.8 * (s - 0.5)) * a_.turn;
        b.place = Vec3(0.1, 0.01, std::sqrt(2.0) - 0.05);
      },
      "edges twist through parallel");
}

TEST_F(PolyhedronSweep, OfFiveRandomPathsIsContinuous) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    std::mt19937_64 random(seed);
    const Shape rock = seed % 2 ? rock_of_planes(seed, 12) : rock_of_points(seed, 22);
    const Shape other = rock_of_planes(seed + 20, 12);
    a_.shape = &rock;
    b_.shape = &other;
    const Vec3 direction = random_direction(random), about = random_direction(random);
    const Vec3 across = direction.cross(random_direction(random)).normalized();
    const Mat3 start = random_turn(random);
    b_.turn = start;
    bring_to_overlap(a_, b_, direction, 0.1);
    const Vec3 middle = b_.place;
    expect_continuous(
        a_, b_,
        [&](double s, ShapePose& b) {
          b.turn = turn_about(about, 1.5 * (s - 0.5)) * start;
          b.place = middle + 0.8 * (s - 0.5) * across;
        },
        "random path");
  }
}

}  // namespace
}  // namespace quern
