// Sphere against sphere: the law over all who touch.
//
// The second of two passes over a tile. The first (touching_spheres-inl.h) finds who touches: a
// quarter of the listed pairs of a mill, packed into full vectors here.
//
// Overlap is (R^2 - d^2) / (R + d) with R^2 - d^2 in f64, so that a static overlap of 1e-9 m at 5 m
// from the origin is right to 1e-7 of itself although the rest of the force is f32 in `mixed`. The
// old normal and overlap are recomputed from the positions before the last step, x - dt v, instead
// of being stored. i is the partner with the smaller radius (ties: lower identity) for life.
#if defined(QUERN_SPHERE_SPHERE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef QUERN_SPHERE_SPHERE_INL_H_
#undef QUERN_SPHERE_SPHERE_INL_H_
#else
#define QUERN_SPHERE_SPHERE_INL_H_
#endif

#include <algorithm>
#include <type_traits>
#include <utility>

#include "kernels/episodes-inl.h"
#include "kernels/pairs/touching_spheres-inl.h"

HWY_BEFORE_NAMESPACE();
namespace quern {
namespace HWY_NAMESPACE {

// A full vector of pairs, i from j, rounded after the differences.
template <class V>
struct SeparationV {
  Vec3V<V> place, velocity;
  V d2, gap2;  // d^2, R^2 - d^2
};

// Unit vectors and overlaps (R^2 - d^2) / (R + d), now and a step ago, by two divisions. A step ago
// the squares were smaller by dt v.(2 x - dt v): a small difference, right to a rounding of itself.
template <class V>
HWY_INLINE void set_geometry(const SeparationV<V>& s, V reach, V dt, TouchV<V>& t) {
  const hn::DFromV<V> d;
  const V one = hn::Set(d, 1), tiny = hn::Set(d, hn::TFromV<V>(1e-25));
  const Vec3V<V> place_old = add_scaled(s.place, hn::Neg(dt), s.velocity);
  const V came = hn::Mul(dt, dot(s.velocity, s.place + place_old));
  const V gap2_old = hn::Add(s.gap2, came);
  const V now = hn::Sqrt(hn::Max(s.d2, tiny)), old = hn::Sqrt(hn::Max(hn::Sub(s.d2, came), tiny));
  const V inverse = hn::Div(one, hn::Mul(now, old));
  t.normal = scale(hn::Mul(inverse, old), s.place);
  t.normal_old = scale(hn::Mul(inverse, now), place_old);
  const V sum_now = hn::Add(reach, now), sum_old = hn::Add(reach, old);
  const V inverse_sums = hn::Div(one, hn::Mul(sum_now, sum_old));
  t.overlap = hn::Mul(s.gap2, hn::Mul(inverse_sums, sum_old));
  t.overlap_old = hn::Mul(gap2_old, hn::Mul(inverse_sums, sum_now));
}

// Both partners of a full vector of pairs as the law sees them.
template <class Real, class Law, class V = hn::Vec<Lanes<Real>>>
HWY_INLINE TouchV<V> touch_of(const StepConstants<Real>& step, const BodyV<Real>& a, V radius_i,
                              const BodyV<Real>& b, V radius_j, const SeparationV<V>& s, V& arm_i,
                              V& arm_j) {
  const Lanes<Real> d;
  TouchV<V> t;
  const V reach = hn::Add(radius_i, radius_j);
  set_geometry(s, reach, hn::Set(d, static_cast<Real>(step.dt)), t);
  t.normal_velocity = dot(t.normal, s.velocity);
  t.spin_i = a.spin;
  t.spin_j = b.spin;
  const V half = hn::Set(d, Real(0.5));
  arm_i = hn::NegMulAdd(half, t.overlap, radius_i);
  arm_j = hn::NegMulAdd(half, t.overlap, radius_j);
  const Vec3V<V> rim = add_scaled(scale(arm_i, a.spin), arm_j, b.spin);
  // Both arms were longer by half of what the overlap has grown.
  const V grown = hn::Mul(half, hn::Sub(t.overlap, t.overlap_old));
  const Vec3V<V> rim_old = add_scaled(rim, grown, a.spin + b.spin);
  t.at_point = s.velocity - cross(rim, t.normal);
  t.at_old = s.velocity - cross(rim_old, t.normal_old);
  t.inverse_mass = hn::Add(a.inverse_mass, b.inverse_mass);
  t.count_rate = hn::MulAdd(a.contacts, a.inverse_mass, hn::Mul(b.contacts, b.inverse_mass));
  t.contacts = hn::Add(a.contacts, b.contacts);
  t.reduced_radius = t.inverse_inertia = hn::Zero(d);
  if constexpr (Law::kRolling || Law::kChanging) {
    t.reduced_radius = hn::Div(hn::Mul(radius_i, radius_j), reach);
  }
  if constexpr (Law::kRolling) {
    t.inverse_inertia = hn::Mul(hn::Set(d, Real(2.5)),
                                hn::Add(hn::Div(a.inverse_mass, hn::Mul(radius_i, radius_i)),
                                        hn::Div(b.inverse_mass, hn::Mul(radius_j, radius_j))));
  }
  return t;
}

// Row of each particle in the tile's accumulator; other tiles' particles take the last row.
HWY_INLINE void find_rows(const TileRows& tile, const Index* particle, Index (&rows)[16]) {
  const auto first = hn::Set(D32U(), tile.first), size = hn::Set(D32U(), tile.size);
  hn::StoreU(hn::Min(hn::Sub(hn::LoadU(D32U(), particle), first), size), D32U(), rows);
}
// Adds the forces on the particles of one half of the lanes, lane after lane: lanes may share a
// particle.
template <class Real, std::size_t half, class V>
HWY_INLINE void add_to_particles(const Vec3V<V>& force, const Vec3V<V>& torque, V one,
                                 const Index* particle, const TileRows& tile) {
  const auto f64 = [](V v) HWY_ATTR { return half_f64<Real, half>(v); };
  const hn::Vec<D64> c[8] = {f64(force.x),  f64(force.y),  f64(force.z), f64(torque.x),
                             f64(torque.y), f64(torque.z), f64(one),     hn::Zero(D64())};
  HWY_ALIGN Index rows[16];
  find_rows(tile, particle + half * hn::MaxLanes(D64()), rows);
  add_to_rows(c, rows, tile.rows);
}

// The histories of a full vector of contacts. Those that were open stand side by side among the old
// ones; a fresh one has zeros.
template <class Real, std::size_t kNumbers, class V, class M>
HWY_INLINE void load_history(const HistoryView<Real>& from, std::size_t at, M open,
                             V (&c)[kNumbers]) {
  const Lanes<Real> d;
  for (std::size_t k = 0; k < kNumbers; ++k)
    c[k] = hn::LoadU(d, from.numbers + k * from.stride + at);
  if (HWY_LIKELY(hn::AllTrue(d, open))) return;
#if QUERN_AVX512
  for (V& v : c) {
    if constexpr (sizeof(Real) == sizeof(float)) {
      v = V{_mm512_maskz_expand_ps(open.raw, v.raw)};
    } else {
      v = V{_mm512_maskz_expand_pd(open.raw, v.raw)};
    }
  }
#else
  const hn::RebindToSigned<Lanes<Real>> di;
  HWY_ALIGN hn::TFromD<decltype(di)> rank[hn::MaxLanes(di)];
  hn::Store(hn::IfThenElseZero(hn::RebindMask(di, open), hn::Set(di, 1)), di, rank);
  hn::TFromD<decltype(di)> before = 0;
  for (auto& lane : rank) before += std::exchange(lane, before);
  const auto from_lane = hn::SetTableIndices(d, rank);
  for (V& v : c) v = hn::IfThenElseZero(open, hn::TableLookupLanes(v, from_lane));
#endif
}
// Of those that touch, side by side.
template <class Real, std::size_t kNumbers, class V, class M>
HWY_INLINE void store_history(V (&c)[kNumbers], M touching, const HistoryView<Real>& to,
                              std::size_t at) {
  const Lanes<Real> d;
  if (HWY_UNLIKELY(!hn::AllTrue(d, touching))) {
    for (V& v : c) v = hn::Compress(v, touching);
  }
  for (std::size_t k = 0; k < kNumbers; ++k) hn::StoreU(c[k], d, to.numbers + k * to.stride + at);
}

// Lanes of contacts whose state has a bit.
template <class Real>
HWY_INLINE auto has_state(const Index* state, Index bit) {
  using Row = hn::RebindToSigned<Lanes<Real>>;
  const auto wanted = hn::Set(Row(), static_cast<hn::TFromD<Row>>(bit));
  return hn::RebindMask(Lanes<Real>(), hn::TestBit(load_index<Real>(state), wanted));
}

// Where the next contact's history was and goes.
struct HistoryPlace {
  std::size_t old = 0, now = 0;
};

// The numbers behind the first so many of each contact.
template <std::size_t kFirst, class Real>
HWY_INLINE HistoryView<Real> behind(const HistoryView<Real>& history) {
  return {history.numbers + kFirst * history.stride, history.stride};
}

// Both partners of a full vector of pairs, and how they are apart.
template <class Real, class V = hn::Vec<Lanes<Real>>>
struct MeetingV {
  BodyV<Real> a, b;
  V radius_i, radius_j;
  SeparationV<V> apart;
};
template <class Real>
HWY_INLINE MeetingV<Real> load_meeting(const StepConstants<Real>& step, const ParticleView<Real>& p,
                                       const Index* i, const Index* j) {
  constexpr std::size_t kLast = kHalves<Real> - 1, kHigh = kLast * hn::MaxLanes(D64());
  MeetingV<Real> m;
  hn::Vec<D64> low_d2, high_d2;
  const PlaceV<Real> low_i = load_places(p, i), low_j = load_places(p, j);
  const auto low_place = to_real<Real>(apart(step, low_i, low_j, low_d2));
  const PlaceV<Real> high_i = load_places(p, i + kHigh), high_j = load_places(p, j + kHigh);
  const auto high_place = to_real<Real>(apart(step, high_i, high_j, high_d2));
  m.radius_i = join_radius(low_i, high_i);
  m.radius_j = join_radius(low_j, high_j);
  m.apart.place = join<Real>(low_place, high_place);
  m.apart.d2 = join<Real>(to_real<Real>(low_d2), to_real<Real>(high_d2));
  m.apart.gap2 =
      join<Real>(gap2_of<Real, 0>(half_f64<Real, 0>(m.radius_i), m.radius_j, low_d2),
                 gap2_of<Real, kLast>(half_f64<Real, kLast>(m.radius_i), m.radius_j, high_d2));
  const MotionV<Real> low_motion_i = load_motions(p, i), low_motion_j = load_motions(p, j);
  const MotionV<Real> high_motion_i = load_motions(p, i + kHigh);
  const MotionV<Real> high_motion_j = load_motions(p, j + kHigh);
  m.apart.velocity = join<Real>(to_real<Real>(low_motion_i.velocity - low_motion_j.velocity),
                                to_real<Real>(high_motion_i.velocity - high_motion_j.velocity));
  m.a = join_bodies(low_i, high_i, low_motion_i, high_motion_i);
  m.b = join_bodies(low_j, high_j, low_motion_j, high_motion_j);
  return m;
}

// A full vector of contacts. Own ones give both partners their share, are tallied and, if they are
// recorded, told; of imported ones only j is of this tile.
template <class Real, class Law, bool kOwn>
HWY_INLINE void sphere_sphere(const StepConstants<Real>& step, const ParticleView<Real>& p,
                              const Index* i, const Index* j, const Index* state,
                              const HistoryView<Real>& old_history,
                              const HistoryView<Real>& new_history, const TileRows& tile,
                              HistoryPlace& at, TallyV<hn::Vec<Lanes<Real>>>& tally,
                              ToldV<hn::Vec<Lanes<Real>>>* told) {
  const Lanes<Real> d;
  using V = hn::Vec<Lanes<Real>>;
  constexpr std::size_t kLast = kHalves<Real> - 1;
  const V zero = hn::Zero(d);
  const auto [a, b, radius_i, radius_j, s] = load_meeting(step, p, i, j);
  V arm_i, arm_j;
  const TouchV<V> t = touch_of<Real, Law>(step, a, radius_i, b, radius_j, s, arm_i, arm_j);

  using Row = hn::RebindToSigned<Lanes<Real>>;
  // In `single` the first pass finds some that are next to touching.
  const auto found = has_state<Real>(state, kTouches), open = has_state<Real>(state, kDidTouch);
  const auto touching = hn::And(found, hn::Gt(s.gap2, zero));
  V h[Law::kRolling ? kRollingHistory : kHistory];
  load_history(old_history, at.old, open, h);
  at.old += hn::CountTrue(d, open);
  HistoryV<V> old = {
      {h[0], h[1], h[2]}, {h[3], h[4], h[5]}, {h[6], h[7], h[8]}, {zero, zero, zero}};
  if constexpr (Law::kRolling) old.moment = {h[9], h[10], h[11]};
  const auto row =
      hn::Add(hn::Mul(a.material, hn::Set(Row(), static_cast<hn::TFromD<Row>>(step.law.materials))),
              b.material);
  const ResponseV<V> r =
      respond<Real, Law>(step, load_coefficients<Real>(step.law, row), t, old, touching);
  const auto keep = [&](std::size_t first, const Vec3V<V>& v) HWY_ATTR {
    h[first] = v.x;
    h[first + 1] = v.y;
    h[first + 2] = v.z;
  };
  keep(0, r.spring);
  keep(3, r.force);
  keep(6, r.rest);
  if constexpr (Law::kRolling) keep(9, r.moment);
  store_history(h, found, new_history, at.now);
  if constexpr (Law::kRecorded) tell(r, pair_kinds<Real>(step.groups, a.group, b.group), *told);
  at.now += hn::CountTrue(d, found);
  if constexpr (kOwn) {
    count_response<Real, Law>(r, touching, hn::Div(t.overlap, radius_i), radius_i, step.overlap_cap,
                              tally);
  }

  const Vec3V<V> twist = cross(r.tangential, t.normal);  // = -n x F_t
  Vec3V<V> torque_j = scale(arm_j, twist);
  if constexpr (Law::kRolling) torque_j = torque_j - r.moment;
  const Vec3V<V> on_j = {hn::Neg(r.force.x), hn::Neg(r.force.y), hn::Neg(r.force.z)};
  const V one = hn::IfThenElseZero(touching, hn::Set(d, 1));
  if constexpr (kOwn) {
    Vec3V<V> torque_i = scale(arm_i, twist);
    if constexpr (Law::kRolling) torque_i = torque_i + r.moment;
    add_to_particles<Real, 0>(r.force, torque_i, one, i, tile);
    if constexpr (kLast == 1) add_to_particles<Real, 1>(r.force, torque_i, one, i, tile);
  }
  add_to_particles<Real, 0>(on_j, torque_j, one, j, tile);
  if constexpr (kLast == 1) add_to_particles<Real, 1>(on_j, torque_j, one, j, tile);
}

// Particles of the next tile: the first pass there will need all of them within a short time.
template <class Real>
HWY_INLINE void prefetch_next_tile(const ParticleView<Real>& p, std::size_t first,
                                   std::size_t last) {
  constexpr std::size_t kTraitsInLine = 64 / sizeof(Traits<Real>);
  for (std::size_t k = first; k < last; ++k) {
    __builtin_prefetch(p.record + k, 0, 2);
    if (k % kTraitsInLine == 0) __builtin_prefetch(p.traits + k, 0, 2);
  }
}

// Approach and impact (J) of contacts that begin, as a vector of them; few do.
template <class Real>
struct ArrivalV {
  hn::Vec<Lanes<Real>> approach, impact;
};
template <class Real, class Law>
HWY_NOINLINE ArrivalV<Real> arrival_of(const StepConstants<Real>& step, const ParticleView<Real>& p,
                                       const Index* i, const Index* j) {
  const auto [a, b, radius_i, radius_j, s] = load_meeting(step, p, i, j);
  hn::Vec<Lanes<Real>> arm_i, arm_j;
  const auto t = touch_of<Real, Law>(step, a, radius_i, b, radius_j, s, arm_i, arm_j);
  return {energy_of(hn::Mul(t.normal_velocity, t.normal_velocity), t.inverse_mass),
          energy_of(dot(t.at_point, t.at_point), t.inverse_mass)};
}

// Contacts whose tallies are added in Real, and those whose energies by kind are.
constexpr std::size_t kFew = 4 * kPairPad, kFewOfKinds = 4 * kFew;

// Takes a few own contacts, which the law has told of, to their episodes. A loop of its own: in
// that of the law too many numbers are in use for the registers.
template <class Real, class Law>
HWY_INLINE void record_few(const StepConstants<Real>& step, const ParticleView<Real>& p,
                           const FoundPairs& found, std::size_t first, std::size_t last,
                           const HistoryView<Real>& old, const HistoryView<Real>& now,
                           HistoryPlace at, const ToldV<hn::Vec<Lanes<Real>>>* told,
                           PairCollisions<Real>& collisions) {
  const Lanes<Real> d;
  using V = hn::Vec<Lanes<Real>>;
  constexpr std::size_t kNumbers = Law::kRolling ? kRollingHistory : kHistory;
  const HistoryView<Real> from = behind<kNumbers>(old), to = behind<kNumbers>(now);
  const bool is_on = step.recording == Recording::kOn;
  for (std::size_t k = first; k < last; k += hn::MaxLanes(d), ++told) {
    const auto is_found = has_state<Real>(found.state + k, kTouches);
    const auto open = has_state<Real>(found.state + k, kDidTouch);
    EpisodeV<V> e = {hn::Zero(d), hn::Zero(d), hn::Zero(d)};
    if (HWY_LIKELY(is_on)) load_history(from, at.old, open, e);
    follow_episodes<Real>(step.recording, *told, e);
    const Changes changes = changes_of(d, is_found, open);
    if (HWY_UNLIKELY((changes.begun | changes.ended) != 0) && is_on) {
      ArrivalV<Real> came = {e[2], e[2]};
      if (changes.begun != 0) came = arrival_of<Real, Law>(step, p, found.i + k, found.j + k);
      e[2] = hn::IfThenElse(hn::AndNot(open, is_found), came.approach, e[2]);
      tell_changes<Real>(changes, told->kind, hn::Add(e[0], e[1]), e[2], came.impact, collisions);
    }
    store_history(e, is_found, to, at.now);
    at.old += hn::CountTrue(d, open);
    at.now += hn::CountTrue(d, is_found);
  }
}

// The first pass of `single` has not looked at records: asks for those of a vector to come.
template <class Real>
HWY_INLINE void prefetch_found(const ParticleView<Real>& p, const Index* i, const Index* j) {
  for (std::size_t k = 0; k < hn::MaxLanes(Lanes<Real>()); ++k) {
    __builtin_prefetch(p.record + i[k]);
    __builtin_prefetch(p.record + j[k]);
  }
}

// The second pass over one part.
template <class Real, class Law, bool kOwn>
HWY_INLINE void push_part(const StepConstants<Real>& step, const ParticleView<Real>& p,
                          const FoundPairs& found, const HistoryView<Real>& old,
                          const HistoryView<Real>& now, const TileRows& tile, HistoryPlace& at,
                          ContactTally& tally, PairCollisions<Real>* collisions) {
  using V = hn::Vec<Lanes<Real>>;
  constexpr std::size_t kLanes = hn::MaxLanes(Lanes<Real>()), kAhead = 2 * kPairPad;
  [[maybe_unused]] const std::size_t kinds = pair_kinds_among(step.groups);
  const std::size_t first = kOwn ? 0 : found.imported_begin();
  const std::size_t last = first + (kOwn ? found.own : found.imported);
  TallySumV sum = zero_tally_sum();
  [[maybe_unused]] std::conditional_t<Law::kRecorded, KindsV<V>, bool> of_kinds;
  [[maybe_unused]] ToldV<V> told[Law::kRecorded ? kFew / kLanes : 1];
  if constexpr (Law::kRecorded) clear_sums(kinds, of_kinds);
  for (std::size_t from = first; from < last; from += kFew) {
    TallyV<V> few = zero_tally<Real>();
    const std::size_t end = std::min(last, from + kFew);
    [[maybe_unused]] const HistoryPlace before = at;
    for (std::size_t k = from; k < end; k += kLanes) {
      if (const std::size_t next = k + kAhead; p.on_grid != nullptr && next < last) {
        prefetch_found(p, found.i + next, found.j + next);
      }
      sphere_sphere<Real, Law, kOwn>(step, p, found.i + k, found.j + k, found.state + k, old, now,
                                     tile, at, few,
                                     told + (Law::kRecorded ? (k - from) / kLanes : 0));
    }
    if constexpr (Law::kRecorded) {
      if (from % kFewOfKinds == 0) clear_few(kinds, of_kinds);
      add_to_kinds<Real>(kinds, told, (end - from + kLanes - 1) / kLanes, of_kinds);
      if ((from + kFew) % kFewOfKinds == 0 || end == last) add_few<Real>(kinds, of_kinds);
      record_few<Real, Law>(step, p, found, from, end, old, now, before, told, *collisions);
    }
    if constexpr (kOwn) {
      add_few<Real>(few, sum);
      const std::size_t next = tile.first + tile.size;
      prefetch_next_tile(p, next + from * tile.size / last, next + end * tile.size / last);
    }
  }
  if constexpr (kOwn) add_tally(sum, tally);
  if constexpr (Law::kRecorded) add_sums(kinds, of_kinds, sum, collisions->energies);
}
template <class Real, class OfOwn, class OfImported>
void push_parts(const StepConstants<Real>& step, const ParticleView<Real>& p,
                const FoundPairs& found, const HistoryView<Real>& old, const HistoryView<Real>& now,
                const TileRows& tile, ContactTally& tally, PairCollisions<Real>* collisions) {
  HistoryPlace at;
  push_part<Real, OfOwn, true>(step, p, found, old, now, tile, at, tally, collisions);
  push_part<Real, OfImported, false>(step, p, found, old, now, tile, at, tally, nullptr);
}
template <class Real, class Springs>
void push_pairs(const StepConstants<Real>& step, const ParticleView<Real>& p,
                const FoundPairs& found, const HistoryView<Real>& old, const HistoryView<Real>& now,
                const TileRows& tile, ContactTally& tally, PairCollisions<Real>* collisions) {
  const auto push = [&]<class Law>(Law) {
    if (collisions != nullptr) {
      push_parts<Real, Recorded<Law>, Law>(step, p, found, old, now, tile, tally, collisions);
    } else {
      push_parts<Real, Law, Law>(step, p, found, old, now, tile, tally, nullptr);
    }
  };
  if (step.rolling) {
    push(RollingLaw<Springs>());
  } else if (step.damped) {
    push(DampedLaw<Springs>());
  } else {
    push(PlainLaw<Springs>());
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace quern
HWY_AFTER_NAMESPACE();

#endif
