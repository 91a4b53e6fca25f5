// Matching of wall contacts over a step; see wall_history.h. Lists are a few entries long, so plain
// scans are the fastest, and the order of the lists decides between candidates.
#include "kernels/pairs/wall_history.h"

namespace quern {
namespace {

constexpr double kSameNormal = 0.9;  // least cosine between old and new normal
constexpr double kSamePoint = 0.2;   // largest distance of contact points, of the radius

bool is_taken(int old, const int* old_of_new, std::size_t count) noexcept {
  for (std::size_t k = 0; k < count; ++k) {
    if (old_of_new[k] == old) return true;
  }
  return false;
}

bool is_close(const WallSpring& old, const NewWallContacts& now, std::size_t k,
              double radius) noexcept {
  const double reach = kSamePoint * radius;
  return old.wall == now.wall[k] && old.normal.dot(now.normal[k]) > kSameNormal &&
         (old.point - now.point[k]).squaredNorm() < reach * reach;
}

}  // namespace

void match_wall_springs(std::span<const WallSpring> old, const NewWallContacts& now, double radius,
                        int* old_of_new) noexcept {
  const std::size_t count = now.wall.size();
  for (std::size_t k = 0; k < count; ++k) {
    old_of_new[k] = -1;
    for (std::size_t j = 0; j < old.size() && old_of_new[k] < 0; ++j) {
      const bool same = old[j].wall == now.wall[k] && old[j].feature == now.feature[k];
      if (same) old_of_new[k] = static_cast<int>(j);
    }
  }
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t j = 0; j < old.size() && old_of_new[k] < 0; ++j) {
      if (is_taken(static_cast<int>(j), old_of_new, count)) continue;
      if (is_close(old[j], now, k, radius)) old_of_new[k] = static_cast<int>(j);
    }
  }
}

}  // namespace quern
