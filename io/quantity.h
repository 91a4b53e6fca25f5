// Quantities: text with a unit ("10.5 rpm", "152 mm") to SI and back.
//
// The only place that knows units. Each dimension has its units as a fraction (SI value = number *
// numerator / denominator), so that "152 mm" is exactly the double 0.152. The SI unit comes first
// and is what format_quantity() writes; the units named in messages are the first few.
#pragma once

#include <string>
#include <string_view>

namespace quern {

enum class Dimension {
  kNumber,  // no unit: friction, restitution, counts
  kShare,   // a number, or percent
  kLength,
  kTime,
  kMass,
  kSpeed,
  kAcceleration,
  kAngularVelocity,
  kFrequency,
  kAngle,
  kStiffness,
  kDensity,
  kHardness,
  kEnergy,
  kPressure,
};

struct QuantityResult {
  double value = 0;   // SI
  std::string error;  // empty: fine; else what is wrong and what is allowed
};

// Reads "NUMBER UNIT" (the space may be missing). Refuses a missing, unknown or foreign unit,
// decimal commas, infinities and NaN.
QuantityResult parse_quantity(std::string_view text, Dimension dimension);

// A whole text that is one finite number ("1e-5"); false if it is anything else.
bool parse_number(std::string_view text, double& value);

// The shortest text that reads back to the same double, with the SI unit where there is one.
std::string format_quantity(double value, Dimension dimension);
std::string format_number(double value);

const char* dimension_name(Dimension dimension);             // "length"
const char* si_unit(Dimension dimension);                    // "m"; "" for numbers
std::string example_of(Dimension dimension, double number);  // "0.3 m", for messages

}  // namespace quern
