// Broken scenes: one change each to a good one, and every message that must come of it. Those of
// [[particles]] are in bad_particles.h.
#pragma once

#include <string>
#include <vector>

namespace quern {

struct BadScene {
  const char* name;
  const char* find;                   // this text of kGoodScene ...
  const char* replace;                // ... becomes this
  std::vector<std::string> messages;  // all of them, without "mill.toml:"
};

inline const std::string kGoodScene = R"(format = 1
[run]
duration = "2 s"
record_from = "1 s"
time_step = "1e-5 s"
seed = 1
gravity = ["0 m/s^2", "-9.81 m/s^2", "0 m/s^2"]
[materials.ore]
density = "4500 kg/m^3"
[materials.steel]
density = "7800 kg/m^3"
[contact]
law = "linear-spring-dashpot"
normal_stiffness = "1e5 N/m"
tangential_stiffness = "4e4 N/m"
sliding_friction = 0.3
[[contact.pair]]
between = ["ore", "ore"]
restitution = 0.6
[[contact.pair]]
between = ["ore", "steel"]
restitution = 0.7
[[contact.pair]]
between = ["steel", "steel"]
restitution = 0.8
[mill]
material = "steel"
diameter = "0.3 m"
length = "40 mm"
rotation = "30 rpm"
[mill.lifters]
count = 18
height = "10 mm"
face_angle = "14 deg"
top_width = "10 mm"
[[walls]]
name = "belt"
material = "steel"
point = ["0 m", "-1 m", "0 m"]
normal = [0, 1, 0]
[[particles]]
name = "ore"
material = "ore"
diameter = "13.75 mm"
count = 300
[[particles]]
name = "ball"
material = "steel"
diameter = "18 mm"
count = 80
)";

inline const BadScene kBadScenes[] = {
    {"MisspeltKey",
     R"(length = "40 mm")",
     R"(lenght = "40 mm")",
     {R"~(29:1: error: unknown key 'lenght' - did you mean 'length'?)~"}},
    {"MissingUnit",
     R"(diameter = "0.3 m")",
     "diameter = 0.3",
     {R"~(28:12: error: 'diameter' needs a unit, for example "0.3 m")~"}},
    {"StringForACount",
     "count = 300",
     R"(count = "300")",
     {R"~(45:9: error: 'count' must be an integer, found a string)~"}},
    {"UnitOfTheWrongKind",
     R"(height = "10 mm")",
     R"(height = "10 kg")",
     {R"~(33:10: error: 'height': unit 'kg' is no unit of length (use m, mm))~"}},
    {"UnknownUnit",
     R"(height = "10 mm")",
     R"(height = "10 inch")",
     {R"~(33:10: error: 'height': unit 'inch' is no unit of length (use m, mm))~"}},
    {"DecimalComma",
     R"(diameter = "13.75 mm")",
     R"(diameter = "13,75 mm")",
     {R"~(44:12: error: 'diameter': "13,75 mm" has a comma; write the decimals with a point)~"}},
    {"QuantityWithoutANumber",
     R"(duration = "2 s")",
     R"(duration = "long")",
     {R"~(3:12: error: 'duration': "long" is no number with a unit, for example "1 s")~"}},
    {"FractionForACount",
     "count = 80",
     "count = 80.5",
     {R"~(50:9: error: 'count' must be an integer, found 80.5)~"}},
    {"NegativeCalm",
     R"(seed = 1)",
     R"(calm = "-1 s")",
     {R"~(6:8: error: 'calm': "-1 s" is not allowed (must not be negative))~"}},
    {"UnknownTable",
     "[mill.lifters]",
     "[mill.liftres]",
     {R"~(31:7: error: unknown key 'liftres' - did you mean 'lifters'?)~"}},
    {"KeyOfAnotherTable",
     R"(length = "40 mm")",
     R"(length = "40 mm"
seed = 3)",
     {R"~(30:1: error: unknown key 'seed' here - it is 'run.seed')~"}},
    {"WearWithoutHardness",
     "format = 1",
     R"(format = 1
wear = { velocity = "liner" })",
     {R"~(2:8: error: [wear] needs the hardness of the walls: give materials.steel.hardness, or 'flow_pressure' here)~"}},
    {"UnknownMaterial",
     R"([mill]
material = "steel")",
     R"([mill]
material = "stel")",
     {R"~(27:12: error: 'material': no material 'stel' - did you mean 'steel'? (ore, steel))~"}},
    {"UnknownMaterialInAPair",
     R"(between = ["ore", "steel"])",
     R"(between = ["ore", "rubber"])",
     {R"~(21:11: error: 'between': no material 'rubber' (ore, steel))~"}},
    {"PairTwice",
     R"(between = ["steel", "steel"])",
     R"(between = ["ore", "ore"])",
     {R"~(24:11: error: the pair ore-ore was given before, in line 18)~"}},
    {"PairOfThree",
     R"(between = ["ore", "ore"])",
     R"(between = ["ore", "ore", "ore"])",
     {R"~(18:11: error: 'between' must name two materials, for example ["ore", "steel"])~"}},
    {"MissingCoefficient",
     "sliding_friction = 0.3\n",
     "",
     {R"~(12:1: error: [contact] has no 'sliding_friction' for ore-ore, ore-steel, steel-steel: give it here or in a [[contact.pair]])~"}},
    {"RestitutionAboveOne",
     "restitution = 0.6",
     "restitution = 1.2",
     {R"~(19:15: error: 'restitution': 1.2 is not allowed (must be greater than 0 and at most 1))~"}},
    {"RestitutionZero",
     "restitution = 0.6",
     "restitution = 0",
     {R"~(19:15: error: 'restitution': 0 is not allowed (must be greater than 0 and at most 1))~"}},
    {"NegativeFriction",
     "sliding_friction = 0.3",
     "sliding_friction = -0.3",
     {R"~(16:20: error: 'sliding_friction': -0.3 is not allowed (must not be negative))~"}},
    {"FrictionWithAUnit",
     "sliding_friction = 0.3",
     R"(sliding_friction = "0.3 N/m")",
     {R"~(16:20: error: 'sliding_friction' must be a number, found a string)~"}},
    {"NoDensity",
     R"([materials.ore]
density = "4500 kg/m^3")",
     "[materials.ore]",
     {R"~(8:1: error: material 'ore' is used by particles and needs a 'density' greater than 0)~"}},
    {"ZeroDensity",
     R"(density = "4500 kg/m^3")",
     R"(density = "0 kg/m^3")",
     {R"~(9:11: error: material 'ore' is used by particles and needs a 'density' greater than 0)~"}},
    {"HertzMindlinWithoutModuli",
     R"(law = "linear-spring-dashpot")",
     R"(law = "hertz-mindlin")",
     {R"~(8:1: error: material 'ore' needs a 'young_modulus': law = "hertz-mindlin" asks for it)~",
      R"~(8:1: error: material 'ore' needs a 'poisson_ratio': law = "hertz-mindlin" asks for it)~",
      R"~(10:1: error: material 'steel' needs a 'young_modulus': law = "hertz-mindlin" asks for it)~",
      R"~(10:1: error: material 'steel' needs a 'poisson_ratio': law = "hertz-mindlin" asks for it)~"}},
    {"HertzMindlinByVolume",
     R"(density = "4500 kg/m^3"
[materials.steel]
density = "7800 kg/m^3"
[contact]
law = "linear-spring-dashpot")",
     R"(density = "4500 kg/m^3"
young_modulus = "50 MPa"
poisson_ratio = 0.3
[materials.steel]
density = "7800 kg/m^3"
young_modulus = "50 MPa"
poisson_ratio = 0.3
[contact]
normal_model = "volume"
law = "hertz-mindlin")",
     {R"~(17:16: error: 'normal_model': "volume" is no Hertz contact: it needs law = "linear-spring-dashpot")~"}},
    {"ModuliThatAreNone",
     R"(density = "7800 kg/m^3")",
     "density = \"7800 kg/m^3\"\nyoung_modulus = \"0 GPa\"\npoisson_ratio = 0.6",
     {R"~(12:17: error: 'young_modulus': "0 GPa" is not allowed (must be greater than 0))~",
      R"~(13:17: error: 'poisson_ratio': 0.6 is not allowed (must be between 0 and 0.5))~"}},
    {"ZeroTimeStep",
     R"(time_step = "1e-5 s")",
     R"(time_step = "0 s")",
     {R"~(5:13: error: 'time_step': "0 s" is not allowed (must be greater than 0))~"}},
    {"NegativeTimeStep",
     R"(time_step = "1e-5 s")",
     R"(time_step = "-1e-5 s")",
     {R"~(5:13: error: 'time_step': "-1e-5 s" is not allowed (must be greater than 0))~"}},
    {"RecordBeyondTheEnd",
     R"(record_from = "1 s")",
     R"(record_from = "3 s")",
     {R"~(4:15: error: 'record_from': 3 s is not before the end of the run (2 s))~"}},
    {"NoDuration",
     "duration = \"2 s\"\n",
     "",
     {R"~(2:1: error: [run] needs 'duration' or 'revolutions')~"}},
    {"DurationAndRevolutions",
     R"(duration = "2 s")",
     R"(duration = "2 s"
revolutions = 1)",
     {R"~(4:15: error: give 'duration' or 'revolutions', not both)~"}},
    {"RecordRevolutionBeyondTheEnd",
     R"(record_from = "1 s")",
     "record_from_revolution = 1.5",
     {R"~(4:26: error: 'record_from_revolution': 3 s is not before the end of the run (2 s))~"}},
    {"UnknownLaw",
     R"(law = "linear-spring-dashpot")",
     R"(law = "hertz")",
     {R"~(13:7: error: 'law': "hertz" is not known (linear-spring-dashpot, hertz-mindlin))~"}},
    {"UnknownEnds",
     R"(rotation = "30 rpm")",
     R"(rotation = "30 rpm"
ends = "periodical")",
     {R"~(31:8: error: 'ends': "periodical" is not known - did you mean "periodic"? (walls, periodic, open))~"}},
    {"UnknownPrecision",
     "seed = 1",
     R"(seed = 1
precision = "half")",
     {R"~(7:13: error: 'precision': "half" is not known (mixed, double, single))~"}},
    {"RelaxOfWhatRainsIn",
     R"(seed = 1
gravity = ["0 m/s^2", "-9.81 m/s^2", "0 m/s^2"])",
     R"(seed = 1
relax = "0.2 s"
gravity = ["0 m/s^2", "-9.81 m/s^2", "0 m/s^2"]
[fill]
method = "rain"
over = "1 s")",
     {R"~(7:9: error: 'relax' is for particles that are there from the start: not with rain)~"}},
    {"CapWithoutRelaxing",
     "seed = 1",
     R"(seed = 1
overlap_cap = "0.1 mm")",
     {R"~(7:15: error: 'overlap_cap' needs 'relax')~"}},
    {"UnknownOverlap",
     R"(law = "linear-spring-dashpot")",
     R"(overlap = "depth")",
     {R"~(13:11: error: 'overlap': "depth" is not known (chord, width))~"}},
    {"VolumeStiffnessOfALength",
     R"(law = "linear-spring-dashpot")",
     R"(volume_stiffness = "3 N/m")",
     {R"~(13:20: error: 'volume_stiffness': unit 'N/m' is no unit of pressure (use Pa, MPa, GPa))~"}},
    {"NegativeSeed",
     "seed = 1",
     "seed = -1",
     {R"~(6:8: error: 'seed': -1 is not allowed (must not be negative))~"}},
    {"GravityOfTwo",
     R"(gravity = ["0 m/s^2", "-9.81 m/s^2", "0 m/s^2"])",
     R"(gravity = ["0 m/s^2", "-9.81 m/s^2"])",
     {R"~(7:11: error: 'gravity' must be an array of 3 values, found 2 values)~"}},
    {"GravityWithoutUnits",
     R"(gravity = ["0 m/s^2", "-9.81 m/s^2", "0 m/s^2"])",
     "gravity = [0, -9.81, 0]",
     {R"~(7:12: error: 'gravity' needs a unit, for example "0 m/s^2")~",
      R"~(7:15: error: 'gravity' needs a unit, for example "-9.81 m/s^2")~",
      R"~(7:22: error: 'gravity' needs a unit, for example "0 m/s^2")~"}},
    {"MissingMillKey",
     "diameter = \"0.3 m\"\n",
     "",
     {R"~(26:1: error: [mill] needs 'diameter' (inside the shell))~"}},
    {"LiftersWiderThanThePitch",
     "count = 18",
     "count = 80",
     {R"~(35:13: error: 'top_width': the base of a lifter (0.01499 m) is wider than the pitch of 80 lifters (0.01178 m))~"}},
    {"LiftersHigherThanTheRadius",
     R"(height = "10 mm")",
     R"(height = "160 mm")",
     {R"~(33:10: error: 'height': 0.16 m is not less than the mill's radius (0.15 m))~"}},
    {"FaceAngleTooLarge",
     R"(face_angle = "14 deg")",
     R"(face_angle = "95 deg")",
     {R"~(34:14: error: 'face_angle': "95 deg" is not allowed (must be at least 0 deg and less than 90 deg))~"}},
    {"ScheduleOutOfOrder",
     R"(rotation = "30 rpm")",
     R"(rotation = [{ time = "1 s", value = "0 rpm" }, { time = "0 s", value = "30 rpm" }])",
     {R"~(30:48: error: 'rotation': the times of a schedule must increase)~"}},
    {"ScheduleRowIncomplete",
     R"(rotation = "30 rpm")",
     R"(rotation = [{ time = "1 s" }])",
     {R"~(30:13: error: [[mill.rotation]] needs 'value' (rate))~"}},
    {"TableForAnArray",
     "[[walls]]",
     "[walls]",
     {R"~(36:1: error: 'walls' must be an array: write [[walls]], found a table)~"}},
    {"WallOfNoKind",
     "point = [\"0 m\", \"-1 m\", \"0 m\"]\nnormal = [0, 1, 0]\n",
     "",
     {R"~(36:1: error: a wall needs 'mesh', or 'point' and 'normal', or 'low' and 'high')~"}},
    {"PlaneWithoutNormal",
     "normal = [0, 1, 0]\n",
     "",
     {R"~(36:1: error: a plane needs 'normal')~"}},
    {"PlaneWithAMesh",
     "normal = [0, 1, 0]",
     "normal = [0, 1, 0]\nscale = 2",
     {R"~(41:9: error: 'scale' belongs to a mesh, this wall is a plane)~"}},
    {"NormalZero",
     "normal = [0, 1, 0]",
     "normal = [0, 0, 0]",
     {R"~(40:10: error: 'normal' must not be zero)~"}},
    {"MeshNotThere",
     R"(point = ["0 m", "-1 m", "0 m"]
normal = [0, 1, 0])",
     R"(mesh = "no.stl")",
     {R"~(39:8: error: 'mesh': there is no file 'no.stl' in /nowhere)~"}},
    {"BoxUpsideDown",
     R"(point = ["0 m", "-1 m", "0 m"]
normal = [0, 1, 0])",
     R"(low = ["0 m", "0 m", "0 m"]
high = ["1 m", "1 m", "0 m"])",
     {R"~(40:8: error: 'high': z = 0 m is not above that of 'low' (0 m))~"}},
    {"MotionWithoutKind",
     "normal = [0, 1, 0]",
     R"(normal = [0, 1, 0]
motion = { rate = "1 rpm" })",
     {R"~(41:10: error: a motion needs 'kind' (fixed, rotation, translation, oscillation))~"}},
    {"MotionWithoutRate",
     "normal = [0, 1, 0]",
     R"(normal = [0, 1, 0]
motion = { kind = "rotation" })",
     {R"~(41:10: error: a motion of kind "rotation" needs 'rate')~"}},
    {"MotionWithTheWrongUnit",
     "normal = [0, 1, 0]",
     R"(normal = [0, 1, 0]
motion = { kind = "translation", rate = "1 rpm" })",
     {R"~(41:41: error: 'rate': unit 'rpm' is no unit of speed (use m/s, mm/s))~"}},
    {"PeriodicAxisUnknown",
     "[materials.ore]",
     R"([domain]
periodic = ["w"]
[materials.ore])",
     {R"~(9:13: error: 'periodic': "w" is no axis ("x", "y", "z"))~"}},
    {"DomainHalf",
     "[materials.ore]",
     R"([domain]
low = ["0 m", "0 m", "0 m"]
[materials.ore])",
     {R"~(9:7: error: 'low' and 'high' must be given together)~"}},
    {"StartFileMissing",
     "seed = 1",
     R"(seed = 1
start = "file")",
     {R"~(7:9: error: 'start': "file" needs 'start_file')~"}},
    {"FutureFormat",
     "format = 1",
     "format = 2",
     {R"~(1:10: error: 'format': 2 is not known (1))~"}},
    {"InfiniteNumber",
     "sliding_friction = 0.3",
     "sliding_friction = inf",
     {R"~(16:20: error: 'sliding_friction' must be finite)~"}},
    {"KeyTwice",
     "seed = 1",
     "seed = 1\nseed = 2",
     {R"~(7:8: error: syntax: key-value pair: cannot redefine existing integer 'seed')~"}},
    {"StringNotClosed",
     R"(name = "ball")",
     R"(name = "ball)",
     {R"~(47:13: error: syntax: a string is not closed in its line, or holds a control character)~"}},
    {"NoValue",
     "seed = 1",
     "seed =",
     {R"~(6:7: error: syntax: key-value pair: expected value, saw '\n')~"}},
    {"HeaderNotClosed",
     "[mill]",
     "[mill",
     {R"~(26:6: error: syntax: table header: expected ']', saw '\n')~"}},
    {"HeaderWithoutAName",
     "[mill]\n",
     "[=]\n",
     {R"~(26:1: error: syntax: a table header needs a name, as in [mill])~"}},
    {"ChargeShapeWithoutAMill",
     R"([mill]
material = "steel"
diameter = "0.3 m"
length = "40 mm"
rotation = "30 rpm"
[mill.lifters]
count = 18
height = "10 mm"
face_angle = "14 deg"
top_width = "10 mm")",
     "[record]\ncharge_shape = true",
     {R"~(27:16: error: 'charge_shape' needs a [mill])~"}},
    {"ContactsWithoutFrames",
     R"([mill]
)",
     "[output]\nframes_every = \"0 s\"\ncontacts = true\n[mill]\n",
     {R"~(28:12: error: 'contacts' needs frames_every)~"}},
    {"ContactsThatAreNoAnswer",
     R"([mill]
)",
     "[output]\ncontacts = \"all\"\n[mill]\n",
     {R"~(27:12: error: 'contacts' must be true or false, found a string)~"}},
    {"SnapshotsOfNothing",
     R"([mill]
)",
     "[record]\nsnapshots_every = \"1 s\"\ncell_width = \"2 mm\"\n[mill]\n",
     {R"~(27:19: error: 'snapshots_every' needs charge_shape = true, classes = true or [[record.zones]])~",
      R"~(28:14: error: 'cell_width' needs charge_shape = true)~"}},
    {"ZonesThatAreNone",
     R"([mill]
)",
     R"([record]
classes = true
[[record.zones]]
name = "toe zone"
radius_from = "0.2 m"
[[record.zones]]
name = "toe"
radius_from = "10 cm"
radius_to = "5 cm"
angle_from = "10 deg"
angle_to = "10 deg"
[[record.zones]]
name = "toe"
angle_to = "400 deg"
radius_form = "1 m"
[mill]
)",
     {R"~(29:8: error: name 'toe zone' may hold letters, digits, _ and - only)~",
      R"~(30:15: error: 'radius_from': 0.2 m is not inside the mill's radius (0.15 m))~",
      R"~(34:13: error: 'radius_to': 0.05 m is not above 'radius_from' (0.1 m))~",
      R"~(36:12: error: 'angle_to': from 10 to 10 degrees is nothing)~",
      R"~(38:8: error: the name 'toe' is taken)~",
      R"~(39:12: error: 'angle_to': from 0 to 400 degrees is more than a full turn)~",
      R"~(40:1: error: unknown key 'radius_form' - did you mean 'radius_from'?)~"}},
    {"CellsTooWide",
     R"([mill]
)",
     "[record]\ncharge_shape = true\ncell_width = \"10 cm\"\n[mill]\n",
     {R"~(28:14: error: 'cell_width': 0.1 m leaves fewer than two cells along the mill's radius)~"}},
    {"BraceForABracket",
     "normal = [0, 1, 0]",
     "normal = [0, 1, }",
     {R"~(40:17: error: syntax: '}' cannot close '[')~"}},
    {"LetterOutsideStrings",
     "seed = 1",
     "größe = 1",
     {R"~(6:3: error: 'öß' may only stand in a string or a comment (keys and numbers are plain ASCII))~"}},
    {"LetterAfterAValue",
     "seed = 1",
     "seed = 1µ",
     {R"~(6:9: error: 'µ' may only stand in a string or a comment (keys and numbers are plain ASCII))~"}},
    {"InvalidUtf8InAString",
     R"(name = "ball")",
     "name = \"b\xff"
     "ll\"",
     {R"~(47:9: error: syntax: Encountered invalid utf-8 sequence)~"}},
};

}  // namespace quern
