// Every way to ask for sizes becomes a list of strata: an interval of diameters, a law for the
// number density inside it, and a count or a share of the mass. What remains is one loop that draws
// them.
//
//   class of the scene          uniform in diameter             E[d^3] = (b^4 - a^4) / (4 (b - a))
//   piece of a passing curve    passing linear in log d, so mass density ~ 1/d and number density
//                               ~ d^-4: d^-3 is uniform         E[d^3] = 3 ln(b/a) / (a^-3 - b^-3)
//
// A Rosin-Rammler curve is cut into many short pieces of the second kind. Pieces can be lighter
// than one particle, so the rounding of one is carried to the next; coarse to fine, what is left at
// the end is less than the finest particle. Classes of the scene are rounded each for itself.
#include "scheduler/sizes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "scheduler/random.h"
#include "soa/facets.h"
#include "soa/record.h"

namespace quern {
namespace {

enum class NumberLaw { kUniform, kInverseFourth };
enum class Rounding { kEach, kCarried };

struct Stratum {
  double from = 0, to = 0;  // m
  NumberLaw law = NumberLaw::kUniform;
  double share = 0;  // of the species' mass
  ShapeKind shape = ShapeKind::kSphere;
};

constexpr double kMostParticles = 1e9;
constexpr int kRosinRammlerPieces = 64;

double cube(double d) { return d * d * d; }

// Uniform over all rotations: K. Shoemake, Uniform random rotations, Graphics Gems III (1992).
Quat random_orientation(std::uint64_t seed, std::uint64_t particle) {
  CounterRandom random(seed, RandomStream::kOrientation, particle);
  const double u = random.uniform(), a = random.uniform(0, 2 * kPi), b = random.uniform(0, 2 * kPi);
  const double s = std::sqrt(1 - u), c = std::sqrt(u);
  return Quat(c * std::cos(b), s * std::sin(a), s * std::cos(a), c * std::sin(b));
}

double mean_cube(const Stratum& s) {
  if (s.to - s.from < 1e-9 * s.to) return cube(0.5 * (s.from + s.to));
  if (s.law == NumberLaw::kUniform) {
    return (cube(s.to) * s.to - cube(s.from) * s.from) / (4 * (s.to - s.from));
  }
  return 3 * std::log(s.to / s.from) / (1 / cube(s.from) - 1 / cube(s.to));
}

double diameter_at(const Stratum& s, double u) {
  if (s.law == NumberLaw::kUniform) return s.from + (s.to - s.from) * u;
  const double fine = 1 / cube(s.from), coarse = 1 / cube(s.to);
  return std::clamp(1 / std::cbrt(coarse + (fine - coarse) * u), s.from, s.to);
}

// One species being drawn into the list.
class SpeciesDraw {
 public:
  // `out` may be null for count().
  SpeciesDraw(const Scene& scene, std::size_t species, std::vector<ParticleSeed>* out)
      : scene_(scene),
        spec_(scene.particles[species]),
        label_(species_label(scene, species)),
        out_(out) {
    const auto same_name = [&](const Material& m) { return m.name == spec_.material; };
    const auto row = std::find_if(scene.materials.begin(), scene.materials.end(), same_name);
    if (row == scene.materials.end()) fail("unknown material '" + spec_.material + "'");
    density_ = row->density;
    if (!(density_ > 0)) fail("material '" + spec_.material + "' needs a density above 0");
    seed_.material = static_cast<std::uint16_t>(row - scene.materials.begin());
    seed_.species = static_cast<std::uint16_t>(species);
    seed_.velocity = scene.fill.velocity;
    if (has_polyhedra(spec_) && spec_.meshes.empty()) fail("polyhedra need a mesh");
  }

  void count(ParticleCount& sum) const {
    const auto add = [&](ShapeKind shape, double count) {
      (shape == ShapeKind::kSphere ? sum.spheres : sum.polyhedra) += count;
    };
    if (!spec_.explicit_particles.empty()) {
      return add(spec_.shape, static_cast<double>(spec_.explicit_particles.size()));
    }
    if (!spec_.sizes.empty() && spec_.sizes.front().count) {
      for (const SizeClass& c : spec_.sizes) {
        add(shape_of(spec_, c), static_cast<double>(c.count.value_or(0)));
      }
      return;
    }
    const std::vector<Stratum> strata = make_strata();
    const std::vector<double> counts =
        spec_.count ? counts_in_all(strata, static_cast<double>(*spec_.count))
                    : counts_of_mass(strata, wanted_mass());
    for (std::size_t k = 0; k < strata.size(); ++k) add(strata[k].shape, counts[k]);
  }

  void draw() {
    if (!spec_.explicit_particles.empty()) return draw_explicit();
    if (!spec_.sizes.empty() && spec_.sizes.front().count) return draw_counted_classes();
    const std::vector<Stratum> strata = make_strata();
    const bool curve = spec_.distribution.kind != DistributionKind::kNone && spec_.sizes.empty() &&
                       !spec_.diameter;
    if (spec_.count) {
      draw_total_count(strata);
    } else {
      draw_mass(strata, wanted_mass(), curve ? Rounding::kCarried : Rounding::kEach);
    }
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw UserError("particles " + label_ + ": " + what);
  }

  void draw_explicit() {
    for (const ExplicitParticle& p : spec_.explicit_particles) {
      if (!(p.diameter > 0)) fail("an explicit particle needs a diameter above 0");
      seed_.position = p.position;
      seed_.velocity = p.velocity;
      seed_.spin = p.spin;
      seed_.radius = 0.5 * p.diameter;
      set_mesh(spec_.shape, seed_);
      if (p.orientation) {
        seed_.orientation = Eigen::AngleAxisd(p.orientation->angle, p.orientation->axis);
      }
      out_->push_back(seed_);
    }
  }

  void draw_counted_classes() {
    for (const SizeClass& c : spec_.sizes) {
      if (!c.count) fail("every size class needs a count, or every one a mass_share");
      const Stratum s{c.from, c.to, NumberLaw::kUniform, 0, shape_of(spec_, c)};
      check_interval(s);
      draw_count(s, *c.count);
    }
  }

  void draw_count(const Stratum& s, long count) {
    if (count < 0) fail("a count below 0");
    check_amount(static_cast<double>(count));
    for (long k = 0; k < count; ++k) out_->push_back(next(s));
  }

  // The particle that would be next in the list.
  ParticleSeed next(const Stratum& s) const {
    ParticleSeed seed = seed_;
    seed.radius =
        0.5 *
        diameter_at(s, CounterRandom(scene_.run.seed, RandomStream::kSize, out_->size()).uniform());
    set_mesh(s.shape, seed);
    return seed;
  }

  void set_mesh(ShapeKind shape, ParticleSeed& seed) const {
    if (shape == ShapeKind::kSphere) return;
    seed.mesh = static_cast<std::uint16_t>(out_->size() % spec_.meshes.size());
    seed.orientation = random_orientation(scene_.run.seed, out_->size());
  }

  // In proportion to share / mean mass.
  static std::vector<double> counts_in_all(const std::vector<Stratum>& strata, double all) {
    std::vector<double> counts;
    for (const Stratum& s : strata) counts.push_back(s.share / mean_cube(s));
    const double sum = std::accumulate(counts.begin(), counts.end(), 0.0);
    for (double& count : counts) count *= all / sum;
    return counts;
  }

  std::vector<double> counts_of_mass(const std::vector<Stratum>& strata, double mass) const {
    std::vector<double> counts;
    for (const Stratum& s : strata) counts.push_back(s.share * mass / (unit() * mean_cube(s)));
    return counts;
  }

  double unit() const { return density_ * kPi / 6; }  // mass over diameter cubed

  // The largest remainders get what rounding left.
  void draw_total_count(const std::vector<Stratum>& strata) {
    std::vector<double> exact = counts_in_all(strata, static_cast<double>(*spec_.count));
    std::vector<long> count;
    long left = *spec_.count;
    for (double& e : exact) {
      count.push_back(static_cast<long>(e));
      left -= count.back();
      e -= static_cast<double>(count.back());
    }
    std::vector<std::size_t> order(strata.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return exact[a] > exact[b]; });
    for (std::size_t k = 0; left > 0; --left, k = (k + 1) % order.size()) ++count[order[k]];
    for (std::size_t k = 0; k < strata.size(); ++k) draw_count(strata[k], count[k]);
  }

  void draw_mass(const std::vector<Stratum>& strata, double mass, Rounding rounding) {
    const std::vector<double> expected = counts_of_mass(strata, mass);
    check_amount(std::accumulate(expected.begin(), expected.end(), 0.0));
    double owed = 0;
    for (const Stratum& s : strata) {
      owed = s.share * mass + (rounding == Rounding::kCarried ? owed : 0);
      for (ParticleSeed p = next(s); owed > 0.5 * unit() * cube(2 * p.radius); p = next(s)) {
        owed -= unit() * cube(2 * p.radius);
        out_->push_back(p);
      }
    }
  }

  double wanted_mass() const {
    if (spec_.mass) return *spec_.mass;
    if (!spec_.filling_level) fail("no amount given: count, mass or filling_level");
    if (!scene_.mill) fail("filling_level needs a [mill]; give count or mass instead");
    const double volume = mill_inner_area(*scene_.mill) * scene_.mill->length;
    return density_ * kBulkSolidFraction * *spec_.filling_level * volume;
  }

  std::vector<Stratum> make_strata() const {
    std::vector<Stratum> strata;
    if (spec_.diameter) {
      strata.push_back({*spec_.diameter, *spec_.diameter, NumberLaw::kUniform, 1, spec_.shape});
    } else if (!spec_.sizes.empty()) {
      for (const SizeClass& c : spec_.sizes) {
        if (!c.mass_share) fail("every size class needs a mass_share, or every one a count");
        strata.push_back({c.from, c.to, NumberLaw::kUniform, *c.mass_share, shape_of(spec_, c)});
      }
    } else if (spec_.distribution.kind == DistributionKind::kPassingTable) {
      strata = curve_strata(spec_.distribution.passing);
    } else if (spec_.distribution.kind == DistributionKind::kRosinRammler) {
      strata = curve_strata(rosin_rammler_table());
    } else {
      fail("no sizes given: diameter, sizes, distribution or explicit particles");
    }
    for (const Stratum& s : strata) check_interval(s);
    normalize(strata);
    return strata;
  }

  void normalize(std::vector<Stratum>& strata) const {
    double sum = 0;
    for (const Stratum& s : strata) {
      if (!(s.share >= 0)) fail("a mass share below 0");
      sum += s.share;
    }
    if (!spec_.sizes.empty() && std::abs(sum - 1) > 0.01) {
      fail("the mass shares of the size classes add up to " + std::to_string(sum) + ", not to 1");
    }
    if (!(sum > 0)) fail("the distribution holds no mass between its limits");
    for (Stratum& s : strata) s.share /= sum;
  }

  std::vector<std::pair<double, double>> rosin_rammler_table() const {
    const SizeDistribution& d = spec_.distribution;
    if (!(d.from > 0 && d.to > d.from && d.d63 > 0 && d.exponent > 0)) {
      fail("Rosin-Rammler needs d63 and exponent above 0 and 0 < from < to");
    }
    std::vector<std::pair<double, double>> table;
    for (int k = 0; k <= kRosinRammlerPieces; ++k) {
      const double diameter = d.from * std::pow(d.to / d.from, k / double{kRosinRammlerPieces});
      table.emplace_back(diameter, -std::expm1(-std::pow(diameter / d.d63, d.exponent)));
    }
    table.back().first = d.to;
    return table;
  }

  // Coarse to fine.
  std::vector<Stratum> curve_strata(const std::vector<std::pair<double, double>>& table) const {
    if (table.size() < 2) fail("a table of passing needs two points or more");
    std::vector<Stratum> strata;
    for (std::size_t k = table.size() - 1; k > 0; --k) {
      const auto& [from, below] = table[k - 1];
      const auto& [to, above] = table[k];
      if (!(to > from && above >= below)) {
        fail("a table of passing needs growing diameters and passing that does not fall");
      }
      strata.push_back({from, to, NumberLaw::kInverseFourth, above - below, spec_.shape});
    }
    return strata;
  }

  void check_interval(const Stratum& s) const {
    if (!(s.from > 0 && s.to >= s.from)) fail("diameters need 0 < from <= to");
  }

  void check_amount(double count) const {
    if (static_cast<double>(out_->size()) + count > kMostParticles) {
      fail("asks for more than 1e9 particles; coarsen the fine end or ask for less");
    }
  }

  const Scene& scene_;
  const ParticleSpec& spec_;
  std::string label_;
  std::vector<ParticleSeed>* out_;
  ParticleSeed seed_;
  double density_ = 0;
};

}  // namespace

std::vector<ParticleSeed> draw_sizes(const Scene& scene) {
  QUERN_CHECK(scene.particles.size() <= std::numeric_limits<std::uint16_t>::max());
  QUERN_CHECK(scene.materials.size() <= kMostMaterials);
  std::vector<ParticleSeed> particles;
  for (std::size_t s = 0; s < scene.particles.size(); ++s) {
    SpeciesDraw(scene, s, &particles).draw();
  }
  return particles;
}

ParticleCount count_particles(const Scene& scene) {
  ParticleCount sum;
  for (std::size_t s = 0; s < scene.particles.size(); ++s) {
    SpeciesDraw(scene, s, nullptr).count(sum);
  }
  return sum;
}

void assign_shapes(std::span<const Shape> shapes,
                   std::span<const std::vector<Index>> species_shapes,
                   std::vector<ParticleSeed>& particles) {
  for (ParticleSeed& p : particles) {
    if (p.is_sphere() || p.shape != nullptr) continue;
    const Index row = species_shapes[p.species][p.mesh];
    QUERN_CHECK(row < shapes.size());
    p.shape = &shapes[row];
    p.orientation = (p.orientation * Quat(p.shape->file_axes)).normalized();
  }
}

std::string species_label(const Scene& scene, std::size_t species) {
  const std::string& name = scene.particles[species].name;
  return name.empty() ? "#" + std::to_string(species + 1) : "'" + name + "'";
}

bool is_explicit(const Scene& scene, const ParticleSeed& particle) {
  return !scene.particles[particle.species].explicit_particles.empty();
}

double sphere_volume(double radius) { return 4 * kPi / 3 * cube(radius); }

}  // namespace quern
