// Polyhedra in frames: true shapes for the viewer, their state for scripts; spheres beside them.
#include <gtest/gtest.h>

#include <filesystem>

#include "io/frames.h"
#include "io/hdf5_file.h"
#include "kernels/tally.h"
#include "scheduler/snapshot.h"
#include "tests/support/polyhedron_world.h"
#include "tests/support/temp_folder.h"
#include "tests/support/trap_fp.h"

namespace quern {
namespace {

template <class T>
std::vector<T> read_array(const Hdf5File& file, const std::string& name) {
  const ArrayLayout layout = file.layout(name);
  std::vector<T> values(layout.rows * layout.components);
  file.read(name, {element_type_of<T>(), layout.rows, layout.components}, values.data());
  return values;
}

// Six times the volume over the triangles of body k, about its own place.
double six_volumes(const PolyhedronFrame& frame, std::uint32_t k, const Vec3& about) {
  double sum = 0;
  for (std::size_t t = 0; t < frame.body.size(); ++t) {
    if (frame.body[t] != k) continue;
    Vec3 corner[3];
    for (std::size_t c = 0; c < 3; ++c) {
      const float* v = &frame.vertex[3 * frame.triangle[3 * t + c]];
      corner[c] = Vec3(v[0], v[1], v[2]) - about;
    }
    sum += corner[0].dot(corner[1].cross(corner[2]));
  }
  return sum;
}

TEST(PolyhedronFrames, AreTheShapesAtTheirPlaceAndSize) {
  World<double> world = test::world_by_hand<double>();
  Polyhedra<double>& bodies = world.polyhedra;
  bodies.scale[2] = 2;
  const auto frame = polyhedron_frame(world);
  ASSERT_TRUE(frame.has_value());
  ASSERT_EQ(frame->shape.size(), bodies.size());
  for (std::uint32_t k = 0; k < bodies.size(); ++k) {
    // Vertices are f32 at coordinates below 32: an error of 2e-6, over a surface of at most
    // 6 * 4 pi at a lever of 1 in a volume of 4 pi / 3: 5e-5.
    const double r = bodies.scale[k];
    EXPECT_NEAR(six_volumes(*frame, k, bodies.place(k)), 8 * kPi * r * r * r, 1e-4 * r * r * r);
  }
  const Shape& box = world.shapes[bodies.shape[1]];
  const Vec3 first = bodies.place(1) + bodies.orientation(1) * box.vertex(0);
  const std::size_t before = world.shapes[bodies.shape[0]].vertices;
  for (Eigen::Index a = 0; a < 3; ++a) {
    EXPECT_NEAR(frame->vertex[3 * before + static_cast<std::size_t>(a)], first[a], 2e-6);
  }
}

TEST(PolyhedronFrames, FollowTheSpheresInTheFrameOfAllParticles) {
  World<double> world = test::world_by_hand<double>();
  world.periodic[0] = true;
  world.polyhedra.x[2] = 33;  // wraps to -31
  const ParticleFrame frame = particle_frame(world);
  ASSERT_EQ(frame.id.size(), test::kSpheres + test::kPolyhedra);
  EXPECT_EQ(frame.spheres, test::kSpheres);
  for (std::uint32_t k = 0; k < frame.id.size(); ++k) EXPECT_EQ(frame.id[k], k);
  const std::size_t last = frame.id.size() - 1;
  EXPECT_NEAR(frame.position[3 * last], -31, 1e-13);
  EXPECT_EQ(frame.radius[last], 1);
  EXPECT_EQ(frame.species[last], 1);
  EXPECT_EQ(frame.contacts[last], 3);
  EXPECT_EQ(frame.velocity[3 * last], static_cast<float>(world.polyhedra.vx[2]));
  EXPECT_EQ(frame.spin[3 * last + 2], static_cast<float>(world.polyhedra.wz[2]));
}

// Spheres and bodies are 2 m across, but for the last body.
Scene scene_with_classes() {
  Scene scene;
  scene.particles.resize(2);
  scene.particles[1].sizes = {{1, 3, 1, std::nullopt, ShapeKind::kSphere},
                              {1, 3, 1, std::nullopt, ShapeKind::kPolyhedron},
                              {3, 5, 1, std::nullopt, ShapeKind::kPolyhedron}};
  return scene;
}

TEST(PolyhedronFrames, AreWrittenBesideTheSpheres) {
  World<float> world = test::world_by_hand<float>();
  world.size_classes = SizeClasses(scene_with_classes());
  world.polyhedra.scale[2] = 2;
  const ParticleFrame all = particle_frame(world);
  const auto bodies = polyhedron_frame(world);
  const TempFolder folder;
  FrameWriter(folder.path()).write(7, all, {}, bodies);
  const Hdf5File spheres("frame", folder / "particles_000007.hdf", FileMode::kRead);
  EXPECT_EQ(read_array<std::uint32_t>(spheres, "VTKHDF/PointData/id"),
            (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5}));

  const Hdf5File file("frame", folder / "polyhedra_000007.hdf", FileMode::kRead);
  EXPECT_EQ(file.text_attribute("VTKHDF", "Type"), "UnstructuredGrid");
  const std::size_t triangles = bodies->body.size();
  EXPECT_EQ(read_array<std::uint8_t>(file, "VTKHDF/Types"),
            std::vector<std::uint8_t>(triangles, 5));
  EXPECT_EQ(read_array<std::int64_t>(file, "VTKHDF/Connectivity").size(), 3 * triangles);
  const auto id = read_array<std::uint32_t>(file, "VTKHDF/CellData/id");
  const auto speed = read_array<float>(file, "VTKHDF/CellData/speed");
  const auto spin = read_array<float>(file, "VTKHDF/CellData/spin_magnitude");
  for (std::size_t t = 0; t < triangles; ++t) {
    const std::size_t k = bodies->body[t];
    EXPECT_EQ(id[t], test::kSpheres + k);
    EXPECT_NEAR(speed[t], world.polyhedra.velocity(k).norm(), 1e-6 * speed[t]);
    EXPECT_NEAR(spin[t], world.polyhedra.spin(k).norm(), 1e-6 * spin[t]);
  }
  EXPECT_EQ(read_array<std::uint16_t>(file, "VTKHDF/CellData/species").front(), 1);
  EXPECT_EQ(read_array<std::uint16_t>(spheres, "VTKHDF/PointData/class"),
            std::vector<std::uint16_t>(test::kSpheres, 0));
  EXPECT_EQ(read_array<std::uint16_t>(file, "polyhedra/class"),
            (std::vector<std::uint16_t>{2, 2, 3}));
  const auto size_class = read_array<std::uint16_t>(file, "VTKHDF/CellData/class");
  ASSERT_EQ(size_class.size(), triangles);
  for (std::size_t t = 0; t < triangles; ++t) {
    EXPECT_EQ(size_class[t], bodies->body[t] == 2 ? 3 : 2);
  }

  EXPECT_EQ(read_array<double>(file, "polyhedra/orientation"), bodies->orientation);
  EXPECT_EQ(read_array<double>(file, "polyhedra/position")[3], world.polyhedra.x[1]);
  EXPECT_EQ(read_array<float>(file, "polyhedra/spin")[0],
            static_cast<float>(world.polyhedra.wx[0]));
  for (const char* group : {"VTKHDF", "polyhedra"}) {
    for (const std::string& name : file.datasets(group)) {
      EXPECT_NE(file.text_attribute(std::string(group) + "/" + name, "unit"), "") << name;
    }
  }
  EXPECT_TRUE(std::filesystem::exists(folder / "polyhedra.hdf.series"));
}

TEST(PolyhedronFrames, AreEmptyBeforeTheFirstBodyAndAbsentFromASceneWithoutThem) {
  const TempFolder folder;
  World<float> without = test::world_by_hand<float>(false);
  EXPECT_FALSE(polyhedron_frame(without).has_value());
  FrameWriter(folder.path()).write(0, particle_frame(without), {}, polyhedron_frame(without));
  EXPECT_FALSE(std::filesystem::exists(folder / "polyhedra_000000.hdf"));
  without.shapes.push_back(test::built_box({1, 1, 1}));
  FrameWriter(folder.path()).write(0, particle_frame(without), {}, polyhedron_frame(without));
  const Hdf5File file("frame", folder / "polyhedra_000000.hdf", FileMode::kRead);
  EXPECT_EQ(read_array<std::int64_t>(file, "VTKHDF/NumberOfCells"), std::vector<std::int64_t>{0});
}

TEST(PolyhedronTallies, AreReportedOfScenesWithPolyhedraOnly) {
  const auto has_model_work = [](bool polyhedra) {
    for (const TallyRow& row : tally_rows_of(polyhedra))
      if (row.quantity.name == "model_work") return true;
    return false;
  };
  EXPECT_TRUE(has_model_work(true));
  EXPECT_FALSE(has_model_work(false));
  Ledger ledger;
  ledger.contact_work = -4;
  ledger.model_work = -1;
  EXPECT_EQ(model_work_share(ledger), -0.25);
}

}  // namespace
}  // namespace quern
