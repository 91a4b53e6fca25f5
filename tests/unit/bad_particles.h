// Broken scenes whose mistake is in [[particles]]; see bad_scenes.h.
#pragma once

#include "tests/unit/bad_scenes.h"

namespace quern {

inline const BadScene kBadParticles[] = {
    {"PolyhedronWithoutMesh",
     "count = 300",
     R"(count = 300
shape = "polyhedron")",
     {R"~(41:1: error: particles 'ore' need 'mesh', the STL file of their polyhedra)~"}},
    {"ClassOfPolyhedraWithoutMesh",
     R"(diameter = "13.75 mm"
count = 300)",
     R"(sizes = [
  { from = "10 mm", to = "12 mm", count = 3 },
  { from = "12 mm", to = "14 mm", count = 3, shape = "polyhedron" },
])",
     {R"~(41:1: error: particles 'ore' need 'mesh', the STL file of their polyhedra)~"}},
    {"GroupWithADash",
     "count = 300",
     R"(count = 300
group = "coarse-ore")",
     {R"~(46:9: error: 'group': 'coarse-ore' may not hold -)~"}},
    {"GroupOfAWall",
     "count = 300",
     R"(count = 300
group = "liner")",
     {R"~(46:9: error: 'liner' is a group of walls already)~"}},
    {"UnknownShape",
     "count = 300",
     R"(count = 300
shape = "cube")",
     {R"~(46:9: error: 'shape': "cube" is not known (sphere, polyhedron))~"}},
    {"MeshTwice",
     "count = 300",
     R"(count = 300
mesh = "a.stl"
polyhedron_mesh = "b.stl")",
     {R"~(47:19: error: 'mesh' and 'polyhedron_mesh' are the same; give one)~"}},
    {"ShapeMeshNotThere",
     "count = 300",
     R"(count = 300
mesh = "no.stl")",
     {R"~(46:8: error: 'mesh': there is no file 'no.stl' in /nowhere)~"}},
    {"MeshListNotThere",
     "count = 300",
     R"(count = 300
polyhedron_mesh = ["a.stl", "b.stl"])",
     {R"~(46:19: error: 'polyhedron_mesh': there is no file 'a.stl' in /nowhere)~"}},
    {"MeshListEmpty",
     "count = 300",
     R"(count = 300
mesh = [])",
     {R"~(46:8: error: 'mesh' must not be empty)~"}},
    {"MeshListOfNumbers",
     "count = 300",
     R"(count = 300
mesh = [3])",
     {R"~(46:9: error: 'mesh' must hold texts, found 3)~"}},
    {"MeshOfANumber",
     "count = 300",
     R"(count = 300
mesh = 3)",
     {R"~(46:8: error: 'mesh' must be a string, found an integer)~"}},
    {"OrientationWithoutAnAxis",
     R"(diameter = "13.75 mm"
count = 300)",
     R"(diameter = "13.75 mm"
entries = [{ position = ["0 m", "0 m", "0 m"], orientation = { axis = [0, 0, 0], angle = "1 rad" } }])",
     {R"~(45:71: error: 'axis' must not be zero)~"}},
    {"OrientationWithoutAUnit",
     R"(diameter = "13.75 mm"
count = 300)",
     R"(diameter = "13.75 mm"
entries = [{ position = ["0 m", "0 m", "0 m"], orientation = { angle = 30 } }])",
     {R"~(45:72: error: 'angle' needs a unit, for example "30 deg")~"}},
    {"DiameterTwice",
     "count = 300",
     R"(count = 300
equivalent_diameter = "14 mm")",
     {R"~(46:23: error: 'diameter' and 'equivalent_diameter' both say the sizes; give one)~"}},
    {"CountAndMass",
     "count = 300",
     R"(count = 300
mass = "1 kg")",
     {R"~(46:8: error: 'count' and 'mass' both say how many; give one)~"}},
    {"NoAmount",
     "count = 300\n",
     "",
     {R"~(41:1: error: particles 'ore' need 'count', 'mass' or 'filling_level')~"}},
    {"NoSize",
     "diameter = \"13.75 mm\"\n",
     "",
     {R"~(41:1: error: particles 'ore' need 'diameter', 'sizes', 'distribution', 'entries' or 'csv')~"}},
    {"DiameterAndSizes",
     "count = 300",
     R"(sizes = [{ from = "1 mm", to = "2 mm", count = 3 }])",
     {R"~(45:9: error: 'diameter' and 'sizes' both say the sizes; give one)~"}},
    {"SizesFromAboveTo",
     R"(diameter = "13.75 mm"
count = 300)",
     R"(sizes = [{ from = "3 mm", to = "2 mm", count = 3 }])",
     {R"~(44:19: error: 'from': 0.003 m is above 'to' (0.002 m))~"}},
    {"SharesNotOne",
     R"(diameter = "13.75 mm")",
     R"(sizes = [{ from = "1 mm", to = "2 mm", mass_share = 0.4 }, { from = "2 mm", to = "3 mm", mass_share = "50 %" }])",
     {R"~(44:9: error: 'sizes': the mass shares add up to 0.9, they must add up to 1)~"}},
    {"DistributionOfNothing",
     R"(diameter = "13.75 mm")",
     "distribution = {}",
     {R"~(44:16: error: 'distribution' needs one of 'table', 'rosin_rammler')~"}},
    {"PassingFalls",
     R"(diameter = "13.75 mm")",
     R"(distribution = { table = [["1 mm", 0.5], ["2 mm", 0.4]] })",
     {R"~(44:42: error: 'table': diameters must increase, shares must not fall)~"}},
    {"RosinRammlerIncomplete",
     R"(diameter = "13.75 mm")",
     R"(distribution = { rosin_rammler = { d63 = "10 mm", exponent = 2, from = "1 mm" } })",
     {R"~(44:34: error: [particles.distribution.rosin_rammler] needs 'to' (largest diameter))~"}},
    {"NameTwice",
     R"(name = "ball")",
     R"(name = "ore")",
     {R"~(47:8: error: the name 'ore' is taken)~"}},
    {"NameWithASlash",
     R"(name = "ball")",
     R"(name = "my/ball")",
     {R"~(47:8: error: name 'my/ball' may hold letters, digits, _ and - only)~"}},
    {"ParticlesAsATable",
     R"([[particles]]
name = "ball")",
     R"([[particle]]
name = "ball")",
     {R"~(46:3: error: unknown key 'particle' - did you mean 'particles'?)~"}},
    {"EmptyName",
     R"(name = "ball")",
     R"(name = "")",
     {R"~(47:8: error: 'name' must not be empty)~"}},
    {"CsvNotThere",
     R"(diameter = "13.75 mm"
count = 300)",
     R"(csv = "no.csv")",
     {R"~(44:7: error: 'csv': there is no file 'no.csv' in /nowhere)~"}},
    {"EntryWithoutPosition",
     "count = 300",
     R"(entries = [{ velocity = ["0 m/s", "0 m/s", "0 m/s"] }])",
     {R"~(45:12: error: [[particles.entries]] needs 'position' (of the centre))~"}},
    {"TooManyParticles",
     "count = 300",
     "count = 5000000000",
     {R"~(41:1: error: 5e+09 particles are too many (at most 4e+09))~"}},
};

}  // namespace quern
