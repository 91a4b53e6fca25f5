// Scene: what the user asked for, in SI, after reading and before any particle exists.
//
// io/scene_reader fills it from TOML, scheduler/setup turns it into a World; tests build it by hand.
// It is plain data: no behaviour beyond lookups. Every default stands here and nowhere else.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "soa/force_law.h"
#include "soa/precision.h"
#include "soa/shapes.h"

namespace quern {

enum class NormalForce { kClamped, kUnclamped };
enum class EndKind { kWalls, kPeriodic, kOpen };
enum class StartKind { kFill, kFile };
enum class FillMethod { kSegment, kRandom, kRain };
enum class SettleKind { kNone, kDuration, kUntilRest };
enum class ShapeKind { kSphere, kPolyhedron };

// A rate over time: linear between (time, value) points, constant before the first and after the
// last. A constant is one point. Values: rad/s for rotation, m/s for translation.
struct Schedule {
  struct Point {
    double time = 0;
    double value = 0;
  };
  std::vector<Point> points = {{0, 0}};
};

enum class MotionKind { kFixed, kRotation, kTranslation, kOscillation };

// How a wall moves from t = 0 on (it stands still while the charge settles).
//   rotation     by the right-hand rule about `axis` through `center` at rate(t) [rad/s]
//   translation  along `axis` (unit) at rate(t) [m/s]
//   oscillation  displacement amplitude * sin(2 pi frequency t) along `axis`
struct Motion {
  MotionKind kind = MotionKind::kFixed;
  Vec3 axis = Vec3::UnitZ();
  Vec3 center = Vec3::Zero();
  Schedule rate;
  double amplitude = 0;  // m
  double frequency = 0;  // Hz
};

struct Material {
  std::string name;
  double density = 0;   // kg/m^3; 0 is allowed for materials that only walls use
  double hardness = 0;  // Vickers, HV; 0: not given
  // Of kHertzMindlin, and not used by the other law.
  std::optional<double> young_modulus = std::nullopt;  // Pa
  std::optional<double> poisson_ratio = std::nullopt;
};

// Coefficients of a pair of materials; what is absent falls back to ContactSpec's defaults.
struct PairCoefficients {
  std::string a, b;
  std::optional<double> normal_stiffness, tangential_stiffness;  // N/m
  std::optional<double> restitution, sliding_friction, rolling_friction;
};

struct ContactSpec {
  ForceLaw law = ForceLaw::kLinearSpringDashpot;
  NormalForce normal_force = NormalForce::kClamped;
  bool tangential_damping = true;
  std::optional<double> normal_stiffness, tangential_stiffness;  // N/m
  std::optional<double> restitution, sliding_friction;
  double rolling_friction = 0;
  OverlapMeasure overlap = OverlapMeasure::kChord;
  NormalModel normal_model = NormalModel::kStiffness;
  // Pa, kVolume only; default: normal stiffness over the equivalent radius of the smaller body
  std::optional<double> volume_stiffness;
  // m/s, kHertzMindlin: the fastest impact that steps are advised for; default: typical_speed()
  std::optional<double> impact_speed = std::nullopt;
  bool patch_damping = true;  // dashpots over the area of a polyhedron's contact
  std::vector<PairCoefficients> pairs;
};

struct LifterSpec {
  int count = 0;
  double height = 0;      // m, on the mid-plane
  double face_angle = 0;  // rad, of both faces from the mid-plane (the base is the wider end)
  double top_width = 0;   // m
};

// A mill by its numbers: axis +z through the origin, z from 0 to length, lifter k centred at
// angle 2 pi k / count from +x at t = 0, its height measured on its mid-plane.
struct MillSpec {
  std::string material;
  std::string end_material;  // empty: material
  double diameter = 0, length = 0;  // m
  EndKind ends = EndKind::kWalls;
  int pieces_per_arc = 4;  // straight pieces of the shell between two lifters (all around: none)
  std::optional<LifterSpec> lifters;
  Schedule rotation;  // rad/s; positive: counterclockwise seen from +z
  std::string group = "liner";
};

struct MeshWallSpec {
  std::string name, path, material;
  double scale = 1;  // file units to m
  Motion motion;
  std::string group = "liner";
};

struct PlaneSpec {
  std::string name, material;
  Vec3 point = Vec3::Zero(), normal = Vec3::UnitZ();  // the normal points to the charge
  Motion motion;
  std::string group = "liner";
};

// A closed or open box, walls facing inwards.
struct BoxSpec {
  std::string name, material;
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();
  bool open_top = false;  // no face against gravity
  Motion motion;
  std::string group = "liner";
};

// One size class: diameters (of polyhedra: of the sphere of equal volume) uniform in [from, to]. Exactly one of count, mass_share is set.
struct SizeClass {
  double from = 0, to = 0;  // m
  std::optional<long> count;
  std::optional<double> mass_share;  // of the species' mass
  std::optional<ShapeKind> shape = std::nullopt;  // default: that of the species
};

enum class DistributionKind { kNone, kPassingTable, kRosinRammler };

// Cumulative mass passing over diameter. Table: (diameter, passing 0..1), log-linear between.
// Rosin-Rammler: passing = 1 - exp(-(d/d63)^n), cut to [from, to].
struct SizeDistribution {
  DistributionKind kind = DistributionKind::kNone;
  std::vector<std::pair<double, double>> passing;
  double d63 = 0, exponent = 0, from = 0, to = 0;
};

// By `angle` about `axis` (unit), right-handed.
struct Turn {
  Vec3 axis = Vec3::UnitZ();
  double angle = 0;  // rad
};

struct ExplicitParticle {
  Vec3 position = Vec3::Zero(), velocity = Vec3::Zero(), spin = Vec3::Zero();
  double diameter = 0;
  // Of a polyhedron, from how its mesh lies in its file; default: random
  std::optional<Turn> orientation = std::nullopt;
};

// A species of particles ("[[particles]]"). Sizes come from exactly one of: diameter, sizes,
// distribution, explicit_particles, csv. Amount from exactly one of: count, mass, filling_level,
// the counts inside sizes, or the explicit list.
struct ParticleSpec {
  std::string name, material;
  ShapeKind shape = ShapeKind::kSphere;
  std::vector<std::string> meshes;  // STL files of its polyhedra, dealt in turn by identity
  bool hull = false;                // meshes that are no convex body are taken by their hull
  std::optional<double> diameter;  // m
  std::vector<SizeClass> sizes;
  SizeDistribution distribution;
  std::optional<long> count;
  std::optional<double> mass;           // kg
  std::optional<double> filling_level;  // share of the mill's volume taken by the bulk, porosity 0.4
  std::vector<ExplicitParticle> explicit_particles;  // also filled from `csv` by the reader
  std::string csv;
  std::string group;  // see soa/groups.h; empty: the name
};

inline ShapeKind shape_of(const ParticleSpec& species, const SizeClass& size) {
  return size.shape.value_or(species.shape);
}

inline bool has_polyhedra(const ParticleSpec& species) {
  if (species.sizes.empty()) return species.shape == ShapeKind::kPolyhedron;
  for (const SizeClass& size : species.sizes)
    if (shape_of(species, size) == ShapeKind::kPolyhedron) return true;
  return false;
}

struct FillSpec {
  FillMethod method = FillMethod::kSegment;
  // Where particles may be placed; default: inside the mill, the box or the domain.
  std::optional<Vec3> low, high;
  double max_fraction = 0.42;  // solid fraction aimed at in the segment
  double over = 0;             // kRain: inserted from above over this time (s)
  Vec3 velocity = Vec3::Zero();
};

struct RunSpec {
  std::string title;
  std::optional<double> duration;     // s after t = 0
  std::optional<double> revolutions;  // of the mill after t = 0
  std::optional<double> record_from, record_from_revolution;
  std::optional<double> time_step;  // s; default: smallest contact time / 25
  std::uint64_t seed = 1;
  Vec3 gravity{0, -9.81, 0};
  SettleKind settle = SettleKind::kNone;
  double settle_time = 0;       // kDuration: total; kUntilRest: the most allowed (0: automatic)
  double soft_stiffness = 0.01;  // stiffness factor of the soft phase; 1: no soft phase
  double calm_time = 0.12;       // s, with a drag at full stiffness, after the soft phase
  StartKind start = StartKind::kFill;
  std::string start_file;
  // s: overlaps of the start are let go gently before all else; default: 0.2 where spheres of
  // start_file become polyhedra, else 0
  std::optional<double> relax;
  // m, while relaxing: contacts, of spheres too, push as if no deeper than this; default: those of
  // polyhedra alone are capped
  std::optional<double> overlap_cap;
  Precision precision = Precision::kMixed;
  std::optional<Index> tile_size;
  std::optional<double> list_slack;  // m
};

struct DomainSpec {
  std::optional<Vec3> low, high;  // default: bounds of walls and particles
  bool periodic[3] = {false, false, false};
};

struct OutputSpec {
  double series_every = 0;      // s; 0: 1/1000 of the duration
  double frames_every = 0;      // s; 0: no frames
  bool contacts = false;        // in frames
  double checkpoint_every = 600;  // s of wall clock
};

// A part of the mill's cross-section, over the whole length: between two radii and, going
// counterclockwise, two angles from +x about the axis +z through the origin. It stands still while
// the mill turns. angle_to below angle_from goes on through a full turn.
struct ZoneSpec {
  std::string name;
  double radius_from = 0;           // m
  std::optional<double> radius_to;  // m; default: no limit
  double angle_from = 0, angle_to = 2 * kPi;  // rad
};

// What a run works out of its recorded window besides the series; what is not asked costs nothing.
struct RecordSpec {
  bool collisions = false;    // power by kind of collision, collision spectra
  bool charge_shape = false;  // the map of solid fraction; shoulder and toe
  bool classes = false;        // motion of each size class
  double snapshots_every = 0;  // s; 0: 1/100 of the recorded window
  double cell_angle = 0;       // rad, of the map; 0: chosen from mill and particles
  double cell_width = 0;       // m; 0: half the median diameter
  std::vector<ZoneSpec> zones;
};

// Whose velocity says whether friction brakes a particle or its spin drives it.
enum class WearVelocity { kLiner, kAbsolute };

// Wear of walls, by four models at once from what contacts do; kernels/README.md has them.
struct WearSpec {
  double cell_size = 0;  // m, of the cells of walls; 0: chosen from the walls
  WearVelocity velocity = WearVelocity::kLiner;
  std::optional<double> flow_pressure;  // Pa, of walls; default: 1.5 hardness of each wall's material
  double siem_factor = 1, archard_factor = 1, finnie_factor = 1;  // calibration
  double archard_coefficient = 0;  // k of k F s / H; 0: not given, no figures by Archard
  double finnie_depth_ratio = 2, finnie_force_ratio = 2;  // psi, K
};

struct Scene {
  RunSpec run;
  DomainSpec domain;
  ContactSpec contact;
  std::vector<Material> materials;
  std::optional<MillSpec> mill;
  std::vector<MeshWallSpec> meshes;
  std::vector<PlaneSpec> planes;
  std::vector<BoxSpec> boxes;
  FillSpec fill;
  std::vector<ParticleSpec> particles;
  OutputSpec output;
  RecordSpec record;
  std::optional<WearSpec> wear;
  std::string text;      // the scene as read, for provenance
  std::string folder;    // relative paths start here
};

}  // namespace quern
