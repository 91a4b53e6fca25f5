// Walls and their bodies from the numbers of the scene, and the domain that holds them.
#include <algorithm>
#include <cmath>

#include "scheduler/phases.h"
#include "scheduler/setup.h"
#include "scheduler/wear_setup.h"

namespace quern {

namespace {

class GeometryBuilder {
 public:
  GeometryBuilder(const Scene& scene, std::span<const ParticleSeed> particles)
      : scene_(scene), groups_(scene), largest_(radius_range(particles).second) {
    for (int a = 0; a < 3; ++a)
      out_.periodic[static_cast<std::size_t>(a)] = scene.domain.periodic[a];
    if (scene.mill && scene.mill->ends == EndKind::kPeriodic) out_.periodic[2] = true;
    for (const ParticleSeed& p : particles) {
      const bool placed = is_explicit(scene, p);
      if (placed) include(p.position, p.reach());
    }
  }

  SceneGeometry build(std::span<const std::vector<Triangle>> meshes) {
    if (scene_.mill) add_mill(*scene_.mill);
    for (std::size_t m = 0; m < meshes.size(); ++m) add_mesh(scene_.meshes[m], meshes[m]);
    for (const BoxSpec& box : scene_.boxes) {
      for (const Triangle& t : box_faces(box, scene_.run.gravity)) {
        for (const Vec3& c : t.corner) include_path(c, box.motion);
      }
      if (box.open_top) include(0.5 * (box.low + box.high) - rain_height() * down(), largest_);
      add(named(box), box.motion, box_faces(box, scene_.run.gravity));
    }
    choose_domain();
    for (const PlaneSpec& plane : scene_.planes) {
      const Vec3 centre = 0.5 * (out_.low + out_.high);
      add(named(plane), plane.motion,
          plane_patch(plane, centre, 2 * (out_.high - out_.low).norm()));
    }
    for (Pending& p : pending_) {
      out_.bodies.push_back({p.motion, build_facets(p.components, 3 * largest_), Pose(), {}});
    }
    return std::move(out_);
  }

 private:
  struct Pending {
    Motion motion;
    std::vector<FacetComponent> components;
  };

  Vec3 down() const { return scene_.run.gravity.normalized(); }
  double rain_height() const { return 2 * (high_ - low_).norm(); }

  void include(const Vec3& x, double margin) {
    low_ = low_.cwiseMin(Vec3(x - Vec3::Constant(margin)));
    high_ = high_.cwiseMax(Vec3(x + Vec3::Constant(margin)));
    bounded_ = true;
  }

  // A point of a wall, wherever its motion takes it.
  void include_path(const Vec3& x, const Motion& motion) {
    include(x, largest_);
    switch (motion.kind) {
      case MotionKind::kFixed:
        return;
      case MotionKind::kRotation:
        return include(motion.center, (x - motion.center).norm() + largest_);
      case MotionKind::kOscillation:
        return include(x, std::abs(motion.amplitude) + largest_);
      case MotionKind::kTranslation: {
        // Between two of the times it goes no farther than the rate allows.
        constexpr int kTimes = 256;
        const double span = run_time(scene_) / kTimes;
        for (int k = 0; k < kTimes; ++k) {
          include(pose_at(motion, k * span).shift + x,
                  largest_ + max_rate(motion, k * span, span) * span);
        }
      }
    }
  }

  struct Named {
    std::string name, material, group;
  };
  template <class Spec>
  static Named named(const Spec& spec) {
    return {spec.name, spec.material, spec.group};
  }

  void add(const Named& wall, const Motion& motion, std::vector<Triangle> triangles) {
    Pending* to = nullptr;
    for (Pending& p : pending_) {
      if (p.motion.kind == MotionKind::kFixed && motion.kind == MotionKind::kFixed) to = &p;
    }
    add_to(to, wall, motion, std::move(triangles));
  }

  void add_to(Pending* to, const Named& wall, const Motion& motion,
              std::vector<Triangle> triangles) {
    if (to == nullptr) {
      pending_.push_back({motion, {}});
      to = &pending_.back();
    }
    const Index body = static_cast<Index>(to - pending_.data());
    to->components.push_back({std::move(triangles), static_cast<Index>(out_.walls.size())});
    const std::size_t material = material_row(scene_, wall.material);
    out_.walls.push_back({wall.name, static_cast<std::uint32_t>(material), body,
                          static_cast<std::uint8_t>(groups_.row(wall.group))});
  }

  void add_mill(const MillSpec& mill) {
    Motion motion;
    motion.kind = MotionKind::kRotation;
    motion.rate = mill.rotation;
    // Beyond a wall the shell ends where no particle can see its rim; beyond a periodic end it has
    // to reach as far as a particle's radius does.
    const double beyond = mill.ends == EndKind::kOpen ? 0 : 2.5 * largest_;
    add_to(nullptr, {"liner", mill.material, mill.group}, motion,
           mill_shell(mill, -beyond, mill.length + beyond));
    if (mill.ends == EndKind::kWalls) {
      add_to(&pending_.back(),
             {"ends", mill.end_material.empty() ? mill.material : mill.end_material, mill.group},
             motion, mill_ends(mill));
    }
    const double radius = 0.5 * mill.diameter;
    include(Vec3(-radius, -radius, 0), 0);
    include(Vec3(radius, radius, mill.length), 0);
  }

  void add_mesh(const MeshWallSpec& mesh, const std::vector<Triangle>& triangles) {
    std::vector<Triangle> all = triangles;
    for (const Triangle& t : triangles) {
      for (const Vec3& c : t.corner) include_path(c, mesh.motion);
    }
    // Near a periodic face a particle meets the mesh's image as well.
    for (int a = 0; a < 3; ++a) {
      if (!out_.periodic[static_cast<std::size_t>(a)] || !scene_.domain.low) continue;
      const double low = (*scene_.domain.low)[a], high = (*scene_.domain.high)[a];
      const std::size_t count = all.size();
      for (std::size_t k = 0; k < count; ++k) add_images(all[k], a, low, high, all);
    }
    add(named(mesh), mesh.motion, std::move(all));
  }

  void add_images(const Triangle t, int axis, double low, double high,
                  std::vector<Triangle>& to) const {
    for (const double shift : {low - high, high - low}) {
      Triangle image = t;
      double lowest = 1e300, highest = -1e300;
      for (Vec3& c : image.corner) {
        c[axis] += shift;
        lowest = std::min(lowest, c[axis]);
        highest = std::max(highest, c[axis]);
      }
      if (lowest < high + 2.5 * largest_ && highest > low - 2.5 * largest_) to.push_back(image);
    }
  }

  void choose_domain() {
    if (!bounded_ && !(scene_.domain.low && scene_.domain.high)) {
      throw UserError("the scene has no bounds: give [domain] low and high");
    }
    const bool open = !scene_.mill && scene_.meshes.empty() && scene_.boxes.empty();
    const double extra = open && bounded_ ? 1 + 10 * (high_ - low_).norm() : 0;
    out_.low = scene_.domain.low.value_or(low_ - Vec3::Constant(extra));
    out_.high = scene_.domain.high.value_or(high_ + Vec3::Constant(extra));
    if (scene_.mill && scene_.mill->ends == EndKind::kPeriodic) {
      out_.low.z() = 0;
      out_.high.z() = scene_.mill->length;
    }
    for (int a = 0; a < 3; ++a) {
      if (!out_.periodic[static_cast<std::size_t>(a)]) continue;
      if (out_.high[a] - out_.low[a] < 4 * largest_) {
        throw UserError("the periodic length along " + std::string(1, "xyz"[a]) +
                        " is below two diameters of the largest particle");
      }
    }
  }

  const Scene& scene_;
  Groups groups_;
  double largest_;
  SceneGeometry out_;
  std::vector<Pending> pending_;
  Vec3 low_ = Vec3::Constant(1e300), high_ = Vec3::Constant(-1e300);
  bool bounded_ = false;
};

}  // namespace

std::pair<double, double> radius_range(std::span<const ParticleSeed> particles) {
  double low = 1e300, high = 0;
  for (const ParticleSeed& p : particles) {
    low = std::min(low, p.inner());
    high = std::max(high, p.reach());
  }
  if (high == 0) throw UserError("the scene has no particles");
  return {low, high};
}

std::vector<const Facets*> SceneGeometry::facets() const {
  std::vector<const Facets*> all;
  for (const Body& body : bodies) all.push_back(&body.facets);
  return all;
}

SceneGeometry build_geometry(const Scene& scene, std::span<const std::vector<Triangle>> meshes,
                             std::span<const ParticleSeed> particles) {
  return GeometryBuilder(scene, particles).build(meshes);
}

void include_fill(const Scene& scene, const Vec3& low, const Vec3& high, SceneGeometry& geometry) {
  for (int a = 0; a < 3; ++a) {
    if (geometry.periodic[static_cast<std::size_t>(a)]) continue;
    if (!scene.domain.low) geometry.low[a] = std::min(geometry.low[a], low[a]);
    if (!scene.domain.high) geometry.high[a] = std::max(geometry.high[a], high[a]);
  }
}

}  // namespace quern
