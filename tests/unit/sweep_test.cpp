// Sweeps: what the reader takes and refuses, and which cases a design makes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "io/sweep_reader.h"
#include "scheduler/random.h"

namespace quern {
namespace {

const std::string kHead = "format = 1\nscene = \"lab.toml\"\n";
const std::string kSpeed =
    "[[factors]]\nkey = \"mill.rotation\"\nvalues = [\"20 rpm\", \"30 rpm\"]\n";

SweepSpec good(const std::string& text) {
  SweepResult result = parse_sweep(text, "/s/sweep.toml");
  EXPECT_TRUE(result.errors.empty()) << result.errors.front();
  return result.spec;
}

double uniform(std::size_t factor, std::size_t number) {
  return CounterRandom(factor + 7, RandomStream::kSweep, number).uniform();
}

struct BadSweep {
  const char* text;
  const char* line;
};

TEST(SweepReader, SaysWhereAndWhatIsWrong) {
  const BadSweep kBad[] = {
      {"scene = \"a.toml\"\nformat = 1\nfactor = 1\n[[factors]]\nkey = \"a\"\nvalues = [1]\n",
       "s.toml:3:1: error: unknown key 'factor' - did you mean 'factors'?"},
      {"format = 1\n[[factors]]\nkey = \"a\"\nvalues = [1]\n", "s.toml:1:1: error: the file needs 'scene' (the base scene)"},
      {"format = 2\nscene = \"a\"\n[[factors]]\nkey = \"a\"\nvalues = [1]\n",
       "s.toml:1:10: error: 'format' must be 1"},
      {"format = 1\nscene = \"a\"\ndesign = \"gird\"\n[[factors]]\nkey = \"a\"\nvalues = [1]\n",
       "s.toml:3:10: error: 'design'"},
      {"format = 1\nscene = \"a\"\n[[factors]]\nvalues = [1]\n",
       "s.toml:3:1: error: a factor needs 'key', or 'keys' that vary together"},
      {"format = 1\nscene = \"a\"\n[[factors]]\nkey = \"a\"\n",
       "s.toml:3:1: error: a factor needs 'values = [...]', or 'from' and 'to'"},
      {"format = 1\nscene = \"a\"\n[[factors]]\nkey = \"a\"\nvalues = [1, 2, 1]\n",
       "s.toml:5:17: error: '1' is there twice"},
      {"format = 1\nscene = \"a\"\n[[factors]]\nkeys = [\"a\", \"b\"]\nvalues = [[1, 2], [3]]\n",
       "s.toml:5:19: error: must be an array of 2 values, one for each of 'keys'"},
      {"format = 1\nscene = \"a\"\n[[factors]]\nkey = \"a\"\nfrom = 1\nto = 2\n",
       "error: 'from' and 'to' need design = \"latin-hypercube\""},
      {"format = 1\nscene = \"a\"\ndesign = \"latin-hypercube\"\nsamples = 4\n[[factors]]\nkey = "
       "\"a\"\nfrom = \"1 mm\"\nto = \"2 m\"\n",
       "s.toml:8:6: error: 'to' must be in the unit of 'from' (mm)"},
      {"format = 1\nscene = \"a\"\ndesign = \"latin-hypercube\"\n[[factors]]\nkey = \"a\"\nfrom = "
       "1\nto = 2\n",
       "needs 'samples', at least 2"},
      {"format = 1\nscene = \"a\"\nsamples = 3\n[[factors]]\nkey = \"a\"\nvalues = [1]\n",
       "s.toml:3:11: error: 'samples' is of design = \"latin-hypercube\" only"},
      {"format = 1\nscene = \"a\"\ndesign = \"list\"\n[[factors]]\nkey = \"a\"\nvalues = [1, 2]\n"
       "[[factors]]\nkey = \"b\"\nvalues = [1]\n",
       "s.toml:7:1: error: a list takes as many values of each factor: 1 here, 2 of the first"},
      {"format = 1\nscene = \"a\"\n[[factors]]\nkey = \"a\"\nvalues = [1]\n[[factors]]\nkey = "
       "\"a\"\nvalues = [1]\n",
       "s.toml:6:1: error: 'a' is varied twice"},
      {"format = 1\nscene = \"a\"\nreplicates = 2\n[[factors]]\nkey = \"run.seed\"\nvalues = [1]\n",
       "'run.seed' is what replicates vary"},
      {"format = 1\nscene = \"a\"\nreplicates = 0\n[[factors]]\nkey = \"a\"\nvalues = [1]\n",
       "s.toml:3:14: error: 'replicates': 0 is not allowed (must be greater than 0)"},
      {"format = 1\nscene = \"a\"\nreplicates = 100001\n[[factors]]\nkey = \"a\"\nvalues = [1]\n",
       "cases; at most 100000 are allowed"},
  };
  for (const BadSweep& bad : kBad) {
    const std::vector<std::string> errors = parse_sweep(bad.text, "s.toml").errors;
    ASSERT_FALSE(errors.empty()) << bad.line;
    EXPECT_NE(errors.front().find(bad.line), std::string::npos)
        << errors.front() << "\nwanted: " << bad.line;
  }
}

TEST(SweepReader, TakesTextsAsOneTypesThemAfterSet) {
  const SweepSpec spec =
      good(kHead +
           "[set]\nrun.duration = \"10 s\"\n\"run.title\" = \"true\"\n"
           "contact.sliding_friction = 0.25\n[[factors]]\nkey = \"particles.a.sizes\"\n"
           "values = [[{ from = \"1 mm\", count = 3 }]]\n");
  EXPECT_EQ(spec.scene, "/s/lab.toml");
  EXPECT_EQ(spec.set, (std::vector<std::string>{"run.duration=10 s", "run.title=\"true\"",
                                                "contact.sliding_friction=0.25"}));
  EXPECT_EQ(spec.factors[0].values[0][0], "[{ from = \"1 mm\", count = 3 }]");
  EXPECT_EQ(spec.places.at("run.duration=10 s"), "/s/sweep.toml:4:16");
}

TEST(SweepCases, OfAGridAreAllCombinationsWithAllSeeds) {
  SweepSpec spec = good(kHead + "replicates = 2\n" + kSpeed +
                        "[[factors]]\nkeys = [\"a.height\", \"b.count\"]\n"
                        "values = [[\"1 mm\", 10], [\"2 mm\", 20], [\"3 mm\", 30]]\n");
  const std::vector<SweepCase> cases = sweep_cases(spec, 5, uniform);
  ASSERT_EQ(cases.size(), 12u);
  EXPECT_EQ(cases[0].name, "rotation_20rpm_height_1mm_seed_5");
  EXPECT_EQ(cases[11].name, "rotation_30rpm_height_3mm_seed_6");
  EXPECT_EQ(cases[3].set, (std::vector<std::string>{"mill.rotation=20 rpm", "a.height=2 mm",
                                                    "b.count=20", "run.seed=6"}));
  EXPECT_EQ(cases[2].point, cases[3].point);
  std::set<std::string> names;
  for (const SweepCase& c : cases) names.insert(c.name);
  EXPECT_EQ(names.size(), 12u);
}

TEST(SweepCases, OfAListTakeTheValuesOfAllFactorsInStep) {
  SweepSpec spec = good(kHead + "design = \"list\"\n" + kSpeed +
                        "[[factors]]\nkey = \"a.height\"\nvalues = [\"1 mm\", \"2 mm\"]\n");
  const std::vector<SweepCase> cases = sweep_cases(spec, 1, uniform);
  ASSERT_EQ(cases.size(), 2u);
  EXPECT_EQ(cases[1].set, (std::vector<std::string>{"mill.rotation=30 rpm", "a.height=2 mm"}));
}

const std::string kCube =
    kHead +
    "design = \"latin-hypercube\"\nsamples = 20\n"
    "[[factors]]\nkey = \"mill.rotation\"\nfrom = \"10 rpm\"\nto = \"60 rpm\"\n"
    "[[factors]]\nkey = \"p.count\"\nfrom = 1\nto = 10\n" +
    "[[factors]]\nkey = \"mill.ends\"\nvalues = [\"walls\", \"open\"]\n";

TEST(SweepCases, OfAHypercubeFillEveryPartOfEveryRangeOnce) {
  SweepSpec spec = good(kCube);
  const std::vector<SweepCase> cases = sweep_cases(spec, 1, uniform);
  ASSERT_EQ(cases.size(), 20u);
  std::vector<int> strata(20), counts(11), ends(2);
  for (const SweepCase& c : cases) {
    double value = 0;
    std::string unit;
    ASSERT_TRUE(split_quantity(c.values[0], value, unit));
    EXPECT_EQ(unit, "rpm");
    ++strata.at(static_cast<std::size_t>(std::floor((value - 10) / 2.5)));
    ++counts.at(static_cast<std::size_t>(std::stoi(c.values[1])));
    ++ends.at(c.values[2] == "walls" ? 0 : 1);
  }
  EXPECT_EQ(strata, std::vector<int>(20, 1));
  EXPECT_EQ(counts, (std::vector<int>{0, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2}));
  EXPECT_EQ(ends, (std::vector<int>{10, 10}));
}

TEST(SweepCases, OfAHypercubeAreAFunctionOfTheRandomNumbers) {
  SweepSpec spec = good(kCube);
  const auto other = [](std::size_t factor, std::size_t number) {
    return CounterRandom(factor + 8, RandomStream::kSweep, number).uniform();
  };
  const auto sets = [&](const SweepRandom& random) {
    std::vector<std::vector<std::string>> all;
    for (const SweepCase& c : sweep_cases(spec, 1, random)) all.push_back(c.values);
    return all;
  };
  EXPECT_EQ(sets(uniform), sets(uniform));
  EXPECT_NE(sets(uniform), sets(other));
}

}  // namespace
}  // namespace quern
