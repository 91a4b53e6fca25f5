// Sweeps: a base scene, what is varied and how, read from TOML like a scene; and the cases of it.
//
//   format = 1
//   scene = "lab_mill.toml"                 # from the sweep's folder
//   design = "grid"                         # or "list", "latin-hypercube" with samples, seed
//   replicates = 2                          # run.seed, run.seed + 1 ...
//   [set]                                   # as --set: of all cases
//   "run.duration" = "10 s"
//   [[factors]]
//   key = "mill.rotation"                   # or keys = [...], values = [[...], ...]: vary together
//   values = ["20 rpm", "30 rpm"]           # or from, to of a hypercube
//
// Values are texts as `quern run --set` takes them, so that a case can be made by hand. Whether the
// scene bears them is for the scene's reader to say; place_of() tells where each came from.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace quern {

enum class SweepDesign { kGrid, kList, kLatinHypercube };

struct SweepFactor {
  std::vector<std::string> keys;                 // they vary together
  std::vector<std::vector<std::string>> values;  // of each level the text of each key
  // Of a hypercube instead: ends of each key's range, in `units`; whole: only whole numbers.
  std::vector<double> from, to;
  std::vector<std::string> units;
  std::vector<bool> whole;
  std::string place;  // as a message begins

  bool ranges() const { return !from.empty(); }
};

struct SweepSpec {
  std::string file, scene;       // paths
  std::vector<std::string> set;  // key=value
  std::vector<SweepFactor> factors;
  SweepDesign design = SweepDesign::kGrid;
  long samples = 0;        // of a hypercube
  std::uint64_t seed = 1;  // likewise
  long replicates = 1;
  std::vector<std::string> responses;         // names in summary.json; empty: the usual ones
  std::map<std::string, std::string> places;  // key=value -> where it stands
};

struct SweepResult {
  SweepSpec spec;
  std::vector<std::string> errors;  // complete lines, in the order of the file
};

SweepResult read_sweep(const std::string& path);
SweepResult parse_sweep(const std::string& text, const std::string& path);

struct SweepCase {
  std::string name;                 // of its folder
  std::vector<std::string> values;  // a text for each factor: of its first key
  std::size_t point = 0;            // cases of one point differ in their seed only
  std::uint64_t seed = 0;           // run.seed
  std::vector<std::string> set;     // all key=value of the case
};

// In [0, 1), a function of the factor and a number.
using SweepRandom = std::function<double(std::size_t factor, std::size_t number)>;

// The first factor varies slowest, replicates fastest. Of a hypercube each factor has one sample in
// each of `samples` equal parts of its range. `seed`: run.seed of the first replicate.
std::vector<SweepCase> sweep_cases(SweepSpec& spec, std::uint64_t seed, const SweepRandom& random);

// A value as its number and unit ("30 rpm"); false: it is none.
bool split_quantity(const std::string& text, double& number, std::string& unit);

}  // namespace quern
