// Random contacts for the kernel tests: partners, history and coefficients, in every state a
// contact can be in, away from the branch points of the law (there kernel and twin may rightly
// differ).
//
// Slot k of a batch is the pair of particles 2k and 2k + 1, so that the rows of a tile show each
// contact by itself. Everything is as large and as fast as in a mill: metres from the origin,
// moving at 5 m/s, with overlaps from 1e-6 to 1e-1 of the radius.
#pragma once

#include <hwy/targets.h>

#include <cfenv>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "kernels/tile_pairs.h"
#include "soa/column.h"
#include "tests/support/test_walls.h"
#include "tests/support/twin_kernels.h"

namespace quern::test {

// Runs `body` once for every SIMD target of this CPU, with that target chosen.
//
// Floating-point traps are off for f32 on targets with two f64 lanes: two f32 lanes fill half of a
// register there, and the idle half may divide zero by zero (it is never read).
template <class Real>
void for_each_target(const std::function<void(const std::string&)>& body) {
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(target);
    const bool half_empty = sizeof(Real) == 4 && target >= HWY_SSE4;
    const int traps = fegetexcept();
    if (half_empty) fedisableexcept(FE_ALL_EXCEPT);
    body(hwy::TargetName(target));
    feclearexcept(FE_ALL_EXCEPT);
    feenableexcept(traps);
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

// Of a sphere at x (m), with its velocity (m/s) and spin (rad/s).
template <class Real>
Record<Real> record_of(const Vec3& x, const Vec3& v, const Vec3& w, double radius) {
  return {x.x(), x.y(), x.z(), static_cast<Real>(radius), static_cast<Real>(w.x()),
          v.x(), v.y(), v.z(), static_cast<Real>(w.y()),  static_cast<Real>(w.z())};
}

struct CaseOptions {
  Index materials = 1;
  bool clamped = true, tangential_damping = true, rolling = false, periodic = false;
  ForceLaw law = ForceLaw::kLinearSpringDashpot;
  double overlap_cap = 0;  // m; 0: none
};

inline std::vector<CaseOptions> all_options() {
  std::vector<CaseOptions> all;
  for (const ForceLaw law : {ForceLaw::kLinearSpringDashpot, ForceLaw::kHertzMindlin}) {
    for (int bits = 0; bits < 32; ++bits) {
      all.push_back({bits & 1 ? 3u : 1u, (bits & 2) != 0, (bits & 4) != 0, (bits & 8) != 0,
                     (bits & 16) != 0, law});
    }
    // Two fifths of the overlaps are beyond the cap.
    for (int bits = 0; bits < 8; ++bits) {
      all.push_back(
          {3, (bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0, false, law, 1e-2 * 7.5e-3});
    }
  }
  return all;
}

inline std::string name_of(const CaseOptions& o) {
  return std::string(o.law == ForceLaw::kHertzMindlin ? "Hertz-Mindlin, " : "") +
         std::string(o.materials > 1 ? "3 materials" : "1 material") +
         (o.clamped ? ", clamped" : ", unclamped") + (o.tangential_damping ? ", damped" : "") +
         (o.rolling ? ", rolling" : "") + (o.periodic ? ", periodic" : "") +
         (o.overlap_cap > 0 ? ", capped" : "");
}

// Symmetric tables of the law, magnitudes of ore and steel.
template <class Real>
struct RandomLaw {
  std::vector<Real> column[6];
  ForceLaw kind;
  RandomLaw(const CaseOptions& o, unsigned seed) : kind(o.law) {
    const bool hertz = kind == ForceLaw::kHertzMindlin;
    Random random(seed);
    for (auto& c : column) c.resize(o.materials * o.materials);
    for (Index a = 0; a < o.materials; ++a) {
      for (Index b = 0; b <= a; ++b) {
        // N/m; of Hertz-Mindlin 4/3 E* and 8 G*, Pa.
        const double kn = hertz ? random(1e8, 1e10) : random(1e5, 2e7);
        const double zeta = random(0.05, 0.6), kt = hertz ? 1.2 * kn : random(0.3, 0.8) * kn;
        const double at = 2 * zeta * std::sqrt(kt * (hertz ? 5.0 / 6 : 2.0 / 7));
        const double values[6] = {kn,
                                  kt,
                                  2 * zeta * std::sqrt(hertz ? 1.25 * kn : kn),
                                  o.tangential_damping ? at : 0,
                                  random(0.1, 0.7),
                                  o.rolling ? random(0.001, 0.1) : 0};
        for (std::size_t k = 0; k < 6; ++k) {
          column[k][a * o.materials + b] = column[k][b * o.materials + a] =
              static_cast<Real>(values[k]);
        }
      }
    }
  }
  LawTable<Real> table(Index materials) const {
    return {column[0].data(), column[1].data(), column[2].data(), column[3].data(),
            column[4].data(), column[5].data(), materials,        kind};
  }
};

inline constexpr double kCaseStep = 1e-5;  // s

template <class Real>
StepConstants<Real> constants(const CaseOptions& o, const RandomLaw<Real>& law) {
  StepConstants<Real> c{};
  c.law = law.table(o.materials);
  c.dt = kCaseStep;
  c.clamped = o.clamped;
  c.rolling = o.rolling;
  c.damped = o.tangential_damping;
  c.overlap_cap = o.overlap_cap;
  c.nearest2 = HUGE_VAL;
  if (o.periodic) {
    c.period[2] = 0.5;
    c.inverse_period[2] = 1 / c.period[2];
    c.nearest2 = 0.25 * c.period[2] * c.period[2];
  }
  return c;
}

// A spring across n, and the force of a step ago that may go with it.
inline twin::History random_history(const twin::Coefficients& law, const Vec3& normal_old,
                                    double overlap, bool rolling, Random& random) {
  twin::History h;
  const Vec3 any = random.in_cube(1);
  const Vec3 across = any - any.dot(normal_old) * normal_old;
  // Springs around the length at which sliding begins: both kinds occur.
  h.spring = across * (random(0, 2) * law.mu * law.kn / law.kt * overlap);
  h.force = law.kn * overlap * random(0.3, 1.2) * normal_old - law.kt * random(0.3, 1) * h.spring;
  if (rolling) h.moment = random.in_cube(law.mur * 0.01 * law.kn * overlap);
  return h;
}

enum class TouchState { kFresh, kPersisting, kLost, kApart };

// As the kernels have it.
template <class Real>
twin::History rounded(const twin::History& h) {
  const auto round = [](const Vec3& v) {
    return Vec3(v.template cast<Real>().template cast<double>());
  };
  return {round(h.spring), round(h.force), round(h.rest), round(h.moment)};
}

// Gives a batch the histories of its slots: open are those that have one.
template <class Real>
void set_histories(PairBatch<Real>& batch, const std::vector<twin::History>& of_slot) {
  const auto is_open = [](const twin::History& h) {
    return h.spring != Vec3::Zero() || h.force != Vec3::Zero() || h.moment != Vec3::Zero();
  };
  for (std::size_t slot = 0; slot < batch.slots(); ++slot) {
    std::uint16_t& bits = batch.open[slot / kPairPad];
    if (slot % kPairPad == 0) bits = 0;
    if (is_open(of_slot[slot])) bits |= static_cast<std::uint16_t>(1u << slot % kPairPad);
  }
  const std::vector<Index> contacts = batch.count_contacts();
  batch.contacts.resize(batch.tiles());
  for (std::size_t tile = 0; tile < batch.tiles(); ++tile) {
    batch.contacts[tile].reset(contacts[tile], batch.history());
    const std::size_t first = batch.row_begin[batch.begin[tile]] * kPairPad;
    const std::size_t last = batch.row_begin[batch.begin[tile + 1]] * kPairPad;
    for (std::size_t slot = first; slot < last; ++slot) {
      if (!batch.is_open(slot)) continue;
      const twin::History& h = of_slot[slot];
      const Vec3* const vectors[4] = {&h.spring, &h.force, &h.rest, &h.moment};
      for (std::size_t k = 0; k < batch.history(); ++k) {
        batch.number(tile, slot, k) =
            static_cast<Real>((*vectors[k / 3])[static_cast<Eigen::Index>(k % 3)]);
      }
    }
  }
}

// Particles in pairs with their slots and histories, ready for the pair kernel: one tile of blocks
// of one row.
template <class Real>
struct PairCases {
  Column<Record<Real>> record;
  Column<Traits<Real>> traits;
  std::vector<Index> i, j;  // of each slot
  PairBatch<Real> batch;
  std::vector<twin::History> histories;  // of each slot, before a step
  std::size_t contacts, slots;

  PairCases(std::size_t count, const CaseOptions& o, const RandomLaw<Real>& law, unsigned seed)
      : contacts(count), slots((count + kPairPad - 1) / kPairPad * kPairPad) {
    record.reset(2 * count);
    traits.reset(2 * count);
    i.assign(slots, 0);
    j.assign(slots, 0);
    batch.rolling = o.rolling;
    batch.reset(slots / kPairPad, slots / kPairPad);
    batch.begin.reset(2);
    batch.own_end.reset(1);
    histories.resize(slots);
    Random random(seed);
    for (std::size_t k = 0; k < count; ++k) {
      i[k] = static_cast<Index>(2 * k);
      j[k] = static_cast<Index>(2 * k + 1);
      do {
        make_contact(k, o, law, random);
      } while (!is_clear(k, o, law));
    }
  }

  ParticleView<Real> particles() const { return {record.data(), traits.data()}; }
  // A step of the tile, to which the first `own` slots (whole blocks) belong; the others are
  // imported.
  void push(std::size_t own, const StepConstants<Real>& step, const TileRows& rows,
            ContactTally& tally) {
    for (std::size_t k = 0; k < slots; ++k) {
      batch.owner[k] = k < own ? i[k] : j[k];
      batch.partner[k] = k < own ? j[k] : i[k];
    }
    const std::size_t blocks = slots / kPairPad;
    for (std::size_t b = 0; b <= blocks; ++b) batch.row_begin[b] = static_cast<Index>(b);
    batch.begin[0] = 0;
    batch.own_end[0] = static_cast<Index>(own / kPairPad);
    batch.begin[1] = static_cast<Index>(blocks);
    set_histories(batch, histories);
    PairScratch<Real> scratch;
    push_tile_pairs(choose_kernels<Real>(step.law.kind), step, particles(), batch, 0, rows, scratch,
                    tally);
  }
  void set_history(std::size_t k, const twin::History& h) { histories[k] = rounded<Real>(h); }
  const twin::History& history(std::size_t k) const { return histories[k]; }
  // After the step.
  twin::History history_now(std::size_t k) const {
    const PairBatch<Real>& now = batch;
    const auto at = [&](std::size_t first) {
      return Vec3(static_cast<double>(now.number(0, k, first)),
                  static_cast<double>(now.number(0, k, first + 1)),
                  static_cast<double>(now.number(0, k, first + 2)));
    };
    return {at(0), at(3), at(6), batch.rolling ? at(9) : Vec3::Zero()};
  }

 private:
  void make_contact(std::size_t k, const CaseOptions& o, const RandomLaw<Real>& law,
                    Random& random) {
    const TouchState state = static_cast<TouchState>(random.below(4));
    Index material[2];
    for (std::size_t side = 0; side < 2; ++side) {
      const std::size_t at = 2 * k + side;
      Record<Real>& r = record[at];
      r.radius = static_cast<Real>(side == 0 ? random(0.005, 0.01) : random(0.01, 0.05));
      const double size = static_cast<double>(r.radius);
      traits[at].inverse_mass =
          static_cast<Real>(1 / (random(1000, 8000) * 4.19 * size * size * size));
      material[side] = static_cast<Index>(random.below(o.materials));
      traits[at].tag = make_tag(material[side], static_cast<std::uint32_t>(random.below(12)));
      const Vec3 spin = random.in_cube(50);
      r.wx = static_cast<Real>(spin.x());
      r.wy = static_cast<Real>(spin.y());
      r.wz = static_cast<Real>(spin.z());
    }
    Record<Real>&a = record[2 * k], &b = record[2 * k + 1];
    const double reach = static_cast<double>(a.radius) + static_cast<double>(b.radius);
    const double overlap = static_cast<double>(a.radius) * std::pow(10, random(-6, -1));
    const bool touches = state == TouchState::kFresh || state == TouchState::kPersisting;
    const Vec3 normal = random.in_cube(1).normalized();
    const Vec3 dx = normal * (touches ? reach - overlap : reach + random(0.01, 1) * overlap);
    double approach = random(-1, 1) * 1e4 * overlap;
    if (state == TouchState::kFresh) approach = overlap / kCaseStep * random(1.01, 4);
    const Vec3 dv = random.in_cube(0.5) - approach * normal;
    const Vec3 x = random.in_cube(4), v = random.in_cube(5);
    b = {x.x(), x.y(), x.z(), b.radius, b.wx, v.x(), v.y(), v.z(), b.wy, b.wz};
    a = {x.x() + dx.x(), x.y() + dx.y(), x.z() + dx.z(), a.radius, a.wx,
         v.x() + dv.x(), v.y() + dv.y(), v.z() + dv.z(), a.wy,     a.wz};
    if (o.periodic && random.below(2) == 0) a.z += 0.5 * (random.below(2) == 0 ? 1 : -2);
    make_history(k, o, law, state, material, overlap, (dx - kCaseStep * dv).normalized(), random);
  }

  void make_history(std::size_t k, const CaseOptions& o, const RandomLaw<Real>& law,
                    TouchState state, const Index (&material)[2], double overlap,
                    const Vec3& normal_old, Random& random) {
    twin::History h;
    if (state == TouchState::kPersisting || state == TouchState::kLost) {
      const auto at = twin::coefficients(law.table(o.materials), material[0], material[1]);
      const double a = static_cast<double>(record[2 * k].radius);
      const double b = static_cast<double>(record[2 * k + 1].radius);
      h = random_history(twin::at_overlap(at, overlap, a * b / (a + b)), normal_old, overlap,
                         o.rolling, random);
      h.rest = random.in_cube(3e-8 * h.spring.norm());
    }
    set_history(k, h);
  }

  // Not within a thousandth of a branch point that jumps.
  bool is_clear(std::size_t k, const CaseOptions& o, const RandomLaw<Real>& law) const {
    const StepConstants<Real> step = constants(o, law);
    const twin::Contact c = twin::sphere_sphere(step, particles(), i[k], j[k]);
    const auto coefficients = twin::coefficients(step.law, tag_material(traits[i[k]].tag),
                                                 tag_material(traits[j[k]].tag));
    const twin::Response r = twin::respond(coefficients, c, history(k),
                                           {step.dt, o.clamped, o.rolling, 0, 0, o.overlap_cap});
    const double depth = c.overlap / c.i.radius;
    return std::abs(depth) > 1e-8 && std::abs(depth - 0.5) > 1e-3 &&
           std::abs(c.overlap - o.overlap_cap) > 1e-3 * o.overlap_cap &&
           (!c.touching || (r.fresh_margin > 1e-3 && r.slide_margin > 1e-3));
  }
};

}  // namespace quern::test
