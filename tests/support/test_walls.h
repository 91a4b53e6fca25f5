// Surfaces for tests: the lab mill, plates in random triangulations, random numbers, shortcuts.
#pragma once

#include <random>
#include <vector>

#include "soa/facets.h"

namespace quern::test {

inline MillSpec lab_mill() {
  MillSpec mill;
  mill.diameter = 0.3;
  mill.length = 0.04;
  mill.lifters = LifterSpec{18, 0.010, 14 * kPi / 180, 0.010};
  return mill;
}

inline Facets facets_of(std::vector<Triangle> triangles, double cell = 0.1) {
  return build_facets({{std::move(triangles), 0}}, cell);
}

inline Triangle turned_over(const Triangle& t) { return {{t.corner[0], t.corner[2], t.corner[1]}}; }

inline std::vector<Triangle> turned_over(std::vector<Triangle> surface) {
  for (auto& t : surface) t = turned_over(t);
  return surface;
}

inline std::vector<Triangle> moved(std::vector<Triangle> surface, const Mat3& turn,
                                   const Vec3& shift) {
  for (auto& t : surface) {
    for (auto& p : t.corner) p = turn * p + shift;
  }
  return surface;
}

inline double area(const std::vector<Triangle>& surface) {
  double sum = 0;
  for (const auto& t : surface) {
    sum += 0.5 * (t.corner[1] - t.corner[0]).cross(t.corner[2] - t.corner[0]).norm();
  }
  return sum;
}

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double operator()(double low, double high) {
    return low + (high - low) * std::generate_canonical<double, 53>(engine_);
  }
  std::size_t below(std::size_t n) { return engine_() % n; }
  Vec3 in_cube(double half) {
    return Vec3((*this)(-half, half), (*this)(-half, half), (*this)(-half, half));
  }
  Mat3 turn() {
    const Vec3 axis = in_cube(1).normalized();
    return Eigen::AngleAxisd((*this)(0.0, 2 * kPi), axis).toRotationMatrix();
  }

 private:
  std::mt19937_64 engine_;
};

inline Vec3 inner_point(const Triangle& t, double u, double v) {
  return t.corner[0] + u * (t.corner[1] - t.corner[0]) + v * (t.corner[2] - t.corner[0]);
}

// Cuts the triangle `which` and, if a point is on an edge and joints are to match, its neighbour.
inline void cut_edge(std::vector<Triangle>& plate, std::size_t which, bool both, Random& random) {
  const std::size_t k = random.below(3);
  const Vec3 a = plate[which].corner[k], b = plate[which].corner[(k + 1) % 3];
  const Vec3 p = a + random(0.2, 0.8) * (b - a);
  const std::size_t count = plate.size();
  for (std::size_t t = 0; t < count; ++t) {
    if (t != which && !both) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 from = plate[t].corner[i], to = plate[t].corner[(i + 1) % 3];
      const Vec3 apex = plate[t].corner[(i + 2) % 3];
      if (!((from == a && to == b) || (from == b && to == a))) continue;
      plate[t] = {{from, p, apex}};
      plate.push_back({{p, to, apex}});
      break;
    }
  }
}

// A plate |x|, |y| < 1 in the plane z = 0, cut at random: points put into faces and on edges. With
// t_junctions a point on an edge cuts the triangle of one side only.
inline std::vector<Triangle> random_plate(int cuts, bool t_junctions, Random& random) {
  const Vec3 a(-1, -1, 0), b(1, -1, 0), c(1, 1, 0), d(-1, 1, 0);
  std::vector<Triangle> plate = {{{a, b, c}}, {{a, c, d}}};
  for (int i = 0; i < cuts; ++i) {
    const std::size_t t = random.below(plate.size());
    if (random(0, 1) < 0.6) {
      cut_edge(plate, t, !t_junctions, random);
      continue;
    }
    const double u = random(0.2, 0.4), v = random(0.2, 0.4);
    const Triangle old = plate[t];
    const Vec3 p = inner_point(old, u, v);
    plate[t] = {{old.corner[0], old.corner[1], p}};
    plate.push_back({{old.corner[1], old.corner[2], p}});
    plate.push_back({{old.corner[2], old.corner[0], p}});
  }
  return plate;
}

}  // namespace quern::test
