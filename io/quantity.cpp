// The table of dimensions and units, and the reading of numbers.
#include "io/quantity.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <span>

#include "soa/base.h"

namespace quern {
namespace {

struct UnitRow {
  const char* symbol;
  double numerator, denominator;
};

struct DimensionRow {
  Dimension dimension;
  const char* name;
  const char* advice;  // the units named in messages
  std::span<const UnitRow> units;
};

constexpr UnitRow kShares[] = {{"%", 1, 100}};
constexpr UnitRow kLengths[] = {
    {"m", 1, 1}, {"mm", 1, 1e3}, {"cm", 1, 1e2}, {"um", 1, 1e6}, {"km", 1e3, 1}};
constexpr UnitRow kTimes[] = {
    {"s", 1, 1}, {"ms", 1, 1e3}, {"us", 1, 1e6}, {"min", 60, 1}, {"h", 3600, 1}};
constexpr UnitRow kMasses[] = {{"kg", 1, 1}, {"g", 1, 1e3}, {"mg", 1, 1e6}, {"t", 1e3, 1}};
constexpr UnitRow kSpeeds[] = {{"m/s", 1, 1}, {"mm/s", 1, 1e3}, {"cm/s", 1, 1e2}, {"km/h", 1, 3.6}};
constexpr UnitRow kAccelerations[] = {{"m/s^2", 1, 1}, {"mm/s^2", 1, 1e3}};
constexpr UnitRow kAngularVelocities[] = {
    {"rad/s", 1, 1}, {"rpm", 2 * kPi, 60}, {"deg/s", kPi, 180}, {"Hz", 2 * kPi, 1}};
constexpr UnitRow kFrequencies[] = {{"Hz", 1, 1}, {"1/s", 1, 1}, {"kHz", 1e3, 1}, {"rpm", 1, 60}};
constexpr UnitRow kAngles[] = {{"rad", 1, 1}, {"deg", kPi, 180}};
constexpr UnitRow kStiffnesses[] = {
    {"N/m", 1, 1}, {"kN/m", 1e3, 1}, {"MN/m", 1e6, 1}, {"N/mm", 1e3, 1}};
constexpr UnitRow kDensities[] = {{"kg/m^3", 1, 1}, {"t/m^3", 1e3, 1}, {"g/cm^3", 1e3, 1}};
constexpr UnitRow kHardnesses[] = {{"HV", 1, 1}};
constexpr UnitRow kPressures[] = {{"Pa", 1, 1}, {"kPa", 1e3, 1}, {"MPa", 1e6, 1}, {"GPa", 1e9, 1}};
constexpr UnitRow kEnergies[] = {{"J", 1, 1}, {"mJ", 1, 1e3}, {"kJ", 1e3, 1}};

const DimensionRow kDimensions[] = {
    {Dimension::kNumber, "number", "", {}},
    {Dimension::kShare, "share", "%", kShares},
    {Dimension::kLength, "length", "m, mm", kLengths},
    {Dimension::kTime, "time", "s, ms, min, h", kTimes},
    {Dimension::kMass, "mass", "kg, g, t", kMasses},
    {Dimension::kSpeed, "speed", "m/s, mm/s", kSpeeds},
    {Dimension::kAcceleration, "acceleration", "m/s^2", kAccelerations},
    {Dimension::kAngularVelocity, "angular velocity", "rpm, rad/s, deg/s, Hz", kAngularVelocities},
    {Dimension::kFrequency, "frequency", "Hz, rpm", kFrequencies},
    {Dimension::kAngle, "angle", "deg, rad", kAngles},
    {Dimension::kStiffness, "stiffness", "N/m, kN/m, MN/m", kStiffnesses},
    {Dimension::kDensity, "density", "kg/m^3, t/m^3, g/cm^3", kDensities},
    {Dimension::kHardness, "hardness", "HV", kHardnesses},
    {Dimension::kEnergy, "energy", "J, mJ", kEnergies},
    {Dimension::kPressure, "pressure", "Pa, MPa, GPa", kPressures},
};

const DimensionRow& row_of(Dimension dimension) {
  const DimensionRow& row = kDimensions[static_cast<std::size_t>(dimension)];
  QUERN_CHECK(row.dimension == dimension);
  return row;
}

std::string_view trim(std::string_view text) {
  const auto begin = text.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

// Reads the number that `text` starts with and moves past it.
bool take_number(std::string_view& text, double& value) {
  std::string_view rest = text;
  if (rest.starts_with('+')) rest.remove_prefix(1);
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
  if (error != std::errc() || !std::isfinite(value)) return false;
  text = rest.substr(static_cast<std::size_t>(end - rest.data()));
  return true;
}

std::string wrong_unit(std::string_view symbol, const DimensionRow& row) {
  if (row.units.empty()) return fmt::format("is a plain number, without the unit '{}'", symbol);
  return fmt::format("unit '{}' is no unit of {} (use {})", symbol, row.name, row.advice);
}

}  // namespace

const char* dimension_name(Dimension dimension) { return row_of(dimension).name; }

const char* si_unit(Dimension dimension) {
  const DimensionRow& row = row_of(dimension);
  return row.units.empty() || dimension == Dimension::kShare ? "" : row.units[0].symbol;
}

std::string format_number(double value) {
  char buffer[40];
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, value);
  QUERN_CHECK(error == std::errc());
  std::string text(buffer, end);
  return text == "-0" ? "0" : text;
}

std::string format_quantity(double value, Dimension dimension) {
  const std::string unit = si_unit(dimension);
  return unit.empty() ? format_number(value) : format_number(value) + " " + unit;
}

std::string example_of(Dimension dimension, double number) {
  const DimensionRow& row = row_of(dimension);
  const std::string advice = row.advice;
  return format_number(number) + " " + advice.substr(0, advice.find(','));
}

bool parse_number(std::string_view text, double& value) {
  text = trim(text);
  return take_number(text, value) && text.empty();
}

QuantityResult parse_quantity(std::string_view text, Dimension dimension) {
  const DimensionRow& row = row_of(dimension);
  std::string_view rest = trim(text);
  double number = 0;
  if (!take_number(rest, number))
    return {0, fmt::format("\"{}\" is no number with a unit, for example \"{}\"", text,
                           example_of(dimension, 1))};
  if (rest.starts_with(','))
    return {0, fmt::format("\"{}\" has a comma; write the decimals with a point", text)};
  const std::string_view symbol = trim(rest);
  if (symbol.empty() && row.units.empty()) return {number, ""};
  if (symbol.empty() && dimension != Dimension::kShare)
    return {0, fmt::format("needs a unit, for example \"{}\"", example_of(dimension, number))};
  if (symbol.empty()) return {number, ""};
  for (const UnitRow& unit : row.units)
    if (symbol == unit.symbol) return {number * unit.numerator / unit.denominator, ""};
  return {0, wrong_unit(symbol, row)};
}

}  // namespace quern
