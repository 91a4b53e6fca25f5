// THE table of scene keys: one function per table of a scene says which keys it has, their units,
// ranges and meaning, and which member of soa/scene.h each fills.
//
// The same functions read a scene (TableReader), write it (SceneWriter) and list the keys for
// `info` and for suggestions (KeyLister): `Io` is one of the three. Defaults stand in soa/scene.h
// alone: an Io is given the default-made struct. To add a key, add the member there and a line
// here.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/quantity.h"
#include "io/scene_reader.h"
#include "soa/scene.h"

namespace quern {

enum class Range { kAny, kPositive, kNotNegative, kFraction, kShare, kPoisson, kAcute };
enum class Need { kOptional, kRequired };

struct Key {
  const char* name;
  const char* doc;
  Dimension dimension = Dimension::kNumber;
  Range range = Range::kAny;
  Need need = Need::kOptional;
};

using Words = std::span<const char* const>;

// The words of each enumeration, in its order.
enum class Direction { kCounterclockwise, kClockwise };
enum class WallKind { kMesh, kPlane, kBox };
inline constexpr const char* kNormalForceWords[] = {"clamped", "unclamped"};
inline constexpr const char* kEndWords[] = {"walls", "periodic", "open"};
inline constexpr const char* kStartWords[] = {"fill", "file"};
inline constexpr const char* kFillWords[] = {"segment", "random", "rain"};
inline constexpr const char* kMotionWords[] = {"fixed", "rotation", "translation", "oscillation"};
inline constexpr const char* kDirectionWords[] = {"counterclockwise", "clockwise"};
inline constexpr const char* kWallWords[] = {"mesh", "plane", "box"};
inline constexpr const char* kSettleWords[] = {"none", "until-rest"};
inline constexpr const char* kLawWords[] = {"linear-spring-dashpot", "hertz-mindlin"};
inline constexpr const char* kShapeWords[] = {"sphere", "polyhedron"};
inline constexpr const char* kOverlapWords[] = {"chord", "width"};
inline constexpr const char* kNormalModelWords[] = {"stiffness", "volume"};
inline constexpr const char* kWearVelocityWords[] = {"liner", "absolute"};

inline Words words_of(Precision) { return kPrecisionWords; }
inline Words words_of(NormalForce) { return kNormalForceWords; }
inline Words words_of(EndKind) { return kEndWords; }
inline Words words_of(StartKind) { return kStartWords; }
inline Words words_of(FillMethod) { return kFillWords; }
inline Words words_of(MotionKind) { return kMotionWords; }
inline Words words_of(Direction) { return kDirectionWords; }
inline Words words_of(WallKind) { return kWallWords; }
inline Words words_of(ForceLaw) { return kLawWords; }
inline Words words_of(ShapeKind) { return kShapeWords; }
inline Words words_of(OverlapMeasure) { return kOverlapWords; }
inline Words words_of(NormalModel) { return kNormalModelWords; }
inline Words words_of(WearVelocity) { return kWearVelocityWords; }

// Any of [[walls]], before it is sorted by kind.
struct WallSpec {
  std::string name;
  std::optional<WallKind> kind;
  std::string mesh;
  std::optional<double> scale;
  std::optional<Vec3> point, normal, low, high;
  std::optional<bool> open_top;
  std::string material, group = "liner";
  Motion motion;
};

struct SceneDraft {
  int format = 1;
  Scene scene;
  std::vector<WallSpec> walls;
  StartFile start_file = StartFile::kNeeded;
  // See SceneResult.
  std::vector<std::string> wall_mesh_places;
  std::vector<std::vector<std::string>> shape_mesh_places;
};

template <class Io>
void fields(Io& io, RunSpec& run) {
  using enum Dimension;
  io({"title", "one line for reports"}, run.title);
  io({"duration", "length of the run after the mill starts", kTime, Range::kPositive},
     run.duration);
  io({"revolutions", "the same in turns of the mill", kNumber, Range::kPositive}, run.revolutions);
  io({"record_from", "statistics begin here", kTime, Range::kNotNegative}, run.record_from);
  io({"record_from_revolution", "the same in turns of the mill", kNumber, Range::kNotNegative},
     run.record_from_revolution);
  io({"time_step", "default: smallest contact time / 25", kTime, Range::kPositive}, run.time_step);
  io({"seed", "of every random choice", kNumber, Range::kNotNegative}, run.seed);
  io({"gravity", "acceleration", kAcceleration}, run.gravity);
  settle_fields(io, run);
  io({"soft_stiffness", "stiffness factor of the soft phase of settling; 1: no soft phase", kNumber,
      Range::kFraction},
     run.soft_stiffness);
  io({"calm", "how long a drag takes the swinging away after a soft phase, before the last 0.1 s",
      kTime, Range::kNotNegative},
     run.calm_time);
  io({"start", "place the particles, or take them from start_file"}, run.start);
  io({"start_file", "checkpoint to start from"}, run.start_file);
  io({"relax", "overlaps of the start are let go this long, under a drag, before all else; default: "
      "0.2 s if spheres become polyhedra, else 0 s",
      kTime, Range::kNotNegative},
     run.relax);
  io({"overlap_cap", "while relaxing all contacts push as if no deeper than this at the end, a "
      "hundredth of it at the start; default: off, contacts of polyhedra alone are capped",
      kLength, Range::kPositive},
     run.overlap_cap);
  io({"precision",
      "of forces and springs; single is mixed with a faster search for who touches; places, "
      "velocities and spins are always double"},
     run.precision);
  io({"tile_size", "particles per tile; default: a 32nd of all, 512 to 2048", kNumber,
      Range::kPositive},
     run.tile_size);
  io({"list_slack", "extra reach of neighbour lists; default: automatic", kLength,
      Range::kPositive},
     run.list_slack);
}

template <class Io>
void settle_fields(Io& io, RunSpec& run) {
  using enum Dimension;
  io.word_or_quantity({"settle", "how long the charge rests before t = 0", kTime, Range::kPositive},
                      kSettleWords,
                      run.settle == SettleKind::kDuration    ? -1
                      : run.settle == SettleKind::kUntilRest ? 1
                                                             : 0,
                      run.settle_time, [&run](int word) {
                        run.settle = word < 0    ? SettleKind::kDuration
                                     : word == 1 ? SettleKind::kUntilRest
                                                 : SettleKind::kNone;
                      });
  double limit = run.settle == SettleKind::kUntilRest ? run.settle_time : 0;
  io({"settle_limit", "most time for until-rest; 0: automatic", kTime, Range::kNotNegative}, limit);
  if (run.settle == SettleKind::kUntilRest) run.settle_time = limit;
}

template <class Io>
void fields(Io& io, DomainSpec& domain) {
  io({"low", "lower corner; default: bounds of walls and particles", Dimension::kLength},
     domain.low);
  io({"high", "upper corner", Dimension::kLength}, domain.high);
  io.axes({"periodic", "periodic axes, of \"x\", \"y\", \"z\""}, domain.periodic);
}

// The coefficients that [contact] and [[contact.pair]] share. Spec is either.
template <class Io, class Spec>
void coefficient_fields(Io& io, Spec& spec) {
  using enum Dimension;
  io({"normal_stiffness", "spring along the normal, of the linear law", kStiffness,
      Range::kPositive},
     spec.normal_stiffness);
  io({"tangential_stiffness", "spring along the surface, of the linear law", kStiffness,
      Range::kPositive},
     spec.tangential_stiffness);
  io({"restitution", "rebound speed over impact speed", kNumber, Range::kFraction},
     spec.restitution);
  io({"sliding_friction", "Coulomb coefficient", kNumber, Range::kNotNegative},
     spec.sliding_friction);
  io({"rolling_friction", "rolling coefficient", kNumber, Range::kNotNegative},
     spec.rolling_friction);
}

template <class Io>
void fields(Io& io, PairCoefficients& pair) {
  io.pair({"between", "the two materials", Dimension::kNumber, Range::kAny, Need::kRequired},
          pair.a, pair.b);
  coefficient_fields(io, pair);
}

template <class Io>
void fields(Io& io, ContactSpec& contact) {
  io({"law", "springs of all contacts"}, contact.law);
  io({"normal_force", "clamped: never pulls; unclamped: the plain dashpot"}, contact.normal_force);
  io({"tangential_damping", "dashpot along the surface"}, contact.tangential_damping);
  coefficient_fields(io, contact);
  io({"overlap", "of polyhedra: longest chord along the normal, or width of the whole overlap"},
     contact.overlap);
  io({"normal_model", "of polyhedra: stiffness times overlap, or gradient of an overlap volume"},
     contact.normal_model);
  io({"volume_stiffness", "of normal_model = \"volume\"; default: stiffness / smaller radius",
      Dimension::kPressure, Range::kPositive},
     contact.volume_stiffness);
  io({"impact_speed",
      "of law = \"hertz-mindlin\", for advice on steps; default: of walls, falls, first velocities",
      Dimension::kSpeed, Range::kPositive},
     contact.impact_speed);
  io({"patch_damping", "of polyhedra: dashpots against rocking and drilling"},
     contact.patch_damping);
  io.tables({"pair", "coefficients of a pair of materials"}, contact.pairs);
}

template <class Io>
void fields(Io& io, Material& material) {
  using enum Dimension;
  io({"density", "needed where particles use the material", kDensity, Range::kNotNegative},
     material.density);
  io({"hardness", "Vickers; 0: not given", kHardness, Range::kNotNegative}, material.hardness);
  io({"young_modulus", "of law = \"hertz-mindlin\"", kPressure, Range::kPositive},
     material.young_modulus);
  io({"poisson_ratio", "of law = \"hertz-mindlin\"", kNumber, Range::kPoisson},
     material.poisson_ratio);
}

template <class Io>
void fields(Io& io, LifterSpec& lifters) {
  using enum Dimension;
  using enum Need;
  io({"count", "around the shell", kNumber, Range::kPositive, kRequired}, lifters.count);
  io({"height", "on the mid-plane", kLength, Range::kPositive, kRequired}, lifters.height);
  io({"face_angle", "of both faces from the mid-plane", kAngle, Range::kAcute}, lifters.face_angle);
  io({"top_width", "of the top plate", kLength, Range::kPositive, kRequired}, lifters.top_width);
}

template <class Io>
void fields(Io& io, MillSpec& mill) {
  using enum Dimension;
  using enum Need;
  io({"material", "of shell and lifters", kNumber, Range::kAny, kRequired}, mill.material);
  io({"end_material", "of the end walls; default: material"}, mill.end_material);
  io({"group", "of walls whose collisions are told together"}, mill.group);
  io({"diameter", "inside the shell", kLength, Range::kPositive, kRequired}, mill.diameter);
  io({"length", "along the axis", kLength, Range::kPositive, kRequired}, mill.length);
  io({"ends", "what closes the mill at z = 0 and z = length"}, mill.ends);
  io({"pieces_per_arc", "straight pieces of the shell between two lifters", kNumber,
      Range::kPositive},
     mill.pieces_per_arc);
  io({"rotation", "a rate, or a schedule [{ time, value }, ...]", kAngularVelocity}, mill.rotation);
  Direction direction = Direction::kCounterclockwise;
  io({"direction", "of a positive rotation, seen from +z"}, direction);
  if (direction == Direction::kClockwise)
    for (Schedule::Point& point : mill.rotation.points) point.value = -point.value;
  io.table({"lifters", "lifter k is centred at 2 pi k / count from +x"}, mill.lifters);
}

template <class Io>
void fields(Io& io, Motion& motion) {
  using enum Dimension;
  io({"kind", "how the wall moves from t = 0 on"}, motion.kind);
  io({"axis", "direction, of any length"}, motion.axis);
  io({"center", "a point of the axis of rotation", kLength}, motion.center);
  io({"rate", "angular velocity (rotation) or speed (translation), or a schedule of it",
      motion.kind == MotionKind::kTranslation ? kSpeed : kAngularVelocity},
     motion.rate);
  io({"amplitude", "of an oscillation", kLength, Range::kNotNegative}, motion.amplitude);
  io({"frequency", "of an oscillation", kFrequency, Range::kNotNegative}, motion.frequency);
}

template <class Io>
void fields(Io& io, WallSpec& wall) {
  using enum Dimension;
  io({"name", "default: wall_1, wall_2, ..."}, wall.name);
  io({"kind", "default: what the other keys say"}, wall.kind);
  io({"group", "of walls whose collisions are told together"}, wall.group);
  io({"material", "of the surface", kNumber, Range::kAny, Need::kRequired}, wall.material);
  io({"mesh", "mesh: STL file"}, wall.mesh);
  io({"scale", "mesh: file units to metres", kNumber, Range::kPositive}, wall.scale);
  io({"point", "plane: a point of it", kLength}, wall.point);
  io({"normal", "plane: direction to the charge, of any length"}, wall.normal);
  io({"low", "box: lower corner", kLength}, wall.low);
  io({"high", "box: upper corner", kLength}, wall.high);
  io({"open_top", "box: no face against gravity"}, wall.open_top);
  io.table({"motion", "default: fixed"}, wall.motion);
}

template <class Io>
void fields(Io& io, FillSpec& fill) {
  using enum Dimension;
  io({"method", "segment: at rest in the mill; random: anywhere; rain: from above"}, fill.method);
  io({"low", "lower corner of where particles may be; default: all", kLength}, fill.low);
  io({"high", "upper corner", kLength}, fill.high);
  io({"max_fraction", "solid fraction aimed at in the segment", kShare, Range::kFraction},
     fill.max_fraction);
  io({"over", "rain: particles come in over this time", kTime, Range::kNotNegative}, fill.over);
  io({"velocity", "of the particles when placed", kSpeed}, fill.velocity);
}

template <class Io>
void fields(Io& io, SizeClass& size) {
  using enum Dimension;
  io({"from", "least diameter", kLength, Range::kPositive, Need::kRequired}, size.from);
  io({"to", "largest diameter", kLength, Range::kPositive, Need::kRequired}, size.to);
  io({"count", "particles of the class", kNumber, Range::kNotNegative}, size.count);
  io({"mass_share", "of the species' mass", kShare, Range::kShare}, size.mass_share);
  io({"shape", "of the class; default: that of the species"}, size.shape);
}

struct RosinRammler {
  double d63 = 0, exponent = 0, from = 0, to = 0;
};

template <class Io>
void fields(Io& io, RosinRammler& law) {
  using enum Dimension;
  using enum Need;
  io({"d63", "diameter that 63.2 % of the mass passes", kLength, Range::kPositive, kRequired},
     law.d63);
  io({"exponent", "slope n of 1 - exp(-(d/d63)^n)", kNumber, Range::kPositive, kRequired},
     law.exponent);
  io({"from", "least diameter", kLength, Range::kPositive, kRequired}, law.from);
  io({"to", "largest diameter", kLength, Range::kPositive, kRequired}, law.to);
}

template <class Io>
void fields(Io& io, SizeDistribution& sizes) {
  using enum DistributionKind;
  io.passing({"table", "rows of [diameter, share of mass passing]"}, sizes.passing);
  std::optional<RosinRammler> law;
  if (sizes.kind == kRosinRammler)
    law = RosinRammler{sizes.d63, sizes.exponent, sizes.from, sizes.to};
  io.table({"rosin_rammler", "by mass"}, law);
  if (law) {
    sizes.d63 = law->d63;
    sizes.exponent = law->exponent;
    sizes.from = law->from;
    sizes.to = law->to;
  }
  sizes.kind = law ? kRosinRammler : sizes.passing.empty() ? kNone : kPassingTable;
}

template <class Io>
void fields(Io& io, Turn& turn) {
  io({"axis", "direction, of any length"}, turn.axis);
  io({"angle", "about the axis, right-handed", Dimension::kAngle}, turn.angle);
}

template <class Io>
void fields(Io& io, ExplicitParticle& particle) {
  using enum Dimension;
  io({"position", "of the centre", kLength, Range::kAny, Need::kRequired}, particle.position);
  io({"velocity", "of the centre", kSpeed}, particle.velocity);
  io({"spin", "angular velocity", kAngularVelocity}, particle.spin);
  io({"diameter", "default: that of the species", kLength, Range::kPositive}, particle.diameter);
  io.table({"orientation", "of a polyhedron: how its mesh is turned; default: at random"},
           particle.orientation);
}

// Two keys have two names: the second serves where only some of the sizes are polyhedra, or says
// better what it means. They are written by the first.
template <class Io>
void shape_fields(Io& io, ParticleSpec& species) {
  std::vector<std::string> meshes;
  std::optional<double> diameter;
  io.texts({"mesh", "of polyhedra: STL file, or a list that is dealt in turn"}, species.meshes);
  io.texts({"polyhedron_mesh", "another name for mesh"}, meshes);
  io({"hull", "a mesh that is no convex body is taken by its hull"}, species.hull);
  io({"equivalent_diameter", "of the sphere of equal volume: another name for diameter",
      Dimension::kLength, Range::kPositive},
     diameter);
  if (!meshes.empty()) species.meshes = meshes;
  if (diameter) species.diameter = diameter;
}

template <class Io>
void fields(Io& io, ParticleSpec& species) {
  using enum Dimension;
  io({"name", "default: the material's name"}, species.name);
  io({"group", "whose collisions are told together; default: the name"}, species.group);
  io({"material", "of the particles", kNumber, Range::kAny, Need::kRequired}, species.material);
  io({"shape", "of the particles"}, species.shape);
  shape_fields(io, species);
  io({"diameter", "one size for all; of polyhedra: equivalent_diameter", kLength, Range::kPositive},
     species.diameter);
  io({"count", "particles of the species", kNumber, Range::kNotNegative}, species.count);
  io({"mass", "of the species", kMass, Range::kPositive}, species.mass);
  io({"filling_level", "bulk volume (porosity 0.4) over the mill's volume", kShare,
      Range::kFraction},
     species.filling_level);
  io({"csv", "file of particles: x,y,z,diameter[,vx,vy,vz,wx,wy,wz][,class] in SI"}, species.csv);
  io.rows({"sizes", "size classes, uniform from..to in each"}, species.sizes);
  if (species.distribution.kind != DistributionKind::kNone || Io::kWantsAll)
    io.table({"distribution", "sizes by mass"}, species.distribution);
  if (species.csv.empty() || Io::kWantsAll)
    io.rows({"entries", "particles one by one"}, species.explicit_particles);
}

template <class Io>
void fields(Io& io, OutputSpec& output) {
  using enum Dimension;
  io({"series_every", "time between rows of the series; 0: 1/1000 of the run", kTime,
      Range::kNotNegative},
     output.series_every);
  io({"frames_every", "time between frames; 0: none", kTime, Range::kNotNegative},
     output.frames_every);
  io({"contacts", "frames hold each contact with its force"}, output.contacts);
  io({"checkpoint_every", "wall-clock time between checkpoints; 0: only at the end", kTime,
      Range::kNotNegative},
     output.checkpoint_every);
}

template <class Io>
void fields(Io& io, ZoneSpec& zone) {
  using enum Dimension;
  io({"name", "default: zone_1, zone_2, ..."}, zone.name);
  io({"radius_from", "from the mill's axis", kLength, Range::kNotNegative}, zone.radius_from);
  io({"radius_to", "default: no limit", kLength, Range::kPositive}, zone.radius_to);
  io({"angle_from", "from +x, counterclockwise", kAngle}, zone.angle_from);
  io({"angle_to", "below angle_from: on through a full turn", kAngle}, zone.angle_to);
}

template <class Io>
void fields(Io& io, RecordSpec& record) {
  using enum Dimension;
  io({"collisions", "power by kind of collision and collision spectra"}, record.collisions);
  io({"charge_shape", "the charge's angles, and maps of its solid fraction and velocity"},
     record.charge_shape);
  io({"classes", "count, spin and kinetic energy of each size class"}, record.classes);
  io({"snapshots_every",
      "time between snapshots of map, classes and zones; 0: 1/100 of the recorded window", kTime,
      Range::kNotNegative},
     record.snapshots_every);
  io({"cell_angle", "cells of the map around; 0: 1 degree, in small mills up to 10", kAngle,
      Range::kAcute},
     record.cell_angle);
  io({"cell_width", "cells of the map along the radius; 0: half the median diameter", kLength,
      Range::kNotNegative},
     record.cell_width);
  // Last: what is written after a table of its own belongs to that.
  io.tables({"zones", "a part of the cross-section: count and kinetic energy inside by size class"},
            record.zones);
}

template <class Io>
void fields(Io& io, WearSpec& wear) {
  using enum Dimension;
  io({"cell_size", "of the cells of walls; 0: a fifth of a lifter's top, or from the walls' area",
      kLength, Range::kNotNegative},
     wear.cell_size);
  io({"velocity", "of the particle in the rule of braking: from the liner, or absolute"},
     wear.velocity);
  io({"flow_pressure", "of the walls; default: 1.5 times the hardness of their materials",
      kPressure, Range::kPositive},
     wear.flow_pressure);
  io({"siem_factor", "calibration of wear by shear impact energy", kNumber, Range::kPositive},
     wear.siem_factor);
  io({"archard_factor", "calibration of wear by Archard", kNumber, Range::kPositive},
     wear.archard_factor);
  io({"finnie_factor", "calibration of wear by Finnie: his share of particles that cut", kNumber,
      Range::kPositive},
     wear.finnie_factor);
  io({"archard_coefficient", "k of k F s / H; 0: no wear by Archard", kNumber,
      Range::kNotNegative},
     wear.archard_coefficient);
  io({"finnie_depth_ratio", "psi: length of contact over depth of cut", kNumber, Range::kPositive},
     wear.finnie_depth_ratio);
  io({"finnie_force_ratio", "K: normal over tangential force of a particle that cuts", kNumber,
      Range::kPositive},
     wear.finnie_force_ratio);
}

template <class Io>
void fields(Io& io, SceneDraft& draft) {
  io({"format", "version of the scene format"}, draft.format);
  io({"folder", "where relative paths start; default: the scene's own folder"}, draft.scene.folder);
  io.table({"run", "time, order, start"}, draft.scene.run);
  io.table({"domain", "the box of space"}, draft.scene.domain);
  io.named({"materials", "what things are made of"}, draft.scene.materials);
  io.table({"contact", "the force law"}, draft.scene.contact);
  io.table({"mill", "a mill by its numbers, axis +z through the origin"}, draft.scene.mill);
  io.tables({"walls", "any other wall: mesh, plane or box"}, draft.walls);
  io.table({"fill", "where particles start"}, draft.scene.fill);
  io.tables({"particles", "a species"}, draft.scene.particles);
  io.table({"output", "what is written when"}, draft.scene.output);
  io.table({"record", "what is worked out of the recorded window"}, draft.scene.record);
  io.table({"wear", "wear of walls, over the recorded window"}, draft.scene.wear);
}

}  // namespace quern
