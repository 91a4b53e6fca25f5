// Whether a run was steady over its recorded window, told from its series.
//
// A quantity is cut into ten blocks of time. Two questions are put to the block means:
//   drift   slope of the line fitted to them times the window: what it changed by from begin to end
//   step    mean of the blocks after a moment less mean of those before, at the moment that parts
//           them best, two blocks or more on either side
// each with a standard error from the scatter about the line, or about the two means. Samples that
// follow one another closely are alike; blocks are much less so, and count as independent.
//
// A quantity is not steady if its drift is beyond 3.36 or its step beyond 4.70 standard errors, and
// beyond 1 % of its scale. By chance each happens once in a hundred: the first is Student's t with
// 8 degrees of freedom, the second, which has a choice of moments, comes from 200 000 drawings of
// ten independent blocks. Noise that lasts as long as a block makes it one in seven for both
// together. The 1 % keeps a long run from failing over what nobody cares for. Where twice the
// drift's error is more than 10 % of the scale nothing can be told; a run is steady if all its
// quantities can be told and are.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace quern {

struct Change {
  double value, standard_error;
};

struct Trend {
  Change drift, step;
  double step_at = 0;  // of the window
};

// Of at least kTrendSamples equally spaced samples.
inline constexpr std::size_t kTrendSamples = 20;
Trend trend_of(std::span<const double> samples);

struct Watched {
  std::string name;  // "power"
  std::vector<double> samples;
  double scale = 0;  // what changes are a share of, > 0
};

enum class Verdict { kSteady, kNotSteady, kUnknown };

struct Steadiness {
  Verdict verdict = Verdict::kUnknown;
  std::string statement;      // one sentence
  std::vector<Trend> trends;  // of each quantity; none where there are too few samples
};

Steadiness judge_steadiness(const std::vector<Watched>& quantities);

}  // namespace quern
