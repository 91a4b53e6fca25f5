#include "scheduler/wear_frame.h"

#include "kernels/wear_report.h"

namespace quern {

namespace {

void add_cells(const WallWear& wall, Index row, const Body& body, WallFrame& f) {
  for (const WearCell& cell : wall.cells) {
    Vec3 centre = Vec3::Zero();
    for (const Vec3& corner : cell.corner) {
      const Vec3 x = body.pose.rotation * corner + body.pose.shift;
      f.triangle.push_back(static_cast<std::uint32_t>(f.vertex.size() / 3));
      for (int a = 0; a < 3; ++a) f.vertex.push_back(static_cast<float>(x[a]));
      centre += x / 3;
    }
    f.wall.push_back(static_cast<std::uint16_t>(row));
    f.speed.push_back(static_cast<float>(body.velocity.at(centre).norm()));
  }
}

void append(const std::vector<double>& values, std::vector<float>& to) {
  for (const double v : values) to.push_back(static_cast<float>(v));
}

}  // namespace

template <class Real>
WallFrame wear_frame(const World<Real>& world, const Scene& scene) {
  WallFrame f;
  std::vector<WearModel> models;
  for (const WearModel& m : kWearModels) {
    if (m.sum == kArchardWork && !(scene.wear->archard_coefficient > 0)) continue;
    models.push_back(m);
    f.fields.push_back({std::string("wear_depth_") + m.name, "m", {}});
  }
  f.fields.push_back({"pressure", "Pa", {}});
  f.fields.push_back({"shear", "Pa", {}});
  for (Index w = 0; w < world.walls.size(); ++w) {
    const WallWear wall = wall_wear(world, scene, w);
    add_cells(wall, w, world.bodies[world.walls[w].body], f);
    for (std::size_t m = 0; m < models.size(); ++m) {
      append(wall.depth(models[m].sum), f.fields[m].value);
    }
    append(wall.pressure(), f.fields[models.size()].value);
    append(wall.shear(), f.fields[models.size() + 1].value);
  }
  return f;
}

template WallFrame wear_frame(const World<float>&, const Scene&);
template WallFrame wear_frame(const World<double>&, const Scene&);

}  // namespace quern
