#include "soa/groups.h"

#include <gtest/gtest.h>

namespace quern {

namespace {

Scene scene_of(const std::vector<std::string>& particles, const std::vector<std::string>& planes) {
  Scene scene;
  for (const std::string& group : particles) {
    ParticleSpec species;
    species.name = "species";
    species.group = group;
    scene.particles.push_back(species);
  }
  for (const std::string& group : planes) {
    PlaneSpec plane;
    plane.group = group;
    scene.planes.push_back(plane);
  }
  return scene;
}

}  // namespace

TEST(Groups, ParticlesComeFirstAndSpeciesMayShareOne) {
  const Groups groups(scene_of({"ore", "media", "ore", ""}, {"floor", "liner", "floor"}));
  EXPECT_EQ(groups.names(),
            (std::vector<std::string>{"ore", "media", "species", "floor", "liner"}));
  EXPECT_EQ(groups.of_particles(), 3u);
  EXPECT_EQ(groups.of_species(2), 0);
  EXPECT_EQ(groups.of_species(3), 2);
  EXPECT_EQ(groups.row("liner"), 4u);
}

TEST(Groups, EveryPairWithAParticleIsAKindOfItsOwn) {
  const Groups groups(scene_of({"ore", "media", "scats"}, {"liner", "lid"}));
  ASSERT_EQ(groups.kinds(), 12u);
  std::vector<std::string> seen(groups.kinds());
  for (std::size_t a = 0; a < groups.of_particles(); ++a) {
    for (std::size_t b = a; b < groups.names().size(); ++b) {
      const std::size_t kind = groups.kind(a, b);
      ASSERT_LT(kind, seen.size());
      EXPECT_EQ(kind, groups.kind(b, a));
      EXPECT_TRUE(seen[kind].empty());
      seen[kind] = groups.names()[a] + "-" + groups.names()[b];
      EXPECT_EQ(groups.kind_name(kind), seen[kind]);
    }
  }
}

TEST(Groups, MoreThanEightAreRefused) {
  std::vector<std::string> many;
  for (int k = 0; k < 9; ++k) many.push_back("group" + std::to_string(k));
  EXPECT_THROW(Groups(scene_of(many, {})), UserError);
}

}  // namespace quern
