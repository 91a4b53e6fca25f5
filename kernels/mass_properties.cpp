// Sums over the tetrahedra between a reference point and the triangles; see mass_properties.h.
//
// A tetrahedron (0, a, b, c) of volume V has its centroid in s/4, s = a + b + c, and the second
// moments V/20 (aa' + bb' + cc' + ss').
#include "kernels/mass_properties.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace quern {
namespace {

constexpr double kKeptAxes = 1e-12;  // off-diagonal terms over the trace

struct Moments {
  double volume = 0;
  Vec3 first = Vec3::Zero();
  Mat3 second = Mat3::Zero();
};

Moments moments_about(const Vec3& origin, const std::vector<Vec3>& vertex,
                      const std::vector<std::array<Index, 3>>& triangle) {
  Moments sum;
  for (const auto& t : triangle) {
    const Vec3 a = vertex[t[0]] - origin, b = vertex[t[1]] - origin, c = vertex[t[2]] - origin;
    const Vec3 s = a + b + c;
    const double volume = a.dot(b.cross(c)) / 6;
    sum.volume += volume;
    sum.first += volume / 4 * s;
    sum.second += volume / 20 *
                  (a * a.transpose() + b * b.transpose() + c * c.transpose() + s * s.transpose());
  }
  return sum;
}

}  // namespace

MassProperties mass_properties(const std::vector<Vec3>& vertex,
                               const std::vector<std::array<Index, 3>>& triangle) {
  MassProperties mass;
  if (vertex.empty()) return mass;
  const Moments rough = moments_about(vertex[0], vertex, triangle);
  mass.volume = rough.volume;
  mass.centroid = vertex[0];
  if (rough.volume == 0) return mass;
  mass.centroid += rough.first / rough.volume;
  const Mat3 second = moments_about(mass.centroid, vertex, triangle).second;
  mass.inertia = second.trace() * Mat3::Identity() - second;
  return mass;
}

PrincipalAxes principal_axes(const Mat3& inertia) {
  PrincipalAxes principal;
  const double off_diagonal =
      std::max({std::abs(inertia(0, 1)), std::abs(inertia(0, 2)), std::abs(inertia(1, 2))});
  if (off_diagonal <= kKeptAxes * inertia.trace()) {
    principal.moments = inertia.diagonal();
    return principal;
  }
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(inertia);
  QUERN_CHECK(solver.info() == Eigen::Success);
  principal.moments = solver.eigenvalues();
  principal.axes = solver.eigenvectors();
  for (int k = 0; k < 2; ++k) {  // an axis and its opposite are both principal: take one for good
    Eigen::Index largest = 0;
    principal.axes.col(k).cwiseAbs().maxCoeff(&largest);
    if (principal.axes(largest, k) < 0) principal.axes.col(k) *= -1;
  }
  principal.axes.col(2) = principal.axes.col(0).cross(principal.axes.col(1));
  return principal;
}

}  // namespace quern
