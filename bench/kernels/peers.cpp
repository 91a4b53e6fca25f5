// Adapters of libccd, FCL and Bullet; see peers.h.
//
// Each library gets its own recommended form of a convex body: libccd the linear scan over vertices
// that its users write, FCL a Convex with its faces, Bullet a convex hull without margin (a ball is
// all margin in Bullet, a ball of its own kind elsewhere). Tolerances are absolute, for bodies of
// about 1 m, and chosen by the depths they give: a looser one than 1e-10 leaves libccd's EPA on a
// ball's curved side with depths a third off, a tighter one than 1e-6 makes its MPR worse within
// 100 rounds.
#include "bench/kernels/peers.h"

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>
#include <ccd/ccd.h>
#include <fcl/fcl.h>

#include <map>
#include <utility>

namespace quern::peers {
namespace {

// What a library made of a (shape, scale), shared by all pairs that use it.
template <class Made, class Make>
const Made& made_for(std::map<std::pair<const Shape*, double>, Made>& all, const ShapePose& body,
                     Make make) {
  const std::pair<const Shape*, double> key{body.shape, body.scale};
  const auto found = all.find(key);
  return found != all.end() ? found->second : all.emplace(key, make(body)).first->second;
}

struct CcdBody {
  const std::vector<Vec3>* corners;  // null: a ball
  double radius;
  Vec3 place;
  Mat3 turn;
};

void ccd_support(const void* body, const ccd_vec3_t* direction, ccd_vec3_t* out) {
  const auto& b = *static_cast<const CcdBody*>(body);
  const Vec3 u(direction->v[0], direction->v[1], direction->v[2]);
  Vec3 best;
  if (b.corners == nullptr) {
    best = b.place + b.radius / u.norm() * u;
  } else {
    const Vec3 local = b.turn.transpose() * u;
    const Vec3* farthest = b.corners->data();
    double reach = local.dot(*farthest);
    for (const Vec3& v : *b.corners) {
      const double r = local.dot(v);
      if (r > reach) {
        reach = r;
        farthest = &v;
      }
    }
    best = b.place + b.turn * *farthest;
  }
  ccdVec3Set(out, best.x(), best.y(), best.z());
}

void ccd_center(const void* body, ccd_vec3_t* out) {
  const Vec3& p = static_cast<const CcdBody*>(body)->place;
  ccdVec3Set(out, p.x(), p.y(), p.z());
}

class Ccd final : public Peer {
 public:
  enum class Method { kEpa, kMpr };
  explicit Ccd(Method method) : method_(method) {
    CCD_INIT(&ccd_);
    ccd_.support1 = ccd_.support2 = ccd_support;
    ccd_.center1 = ccd_.center2 = ccd_center;
    ccd_.max_iterations = 100;
    ccd_.epa_tolerance = 1e-10;
    ccd_.mpr_tolerance = 1e-6;
  }
  const char* name() const override {
    return method_ == Method::kEpa ? "libccd GJK/EPA" : "libccd MPR";
  }
  void load(const std::vector<BodyPair>& pairs) override {
    pairs_ = pairs;
    corners_.clear();
    use_.clear();
    for (const BodyPair& pair : pairs) use_.emplace_back(body_of(pair.a), body_of(pair.b));
  }
  Hit touch(std::size_t pair) override {
    CcdBody a = use_[pair].first, b = use_[pair].second;
    set_pose(pairs_[pair].a, a);
    set_pose(pairs_[pair].b, b);
    ccd_real_t depth = 0;
    ccd_vec3_t direction{}, place{};
    const int apart = method_ == Method::kEpa
                          ? ccdGJKPenetration(&a, &b, &ccd_, &depth, &direction, &place)
                          : ccdMPRPenetration(&a, &b, &ccd_, &depth, &direction, &place);
    if (apart != 0) return {};
    return {true, depth, Vec3(direction.v[0], direction.v[1], direction.v[2])};
  }

 private:
  static void set_pose(const ShapePose& pose, CcdBody& body) {
    body.place = pose.place;
    body.turn = pose.turn;
  }
  CcdBody body_of(const ShapePose& pose) {
    if (pose.shape == nullptr) return {nullptr, pose.scale, {}, {}};
    const auto& corners = made_for(corners_, pose, [](const ShapePose& p) {
      std::vector<Vec3> v;
      for (std::size_t k = 0; k < p.shape->vertices; ++k) v.push_back(p.scale * p.shape->vertex(k));
      return v;
    });
    return {&corners, 0, {}, {}};
  }

  Method method_;
  ccd_t ccd_;
  std::vector<BodyPair> pairs_;
  std::vector<std::pair<CcdBody, CcdBody>> use_;
  std::map<std::pair<const Shape*, double>, std::vector<Vec3>> corners_;
};

using FclGeometry = std::shared_ptr<fcl::CollisionGeometryd>;

FclGeometry fcl_geometry(const ShapePose& pose) {
  if (pose.shape == nullptr) return std::make_shared<fcl::Sphered>(pose.scale);
  const Shape& s = *pose.shape;
  const auto vertices = std::make_shared<std::vector<fcl::Vector3d>>();
  for (std::size_t k = 0; k < s.vertices; ++k) vertices->push_back(pose.scale * s.vertex(k));
  const auto faces = std::make_shared<std::vector<int>>();
  for (std::size_t f = 0; f < s.faces; ++f) {
    faces->push_back(s.face_begin[f + 1] - s.face_begin[f]);
    for (std::size_t k = s.face_begin[f]; k < s.face_begin[f + 1]; ++k) {
      faces->push_back(s.face_vertex[k]);
    }
  }
  return std::make_shared<fcl::Convexd>(vertices, static_cast<int>(s.faces), faces);
}

class Fcl final : public Peer {
 public:
  explicit Fcl(fcl::GJKSolverType solver) : request_(1, true) {
    request_.gjk_solver_type = solver;
    request_.gjk_tolerance = 1e-6;
  }
  const char* name() const override {
    return request_.gjk_solver_type == fcl::GST_LIBCCD ? "FCL (libccd)" : "FCL (own GJK/EPA)";
  }
  void load(const std::vector<BodyPair>& pairs) override {
    pairs_ = pairs;
    geometry_.clear();
    use_.clear();
    for (const BodyPair& p : pairs) {
      use_.emplace_back(made_for(geometry_, p.a, fcl_geometry),
                        made_for(geometry_, p.b, fcl_geometry));
    }
  }
  Hit touch(std::size_t pair) override {
    const BodyPair& p = pairs_[pair];
    fcl::CollisionResultd result;
    fcl::collide(use_[pair].first.get(), pose_of(p.a), use_[pair].second.get(), pose_of(p.b),
                 request_, result);
    if (!result.isCollision()) return {};
    const fcl::Contactd& c = result.getContact(0);
    // Its own solver leaves the normal in the frame of the first body.
    const bool own = request_.gjk_solver_type == fcl::GST_INDEP;
    return {true, std::abs(c.penetration_depth), own ? Vec3(p.a.turn * c.normal) : c.normal};
  }

 private:
  static fcl::Transform3d pose_of(const ShapePose& pose) {
    fcl::Transform3d t = fcl::Transform3d::Identity();
    t.linear() = pose.turn;
    t.translation() = pose.place;
    return t;
  }

  fcl::CollisionRequestd request_;
  std::vector<BodyPair> pairs_;
  std::vector<std::pair<FclGeometry, FclGeometry>> use_;
  std::map<std::pair<const Shape*, double>, FclGeometry> geometry_;
};

using BulletShape = std::shared_ptr<btConvexShape>;

BulletShape bullet_shape(const ShapePose& pose) {
  if (pose.shape == nullptr) return std::make_shared<btSphereShape>(btScalar(pose.scale));
  const auto hull = std::make_shared<btConvexHullShape>();
  for (std::size_t k = 0; k < pose.shape->vertices; ++k) {
    const Vec3 v = pose.scale * pose.shape->vertex(k);
    hull->addPoint(btVector3(btScalar(v.x()), btScalar(v.y()), btScalar(v.z())), false);
  }
  hull->setMargin(0);
  hull->recalcLocalAabb();
  return hull;
}

class Bullet final : public Peer {
 public:
  const char* name() const override { return "Bullet GJK/EPA (f32)"; }
  void load(const std::vector<BodyPair>& pairs) override {
    pairs_ = pairs;
    shape_.clear();
    use_.clear();
    for (const BodyPair& p : pairs) {
      use_.emplace_back(made_for(shape_, p.a, bullet_shape), made_for(shape_, p.b, bullet_shape));
    }
  }
  Hit touch(std::size_t pair) override {
    const BodyPair& p = pairs_[pair];
    btGjkPairDetector detector(use_[pair].first.get(), use_[pair].second.get(), &simplex_, &epa_);
    btGjkPairDetector::ClosestPointInput input;
    input.m_transformA = pose_of(p.a);
    input.m_transformB = pose_of(p.b);
    btPointCollector result;
    detector.getClosestPoints(input, result, nullptr);
    if (!result.m_hasResult || result.m_distance >= 0) return {};
    const btVector3& n = result.m_normalOnBInWorld;  // from b to a
    return {true, -double(result.m_distance), -Vec3(n.x(), n.y(), n.z())};
  }

 private:
  static btTransform pose_of(const ShapePose& pose) {
    btMatrix3x3 m;
    for (int r = 0; r < 3; ++r) {
      m[r].setValue(btScalar(pose.turn(r, 0)), btScalar(pose.turn(r, 1)),
                    btScalar(pose.turn(r, 2)));
    }
    return btTransform(
        m, btVector3(btScalar(pose.place.x()), btScalar(pose.place.y()), btScalar(pose.place.z())));
  }

  std::vector<BodyPair> pairs_;
  std::vector<std::pair<BulletShape, BulletShape>> use_;
  std::map<std::pair<const Shape*, double>, BulletShape> shape_;
  btVoronoiSimplexSolver simplex_;
  btGjkEpaPenetrationDepthSolver epa_;
};

}  // namespace

std::vector<std::unique_ptr<Peer>> all_peers() {
  std::vector<std::unique_ptr<Peer>> peers;
  peers.push_back(std::make_unique<Ccd>(Ccd::Method::kEpa));
  peers.push_back(std::make_unique<Ccd>(Ccd::Method::kMpr));
  peers.push_back(std::make_unique<Fcl>(fcl::GST_LIBCCD));
  peers.push_back(std::make_unique<Fcl>(fcl::GST_INDEP));
  peers.push_back(std::make_unique<Bullet>());
  return peers;
}

}  // namespace quern::peers
