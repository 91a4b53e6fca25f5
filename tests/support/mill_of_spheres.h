// A laboratory mill at 60 rpm with 300 spheres of 6 mm, closed at its ends.
#pragma once

namespace quern::test {

inline constexpr const char* kMillOfSpheres = R"(
format = 1
[run]
duration = "10 s"
time_step = "1e-5 s"
[materials.ore]
density = "2000 kg/m^3"
[contact]
normal_stiffness = "1e5 N/m"
tangential_stiffness = "4e4 N/m"
sliding_friction = 0.4
restitution = 0.6
[mill]
material = "ore"
diameter = "300 mm"
length = "60 mm"
ends = "walls"
rotation = "60 rpm"
[mill.lifters]
count = 18
height = "10 mm"
face_angle = "14 deg"
top_width = "10 mm"
[[particles]]
name = "ore"
material = "ore"
diameter = "6 mm"
count = 300
[fill]
method = "random"
)";

}  // namespace quern::test
