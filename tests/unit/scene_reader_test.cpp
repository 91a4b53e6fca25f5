// The scene reader against broken and good scenes: every message with its place, every shipped
// scene there and back, overrides, units, CSV.
#include "io/scene_reader.h"

#include <gtest/gtest.h>

#include "tests/unit/bad_particles.h"
#include "tests/unit/scene_text.h"

namespace quern {
namespace {

// --- broken scenes

class BadSceneTest : public testing::TestWithParam<BadScene> {};

TEST_P(BadSceneTest, GivesExactlyItsMessages) {
  const BadScene& bad = GetParam();
  Lines expected;
  for (const std::string& message : bad.messages) expected.push_back("mill.toml:" + message);
  EXPECT_EQ(parse(changed(kGoodScene, bad.find, bad.replace)).errors, expected);
}

INSTANTIATE_TEST_SUITE_P(SceneReader, BadSceneTest, testing::ValuesIn(kBadScenes),
                         [](const auto& row) { return std::string(row.param.name); });
INSTANTIATE_TEST_SUITE_P(SceneReaderParticles, BadSceneTest, testing::ValuesIn(kBadParticles),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(SceneReader, AcceptsTheSceneThatTheBrokenOnesAreMadeOf) {
  const SceneResult result = parse(kGoodScene);
  EXPECT_EQ(result.errors, Lines{});
  EXPECT_EQ(result.warnings, Lines{});
}

TEST(SceneReader, ReportsEveryMistakeOfAFileAtOnce) {
  const std::string text = R"(format = 1
[run]
duration = 2
record_form = "1 s"
time_step = "0 s"
[materials.ore]
density = "4500 kg"
[contact]
normal_stiffness = "1e5 N/m"
tangential_stiffness = "4e4 N/m"
restitution = 1.5
sliding_friction = "much"
[mill]
material = "iron"
diameter = "0.3 m"
ends = "wall"
[[particles]]
name = "ore"
material = "ore"
diameter = "10 mm"
count = 1
mass = "1 kg"
[[particles]]
name = "ore"
material = "ore"
diameter = "5 mm"
)";
  const Lines expected = {
      R"(mill.toml:3:12: error: 'duration' needs a unit, for example "2 s")",
      R"(mill.toml:4:1: error: unknown key 'record_form' - did you mean 'record_from'?)",
      R"(mill.toml:5:13: error: 'time_step': "0 s" is not allowed (must be greater than 0))",
      R"(mill.toml:7:11: error: 'density': unit 'kg' is no unit of density (use kg/m^3, t/m^3, g/cm^3))",
      R"(mill.toml:11:15: error: 'restitution': 1.5 is not allowed (must be greater than 0 and at most 1))",
      R"(mill.toml:12:20: error: 'sliding_friction' must be a number, found a string)",
      R"(mill.toml:13:1: error: [mill] needs 'length' (along the axis))",
      R"(mill.toml:14:12: error: 'material': no material 'iron' (ore))",
      R"(mill.toml:16:8: error: 'ends': "wall" is not known - did you mean "walls"? (walls, periodic, open))",
      R"(mill.toml:22:8: error: 'count' and 'mass' both say how many; give one)",
      R"(mill.toml:23:1: error: particles 'ore' need 'count', 'mass' or 'filling_level')",
      R"(mill.toml:24:8: error: the name 'ore' is taken)",
  };
  EXPECT_EQ(parse(text).errors, expected);
}

// A particle's tag has a byte for its material.
TEST(SceneReader, RefusesMoreMaterialsThanATagHolds) {
  std::string text = kGoodScene;
  for (int k = 2; k < 256; ++k) text += "\n[materials.m" + std::to_string(k) + "]";
  EXPECT_EQ(parse(text).errors, Lines{});
  const Lines errors = parse(text + "\n[materials.one_more]").errors;
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_NE(errors[0].find("257 materials are too many (at most 256)"), std::string::npos);
}

TEST(SceneReader, NamesEveryStrayLetterBeforeItParses) {
  const Lines expected = {
      "mill.toml:1:2: error: 'ä' may only stand in a string or a comment (keys and numbers are "
      "plain ASCII)",
      "mill.toml:3:1: error: 'é' may only stand in a string or a comment (keys and numbers are "
      "plain ASCII)"};
  EXPECT_EQ(parse("xä = 1 # ö\ny = \"ü\"\né = 'ß'\n").errors, expected);
}

TEST(SceneReader, TakesLettersOfAllLanguagesInStringsAndComments) {
  const SceneResult result =
      parse(changed(kGoodScene, "seed = 1", "title = \"Mühle 磨\" # für später"));
  EXPECT_EQ(result.errors, Lines{});
  EXPECT_EQ(result.scene.run.title, "Mühle 磨");
}

TEST(SceneReader, SaysThatAFileCannotBeRead) {
  EXPECT_EQ(read_scene("/nowhere/mill.toml").errors,
            Lines{"/nowhere/mill.toml: error: cannot read the scene: No such file or directory"});
  EXPECT_EQ(read_scene("/").errors, Lines{"/: error: cannot read the scene: it is a folder"});
}

TEST(SceneReader, SaysSoOfAnEmptyScene) {
  const Lines expected = {"mill.toml:1:1: error: there are no [[particles]]",
                          "mill.toml:1:1: error: [run] needs 'duration' or 'revolutions'"};
  EXPECT_EQ(parse("").errors, expected);
}

TEST(SceneReader, WarnsOfARestitutionThatClampedContactsCannotReach) {
  const std::string low = changed(kGoodScene, "restitution = 0.6", "restitution = 0.1");
  EXPECT_EQ(parse(low).warnings,
            Lines{"mill.toml:19:15: 'restitution': 0.1 is not reached with "
                  "normal_force = \"clamped\": damping ends at critical, which delivers 0.135"});
  EXPECT_EQ(parse(changed(low, "law =", "normal_force = \"unclamped\"\nlaw =")).warnings, Lines{});
}

TEST(SceneReader, WarnsOfAVolumeStiffnessThatNothingUses) {
  const std::string text = changed(kGoodScene, "law =", "volume_stiffness = \"1 GPa\"\nlaw =");
  EXPECT_EQ(parse(text).warnings, Lines{"mill.toml:13:20: 'volume_stiffness' is not used: it needs "
                                        "normal_model = \"volume\""});
  EXPECT_EQ(parse(changed(text, "law =", "normal_model = \"volume\"\nlaw =")).warnings, Lines{});
}

TEST(SceneReader, WarnsOfStiffnessesThatHertzMindlinDoesNotUse) {
  const std::vector<std::string> moduli = {
      "contact.law=hertz-mindlin", "materials.ore.young_modulus=50 MPa",
      "materials.ore.poisson_ratio=0.3", "materials.steel.young_modulus=2.1e11",
      "materials.steel.poisson_ratio=0.28"};
  const SceneResult result = parse(kGoodScene, moduli);
  ASSERT_EQ(result.errors, Lines{});
  EXPECT_EQ(result.scene.contact.law, ForceLaw::kHertzMindlin);
  EXPECT_EQ(result.scene.materials[0].young_modulus, 5e7);
  EXPECT_EQ(result.scene.materials[1].poisson_ratio, 0.28);
  const std::string why = "' is not used: it needs law = \"linear-spring-dashpot\"";
  EXPECT_EQ(result.warnings, (Lines{"mill.toml:14:20: 'normal_stiffness" + why,
                                    "mill.toml:15:24: 'tangential_stiffness" + why}));
}

// --- good scenes

TEST(SceneReader, ConvertsToSi) {
  const SceneResult result = parse(kGoodScene);
  ASSERT_EQ(result.errors, Lines{});
  const Scene& scene = result.scene;
  EXPECT_EQ(scene.run.duration, 2);
  EXPECT_EQ(scene.run.time_step, 1e-5);
  EXPECT_EQ(scene.run.gravity, Vec3(0, -9.81, 0));
  EXPECT_EQ(scene.mill->length, 0.04);
  EXPECT_DOUBLE_EQ(scene.mill->rotation.points.at(0).value, kPi);
  EXPECT_DOUBLE_EQ(scene.mill->lifters->face_angle, 14 * kPi / 180);
  EXPECT_EQ(scene.particles.at(0).diameter, 0.01375);
  EXPECT_EQ(scene.planes.at(0).normal, Vec3(0, 1, 0));
  EXPECT_EQ(scene.text, kGoodScene);
  EXPECT_EQ(scene.folder, "/nowhere");
}

TEST(SceneReader, TurnsClockwiseWithANegativeRate) {
  const SceneResult result =
      parse(changed(kGoodScene, "rotation = \"30 rpm\"",
                    "rotation = [{ time = \"0 s\", value = \"0 rpm\" }, { time = \"1 s\", value = "
                    "\"60 rpm\" }]\ndirection = \"clockwise\""));
  ASSERT_EQ(result.errors, Lines{});
  const auto& points = result.scene.mill->rotation.points;
  ASSERT_EQ(points.size(), 2u);
  EXPECT_EQ(points[1].time, 1);
  EXPECT_DOUBLE_EQ(points[1].value, -2 * kPi);
}

TEST(SceneReader, GivesAPeriodicMillItsDomain) {
  const SceneResult result =
      parse(changed(kGoodScene, "length = \"40 mm\"", "length = \"40 mm\"\nends = \"periodic\""));
  ASSERT_EQ(result.errors, Lines{});
  EXPECT_TRUE(result.scene.domain.periodic[2]);
  EXPECT_EQ(*result.scene.domain.low, Vec3(-0.15, -0.15, 0));
  EXPECT_EQ(*result.scene.domain.high, Vec3(0.15, 0.15, 0.04));
}

TEST(SceneReader, NamesWhatHasNoName) {
  std::string text = changed(kGoodScene, "name = \"ore\"\n", "");
  text = changed(text, "name = \"ball\"\nmaterial = \"steel\"", "material = \"ore\"");
  text = changed(text, "name = \"belt\"\n", "");
  const SceneResult result = parse(text);
  ASSERT_EQ(result.errors, Lines{});
  EXPECT_EQ(result.scene.particles[0].name, "ore");
  EXPECT_EQ(result.scene.particles[1].name, "ore_2");
  EXPECT_EQ(result.scene.planes[0].name, "wall_1");
}

TEST(SceneReader, GivesEntriesTheDiameterOfTheirSpecies) {
  const SceneResult result = parse(changed(
      kGoodScene, "count = 300", "entries = [{ position = [\"0 m\", \"0 m\", \"1 cm\"] }]"));
  ASSERT_EQ(result.errors, Lines{});
  const ParticleSpec& species = result.scene.particles[0];
  ASSERT_EQ(species.explicit_particles.size(), 1u);
  EXPECT_EQ(species.explicit_particles[0].diameter, 0.01375);
  EXPECT_EQ(species.explicit_particles[0].position, Vec3(0, 0, 0.01));
  EXPECT_FALSE(species.diameter);
}

// --- overrides

TEST(Overrides, ReachEveryPlaceByItsName) {
  const SceneResult result = parse(
      kGoodScene,
      {"particles.ball.count=2000", "contact.steel-ore.restitution=0.4", "mill.rotation=45 rpm",
       "mill.lifters.face_angle=0.1", "walls.belt.normal=[0, 0, 1]", "run.gravity=[0, 0, -1.5]",
       "materials.ore.density=3000", "run.title=7", "contact.law=linear-spring-dashpot",
       "contact.sliding_friction=0.7", "run.settle=until-rest"});
  ASSERT_EQ(result.errors, Lines{});
  EXPECT_EQ(result.scene.particles[1].count, 2000);
  EXPECT_EQ(result.scene.contact.pairs[1].restitution, 0.4);
  EXPECT_EQ(result.scene.contact.pairs.size(), 3u);
  EXPECT_DOUBLE_EQ(result.scene.mill->rotation.points[0].value, 1.5 * kPi);
  EXPECT_EQ(result.scene.mill->lifters->face_angle, 0.1);  // a bare number is SI
  EXPECT_EQ(result.scene.planes[0].normal, Vec3(0, 0, 1));
  EXPECT_EQ(result.scene.run.gravity, Vec3(0, 0, -1.5));
  EXPECT_EQ(result.scene.materials[0].density, 3000);
  EXPECT_EQ(result.scene.run.title, "7");
  EXPECT_EQ(result.scene.contact.sliding_friction, 0.7);
  EXPECT_EQ(result.scene.run.settle, SettleKind::kUntilRest);
}

TEST(Overrides, MakeThePairAndTheTableThatAreNotThere) {
  std::string text = changed(kGoodScene,
                             "[[contact.pair]]\nbetween = [\"ore\", \"steel\"]\n"
                             "restitution = 0.7\n",
                             "");
  const SceneResult result =
      parse(text, {"contact.ore-steel.restitution=0.2", "output.frames_every=10 ms"});
  ASSERT_EQ(result.errors, Lines{});
  EXPECT_EQ(result.scene.contact.pairs[2].a, "ore");
  EXPECT_EQ(result.scene.contact.pairs[2].restitution, 0.2);
  EXPECT_EQ(result.scene.output.frames_every, 0.01);
}

TEST(Overrides, DropTheOtherWaysToSayTheSame) {
  const SceneResult result = parse(
      kGoodScene, {"run.revolutions=4", "run.record_from_revolution=1", "particles.ball.mass=1 kg",
                   "particles.ore.filling_level=0.2", "particles.ore.equivalent_diameter=14 mm"});
  ASSERT_EQ(result.errors, Lines{});
  EXPECT_FALSE(result.scene.run.duration);
  EXPECT_FALSE(result.scene.run.record_from);
  EXPECT_EQ(result.scene.run.revolutions, 4);
  EXPECT_FALSE(result.scene.particles[1].count);
  EXPECT_EQ(result.scene.particles[1].mass, 1);
  EXPECT_EQ(result.scene.particles[0].diameter, 0.014);
}

TEST(Overrides, NameThemselvesInTheirMessages) {
  const struct {
    const char *text, *message;
  } rows[] = {
      {"mill.lenght=2", "unknown key 'lenght' - did you mean 'length'?"},
      {"mil.length=2", "unknown key 'mil' - did you mean 'mill'?"},
      {"mill.length=2 kg", "'length': unit 'kg' is no unit of length (use m, mm)"},
      {"mill.length=-1", "'length': -1 is not allowed (must be greater than 0)"},
      {"run.precision=duble",
       "'precision': \"duble\" is not known - did you mean \"double\"? (mixed, double, single)"},
      {"run.seed=1.5", "'seed' must be an integer, found 1.5"},
      {"particles.bal.count=3", "no particles named 'bal' - did you mean 'ball'? (ore, ball)"},
      {"particles.count=3", "address an entry by its name: particles.NAME.key=value"},
      {"walls.floor.scale=3", "no walls named 'floor' (belt)"},
      {"contact.ore-gold.restitution=0.3",
       "'ore-gold' is no pair of materials, write contact.A-B.key=value with two of (ore, steel)"},
      {"run.duration.x=1", "'duration' is a string, not a table"},
      {"run.duration", "must be key=value, for example run.duration=2"},
      {"=2", "must be key=value, for example run.duration=2"},
      {"run..duration=2", "'run..duration' is no dotted key"},
      {"contact.ore-ore.restitution=3",
       "'restitution': 3 is not allowed (must be greater than 0 and at most 1)"},
  };
  for (const auto& row : rows)
    EXPECT_EQ(parse(kGoodScene, {row.text}).errors,
              Lines{std::string("--set ") + row.text + ": error: " + row.message});
}

}  // namespace
}  // namespace quern
