// Every shipped scene, and one with every key there is, written and read back to an equal scene.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/scene_text.h"

namespace quern {
namespace {

const std::filesystem::path kScenes =
    std::filesystem::path(__FILE__).parent_path().parent_path().parent_path() / "apps" / "scenes";

void expect_same(const Schedule& a, const Schedule& b) {
  ASSERT_EQ(a.points.size(), b.points.size());
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    EXPECT_EQ(a.points[i].time, b.points[i].time);
    EXPECT_EQ(a.points[i].value, b.points[i].value);
  }
}

void expect_same(const Motion& a, const Motion& b) {
  EXPECT_EQ(a.kind, b.kind);
  EXPECT_EQ(a.axis, b.axis);
  EXPECT_EQ(a.center, b.center);
  expect_same(a.rate, b.rate);
  EXPECT_EQ(a.amplitude, b.amplitude);
  EXPECT_EQ(a.frequency, b.frequency);
}

void expect_same(const RunSpec& a, const RunSpec& b) {
  EXPECT_EQ(a.title, b.title);
  EXPECT_EQ(a.duration, b.duration);
  EXPECT_EQ(a.revolutions, b.revolutions);
  EXPECT_EQ(a.record_from, b.record_from);
  EXPECT_EQ(a.record_from_revolution, b.record_from_revolution);
  EXPECT_EQ(a.time_step, b.time_step);
  EXPECT_EQ(a.seed, b.seed);
  EXPECT_EQ(a.gravity, b.gravity);
  EXPECT_EQ(a.settle, b.settle);
  EXPECT_EQ(a.settle_time, b.settle_time);
  EXPECT_EQ(a.soft_stiffness, b.soft_stiffness);
  EXPECT_EQ(a.calm_time, b.calm_time);
  EXPECT_EQ(a.start, b.start);
  EXPECT_EQ(a.start_file, b.start_file);
  EXPECT_EQ(a.relax, b.relax);
  EXPECT_EQ(a.overlap_cap, b.overlap_cap);
  EXPECT_EQ(a.precision, b.precision);
  EXPECT_EQ(a.tile_size, b.tile_size);
  EXPECT_EQ(a.list_slack, b.list_slack);
}

void expect_same(const ContactSpec& a, const ContactSpec& b) {
  EXPECT_EQ(a.law, b.law);
  EXPECT_EQ(a.normal_force, b.normal_force);
  EXPECT_EQ(a.tangential_damping, b.tangential_damping);
  EXPECT_EQ(a.normal_stiffness, b.normal_stiffness);
  EXPECT_EQ(a.tangential_stiffness, b.tangential_stiffness);
  EXPECT_EQ(a.restitution, b.restitution);
  EXPECT_EQ(a.sliding_friction, b.sliding_friction);
  EXPECT_EQ(a.rolling_friction, b.rolling_friction);
  EXPECT_EQ(a.overlap, b.overlap);
  EXPECT_EQ(a.normal_model, b.normal_model);
  EXPECT_EQ(a.volume_stiffness, b.volume_stiffness);
  EXPECT_EQ(a.patch_damping, b.patch_damping);
  EXPECT_EQ(a.impact_speed, b.impact_speed);
  ASSERT_EQ(a.pairs.size(), b.pairs.size());
  for (std::size_t i = 0; i < a.pairs.size(); ++i) {
    const PairCoefficients &p = a.pairs[i], &q = b.pairs[i];
    EXPECT_EQ(p.a, q.a);
    EXPECT_EQ(p.b, q.b);
    EXPECT_EQ(p.normal_stiffness, q.normal_stiffness);
    EXPECT_EQ(p.tangential_stiffness, q.tangential_stiffness);
    EXPECT_EQ(p.restitution, q.restitution);
    EXPECT_EQ(p.sliding_friction, q.sliding_friction);
    EXPECT_EQ(p.rolling_friction, q.rolling_friction);
  }
}

void expect_same(const MillSpec& a, const MillSpec& b) {
  EXPECT_EQ(a.material, b.material);
  EXPECT_EQ(a.end_material, b.end_material);
  EXPECT_EQ(a.group, b.group);
  EXPECT_EQ(a.diameter, b.diameter);
  EXPECT_EQ(a.length, b.length);
  EXPECT_EQ(a.ends, b.ends);
  EXPECT_EQ(a.pieces_per_arc, b.pieces_per_arc);
  expect_same(a.rotation, b.rotation);
  ASSERT_EQ(a.lifters.has_value(), b.lifters.has_value());
  if (!a.lifters) return;
  EXPECT_EQ(a.lifters->count, b.lifters->count);
  EXPECT_EQ(a.lifters->height, b.lifters->height);
  EXPECT_EQ(a.lifters->face_angle, b.lifters->face_angle);
  EXPECT_EQ(a.lifters->top_width, b.lifters->top_width);
}

void expect_same(const ParticleSpec& a, const ParticleSpec& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.material, b.material);
  EXPECT_EQ(a.shape, b.shape);
  EXPECT_EQ(a.meshes, b.meshes);
  EXPECT_EQ(a.hull, b.hull);
  EXPECT_EQ(a.diameter, b.diameter);
  EXPECT_EQ(a.count, b.count);
  EXPECT_EQ(a.mass, b.mass);
  EXPECT_EQ(a.filling_level, b.filling_level);
  EXPECT_EQ(a.csv, b.csv);
  EXPECT_EQ(a.group, b.group);
  ASSERT_EQ(a.sizes.size(), b.sizes.size());
  for (std::size_t i = 0; i < a.sizes.size(); ++i) {
    EXPECT_EQ(a.sizes[i].from, b.sizes[i].from);
    EXPECT_EQ(a.sizes[i].to, b.sizes[i].to);
    EXPECT_EQ(a.sizes[i].count, b.sizes[i].count);
    EXPECT_EQ(a.sizes[i].mass_share, b.sizes[i].mass_share);
    EXPECT_EQ(a.sizes[i].shape, b.sizes[i].shape);
  }
  EXPECT_EQ(a.distribution.kind, b.distribution.kind);
  EXPECT_EQ(a.distribution.passing, b.distribution.passing);
  EXPECT_EQ(a.distribution.d63, b.distribution.d63);
  EXPECT_EQ(a.distribution.exponent, b.distribution.exponent);
  EXPECT_EQ(a.distribution.from, b.distribution.from);
  EXPECT_EQ(a.distribution.to, b.distribution.to);
  ASSERT_EQ(a.explicit_particles.size(), b.explicit_particles.size());
  for (std::size_t i = 0; i < a.explicit_particles.size(); ++i) {
    const ExplicitParticle &p = a.explicit_particles[i], &q = b.explicit_particles[i];
    EXPECT_EQ(p.position, q.position);
    EXPECT_EQ(p.velocity, q.velocity);
    EXPECT_EQ(p.spin, q.spin);
    EXPECT_EQ(p.diameter, q.diameter);
    ASSERT_EQ(p.orientation.has_value(), q.orientation.has_value());
    if (!p.orientation) continue;
    EXPECT_EQ(p.orientation->axis, q.orientation->axis);
    EXPECT_EQ(p.orientation->angle, q.orientation->angle);
  }
}

template <class Wall>
void expect_same_names(const std::vector<Wall>& a, const std::vector<Wall>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].name, b[i].name);
    EXPECT_EQ(a[i].material, b[i].material);
    EXPECT_EQ(a[i].group, b[i].group);
    expect_same(a[i].motion, b[i].motion);
  }
}

void expect_same_walls(const Scene& a, const Scene& b) {
  expect_same_names(a.meshes, b.meshes);
  expect_same_names(a.planes, b.planes);
  expect_same_names(a.boxes, b.boxes);
  for (std::size_t i = 0; i < a.meshes.size(); ++i) {
    EXPECT_EQ(a.meshes[i].path, b.meshes[i].path);
    EXPECT_EQ(a.meshes[i].scale, b.meshes[i].scale);
    EXPECT_EQ(a.folder, b.folder);
  }
  for (std::size_t i = 0; i < a.planes.size(); ++i) {
    EXPECT_EQ(a.planes[i].point, b.planes[i].point);
    EXPECT_EQ(a.planes[i].normal, b.planes[i].normal);
  }
  for (std::size_t i = 0; i < a.boxes.size(); ++i) {
    EXPECT_EQ(a.boxes[i].low, b.boxes[i].low);
    EXPECT_EQ(a.boxes[i].high, b.boxes[i].high);
    EXPECT_EQ(a.boxes[i].open_top, b.boxes[i].open_top);
  }
}

void expect_same(const Scene& a, const Scene& b) {
  expect_same(a.run, b.run);
  EXPECT_EQ(a.domain.low, b.domain.low);
  EXPECT_EQ(a.domain.high, b.domain.high);
  for (int k = 0; k < 3; ++k) EXPECT_EQ(a.domain.periodic[k], b.domain.periodic[k]);
  expect_same(a.contact, b.contact);
  ASSERT_EQ(a.materials.size(), b.materials.size());
  for (std::size_t i = 0; i < a.materials.size(); ++i) {
    EXPECT_EQ(a.materials[i].name, b.materials[i].name);
    EXPECT_EQ(a.materials[i].density, b.materials[i].density);
    EXPECT_EQ(a.materials[i].hardness, b.materials[i].hardness);
    EXPECT_EQ(a.materials[i].young_modulus, b.materials[i].young_modulus);
    EXPECT_EQ(a.materials[i].poisson_ratio, b.materials[i].poisson_ratio);
  }
  ASSERT_EQ(a.mill.has_value(), b.mill.has_value());
  if (a.mill) expect_same(*a.mill, *b.mill);
  expect_same_walls(a, b);
  EXPECT_EQ(a.fill.method, b.fill.method);
  EXPECT_EQ(a.fill.low, b.fill.low);
  EXPECT_EQ(a.fill.high, b.fill.high);
  EXPECT_EQ(a.fill.max_fraction, b.fill.max_fraction);
  EXPECT_EQ(a.fill.over, b.fill.over);
  EXPECT_EQ(a.fill.velocity, b.fill.velocity);
  ASSERT_EQ(a.particles.size(), b.particles.size());
  for (std::size_t i = 0; i < a.particles.size(); ++i) expect_same(a.particles[i], b.particles[i]);
  EXPECT_EQ(a.output.series_every, b.output.series_every);
  EXPECT_EQ(a.output.frames_every, b.output.frames_every);
  EXPECT_EQ(a.output.contacts, b.output.contacts);
  EXPECT_EQ(a.output.checkpoint_every, b.output.checkpoint_every);
  EXPECT_EQ(a.record.collisions, b.record.collisions);
  EXPECT_EQ(a.record.charge_shape, b.record.charge_shape);
  EXPECT_EQ(a.record.classes, b.record.classes);
  EXPECT_EQ(a.record.snapshots_every, b.record.snapshots_every);
  EXPECT_EQ(a.record.cell_angle, b.record.cell_angle);
  EXPECT_EQ(a.record.cell_width, b.record.cell_width);
  ASSERT_EQ(a.record.zones.size(), b.record.zones.size());
  for (std::size_t i = 0; i < a.record.zones.size(); ++i) {
    EXPECT_EQ(a.record.zones[i].name, b.record.zones[i].name);
    EXPECT_EQ(a.record.zones[i].radius_from, b.record.zones[i].radius_from);
    EXPECT_EQ(a.record.zones[i].radius_to, b.record.zones[i].radius_to);
    EXPECT_EQ(a.record.zones[i].angle_from, b.record.zones[i].angle_from);
    EXPECT_EQ(a.record.zones[i].angle_to, b.record.zones[i].angle_to);
  }
  ASSERT_EQ(a.wear.has_value(), b.wear.has_value());
  if (!a.wear) return;
  EXPECT_EQ(a.wear->cell_size, b.wear->cell_size);
  EXPECT_EQ(a.wear->velocity, b.wear->velocity);
  EXPECT_EQ(a.wear->flow_pressure, b.wear->flow_pressure);
  EXPECT_EQ(a.wear->siem_factor, b.wear->siem_factor);
  EXPECT_EQ(a.wear->archard_factor, b.wear->archard_factor);
  EXPECT_EQ(a.wear->finnie_factor, b.wear->finnie_factor);
  EXPECT_EQ(a.wear->archard_coefficient, b.wear->archard_coefficient);
  EXPECT_EQ(a.wear->finnie_depth_ratio, b.wear->finnie_depth_ratio);
  EXPECT_EQ(a.wear->finnie_force_ratio, b.wear->finnie_force_ratio);
}

// Written, read from another folder, and written again.
void expect_round_trip(const Scene& scene) {
  const std::string text = scene_to_toml(scene);
  const SceneResult back = parse_scene(text, "written.toml", "/elsewhere");
  EXPECT_EQ(back.errors, Lines{});
  expect_same(scene, back.scene);
  EXPECT_EQ(scene_to_toml(back.scene), text);
}

class ShippedScene : public testing::TestWithParam<const char*> {};

TEST_P(ShippedScene, IsReadWithoutComplaintAndReadsBackTheSame) {
  const SceneResult result = read_scene((kScenes / GetParam()).string() + ".toml");
  EXPECT_EQ(result.errors, Lines{});
  EXPECT_EQ(result.warnings, Lines{});
  expect_round_trip(result.scene);
}

TEST_P(ShippedScene, OpensWithPurposeSourceAndExpectedResult) {
  const SceneResult result = read_scene((kScenes / GetParam()).string() + ".toml");
  const std::string head = result.scene.text.substr(0, result.scene.text.find("format = 1"));
  for (const char* word : {"# Purpose:", "# Source:", "# Expected"})
    EXPECT_NE(head.find(word), std::string::npos) << word;
}

constexpr const char* kShipped[] = {"bounce",
                                    "slide_to_roll",
                                    "two_spheres",
                                    "box_packing_spheres",
                                    "box_packing",
                                    "lab_mill_spheres",
                                    "lab_mill_reference",
                                    "lab_mill_hertz",
                                    "lab_mill",
                                    "lab_mill_faceted",
                                    "sag_slice_sp",
                                    "sag_slice_small_sp",
                                    "sag_slice_ph",
                                    "sag_slice_small_ph",
                                    "bed",
                                    "mix_bed"};
INSTANTIATE_TEST_SUITE_P(SceneReader, ShippedScene, testing::ValuesIn(kShipped),
                         [](const auto& row) { return std::string(row.param); });

TEST(SceneReader, SagSliceHoldsThePapersCharge) {
  const Scene scene = read_scene((kScenes / "sag_slice_sp.toml").string()).scene;
  ASSERT_EQ(scene.particles.size(), 2u);
  double mass[2] = {};
  long count = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    const ParticleSpec& species = scene.particles[i];
    const double density = species.material == "ore" ? 4500 : 7800;
    if (species.diameter) {
      mass[i] =
          static_cast<double>(*species.count) * density * kPi / 6 * std::pow(*species.diameter, 3);
      count += *species.count;
    }
    for (const SizeClass& size : species.sizes) {  // mean of d^3 over uniform diameters
      const double cube =
          (std::pow(size.to, 4) - std::pow(size.from, 4)) / (4 * (size.to - size.from));
      mass[i] += static_cast<double>(*size.count) * density * kPi / 6 * cube;
      count += *size.count;
    }
  }
  EXPECT_EQ(count, 400000);
  EXPECT_NEAR(mass[0], 19940, 5);   // kg, balls; the paper: 45.5 % of all mass
  EXPECT_NEAR(mass[1], 23740, 30);  // kg, ore
}

// Every key there is, none at its default.
constexpr const char* kEverything = R"(
format = 1
folder = "FOLDER"
[run]
title = 'a "quoted" \ title'
revolutions = 3
record_from_revolution = 1.5
time_step = "3 us"
seed = 7
gravity = ["0.1 m/s^2", "0 m/s^2", "-9.7 m/s^2"]
settle = "until-rest"
settle_limit = "2 min"
soft_stiffness = 0.1
calm = "0.3 s"
start = "file"
start_file = "points.csv"
relax = "0.3 s"
overlap_cap = "0.05 mm"
precision = "single"
tile_size = 64
list_slack = "0.7 mm"
[domain]
low = ["-1 m", "-1 m", "-1 m"]
high = ["1 m", "1 m", "1 m"]
periodic = ["y", "x"]
[materials.ore]
density = "3.3 t/m^3"
hardness = "160 HV"
young_modulus = "70 GPa"
poisson_ratio = 0.24
[materials.steel-2]
[contact]
law = "linear-spring-dashpot"
normal_force = "unclamped"
tangential_damping = false
normal_stiffness = "1.1 MN/m"
tangential_stiffness = "0.4 MN/m"
restitution = 0.31
sliding_friction = 0.32
rolling_friction = 0.033
overlap = "width"
normal_model = "volume"
volume_stiffness = "3 GPa"
impact_speed = "7 m/s"
patch_damping = false
[[contact.pair]]
between = ["ore", "steel-2"]
normal_stiffness = "2 MN/m"
tangential_stiffness = "3 kN/m"
restitution = 0.41
sliding_friction = 0.42
rolling_friction = 0.043
[mill]
material = "steel-2"
end_material = "ore"
group = "shell"
diameter = "777 mm"
length = "0.9 m"
ends = "open"
pieces_per_arc = 7
rotation = { schedule = [{ time = "0 s", value = "0 rpm" }, { time = "3 s", value = "11 rpm" }] }
direction = "clockwise"
[mill.lifters]
count = 5
height = "33 mm"
face_angle = "7 deg"
top_width = "11 mm"
[[walls]]
name = "belt"
group = "conveyor"
kind = "plane"
material = "ore"
point = ["0.1 m", "0.2 m", "0.3 m"]
normal = [1, 2, 3]
motion = { kind = "translation", axis = [3, 1, 2], rate = "0.3 m/s" }
[[walls]]
name = "tub"
group = "box"
material = "steel-2"
low = ["-0.1 m", "-0.2 m", "-0.3 m"]
high = ["0.1 m", "0.2 m", "0.3 m"]
open_top = true
motion = { kind = "oscillation", axis = [1, 1, 0], amplitude = "3 mm", frequency = "7 Hz" }
[[walls]]
name = "scoop"
group = "scoop"
material = "steel-2"
mesh = "points.csv"
scale = 0.001
[walls.motion]
kind = "rotation"
axis = [0, 3, 4]
center = ["1 mm", "2 mm", "3 mm"]
rate = [{ time = "1 s", value = "3 deg/s" }]
[fill]
method = "rain"
low = ["-0.3 m", "-0.3 m", "-0.3 m"]
high = ["0.3 m", "0.3 m", "0.3 m"]
max_fraction = "37 %"
over = "3 s"
velocity = ["0 m/s", "0 m/s", "-1 mm/s"]
[[particles]]
name = "a"
group = "fines"
material = "ore"
sizes = [
  { from = "1 mm", to = "3 mm", mass_share = "30 %", shape = "sphere" },
  { from = "3 mm", to = "7 mm", mass_share = 0.7, shape = "polyhedron" },
]
mass = "3 kg"
polyhedron_mesh = "points.csv"
hull = true
[[particles]]
name = "b"
material = "ore"
distribution = { table = [["1 mm", 0], ["3 mm", 0.3], ["7 mm", 1]] }
filling_level = "30 %"
[[particles]]
name = "c"
material = "ore"
distribution = { rosin_rammler = { d63 = "7 mm", exponent = 1.3, from = "1 mm", to = "9 mm" } }
count = 33
[[particles]]
name = "d"
material = "ore"
csv = "points.csv"
[[particles]]
name = "e"
material = "ore"
diameter = "3 mm"
entries = [
  { position = ["0 m", "1 mm", "2 mm"], velocity = ["1 m/s", "2 m/s", "3 m/s"], spin = ["1 rad/s", "2 rpm", "3 Hz"] },
  { position = ["0 m", "1 mm", "9 mm"], diameter = "4 mm", orientation = { axis = [0, 3, 4], angle = "30 deg" } },
]
[[particles]]
name = "f"
material = "ore"
shape = "polyhedron"
equivalent_diameter = "5 mm"
mesh = ["points.csv", "./points.csv"]
count = 3
[output]
series_every = "3 ms"
frames_every = "70 ms"
contacts = true
checkpoint_every = "5 min"
[record]
charge_shape = true
collisions = true
snapshots_every = "20 ms"
cell_angle = "3 deg"
cell_width = "4 mm"
classes = true
[[record.zones]]
name = "toe"
radius_from = "100 mm"
radius_to = "140 mm"
angle_from = "205 deg"
angle_to = "245 deg"
[[record.zones]]
angle_to = "90 deg"
[wear]
cell_size = "7 mm"
velocity = "absolute"
flow_pressure = "5 GPa"
siem_factor = 1.1
archard_factor = 1.2
finnie_factor = 1.3
archard_coefficient = 0.004
finnie_depth_ratio = 3
finnie_force_ratio = 4
)";

TEST(SceneReader, ReadsEveryKeyAndWritesItBack) {
  const TestFolder folder;
  folder.write("points.csv", "x,y,z,diameter,vx\n0,1,2,0.003,0.1\n0.5,0,0,0.004,0\n");
  const std::string text = changed(kEverything, "FOLDER", folder.path.string());
  const SceneResult result = parse(text);
  ASSERT_EQ(result.errors, Lines{});
  EXPECT_EQ(result.scene.particles[3].explicit_particles.size(), 2u);
  EXPECT_EQ(result.scene.particles[0].sizes[0].shape, ShapeKind::kSphere);
  EXPECT_EQ(result.scene.particles[0].sizes[1].shape, ShapeKind::kPolyhedron);
  EXPECT_EQ(result.scene.particles[5].shape, ShapeKind::kPolyhedron);
  EXPECT_EQ(result.scene.particles[0].meshes, Lines{"points.csv"});
  EXPECT_EQ(result.scene.particles[5].meshes, (Lines{"points.csv", "./points.csv"}));
  EXPECT_EQ(result.scene.particles[5].diameter, 0.005);
  const ExplicitParticle& turned = result.scene.particles[4].explicit_particles[1];
  ASSERT_TRUE(turned.orientation);
  EXPECT_EQ(turned.orientation->axis, Vec3(0, 0.6, 0.8));
  EXPECT_EQ(turned.orientation->angle, kPi / 6);
  EXPECT_FALSE(result.scene.particles[4].explicit_particles[0].orientation);
  EXPECT_NEAR(result.scene.planes[0].normal.norm(), 1, 1e-15);
  expect_round_trip(result.scene);
  expect_round_trip(parse(kGoodScene).scene);
  for (const SceneKey& key : scene_keys()) {
    const std::string name = key.path.substr(key.path.rfind('.') + 1);
    EXPECT_NE((text + kGoodScene).find(name + " ="), std::string::npos)
        << "not in this test: " << key.path;
    EXPECT_FALSE(key.doc.empty()) << key.path;
    EXPECT_FALSE(key.type.empty()) << key.path;
  }
}

}  // namespace
}  // namespace quern
