// Leapfrog for spheres, one tile: v(n+1/2) = v(n-1/2) + dt (F/m + g), x(n+1) = x(n) + dt v(n+1/2),
// w likewise with I = 2/5 m r^2. Writes the tile's next records, counts what the ledger needs and
// watches how far each particle has left the straight line that the lists predicted for it.
#if defined(QUERN_INTEGRATE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef QUERN_INTEGRATE_INL_H_
#undef QUERN_INTEGRATE_INL_H_
#else
#define QUERN_INTEGRATE_INL_H_
#endif

#include <algorithm>

#include "kernels/pair_loop-inl.h"

HWY_BEFORE_NAMESPACE();
namespace quern {
namespace HWY_NAMESPACE {

// Rows first ... first + lanes - 1 of the accumulator as lanes.
HWY_INLINE void load_sums(const double* rows, hn::Vec<D64> (&c)[8]) {
#if QUERN_AVX512
  for (int k = 0; k < 8; ++k) c[k] = hn::Load(D64(), rows + 8 * k);
  transpose8(c);
#else
  load_rows([&](std::size_t lane) HWY_ATTR { return rows + 8 * lane; }, c);
#endif
}

template <class Real>
HWY_INLINE void store_records(const Vec3V<hn::Vec<D64>>& x, const Vec3V<hn::Vec<D64>>& v,
                              const Vec3V<hn::Vec<D64>>& w, hn::Vec<HalfLanes<Real>> radius,
                              std::size_t count, Record<Real>* to) {
  const D64 d;
  const HalfLanes<Real> dr;
  constexpr std::size_t kLanes = hn::MaxLanes(D64());
  HWY_ALIGN double wide[6][kLanes];
  HWY_ALIGN Real narrow[4][kLanes];
  hn::Store(x.x, d, wide[0]);
  hn::Store(x.y, d, wide[1]);
  hn::Store(x.z, d, wide[2]);
  hn::Store(v.x, d, wide[3]);
  hn::Store(v.y, d, wide[4]);
  hn::Store(v.z, d, wide[5]);
  hn::StoreU(to_real<Real>(w.x), dr, narrow[0]);
  hn::StoreU(to_real<Real>(w.y), dr, narrow[1]);
  hn::StoreU(to_real<Real>(w.z), dr, narrow[2]);
  hn::StoreU(radius, dr, narrow[3]);
  for (std::size_t k = 0; k < count; ++k) {
    to[k] = {wide[0][k], wide[1][k], wide[2][k], narrow[3][k], narrow[0][k],
             wide[3][k], wide[4][k], wide[5][k], narrow[1][k], narrow[2][k]};
  }
}

// As many whole records as there are lanes, turned in registers; written past the caches, which do not
// hold them until the next step anyway.
HWY_INLINE void store_full_records(const Vec3V<hn::Vec<D64>>& x, const Vec3V<hn::Vec<D64>>& v,
                                   const Vec3V<hn::Vec<D64>>& w, hn::Vec<HalfLanes<float>> radius,
                                   Record<float>* to) {
  const auto bits = [](auto f32) HWY_ATTR {
    return hn::PromoteTo(D64U(), hn::BitCast(D32U(), f32));
  };
  const auto two = [&](auto low, auto high) HWY_ATTR {
    return hn::BitCast(D64(), hn::Or(bits(low), hn::ShiftLeft<32>(bits(high))));
  };
  const Vec3V<hn::Vec<HalfLanes<float>>> spin = to_real<float>(w);
  const hn::Vec<D64> c[8] = {x.x, x.y, x.z, two(radius, spin.x),
                             v.x, v.y, v.z, two(spin.y, spin.z)};
  turn_to_rows(c, [&](std::size_t lane, std::size_t at, hn::Vec<D64> numbers) HWY_ATTR {
    hn::Stream(numbers, D64(), reinterpret_cast<double*>(to + lane) + at);
  });
}

template <class Real, class V>
HWY_INLINE hn::Vec<HalfLanes<float>> to_f32(V v) {
  if constexpr (sizeof(Real) == sizeof(float)) {
    return v;
  } else {
    return hn::DemoteTo(HalfLanes<float>(), v);
  }
}
// Where they will be on the grid of `single`.
template <class Real>
HWY_INLINE void store_on_grid(const PlaceGrid& grid, const Vec3V<hn::Vec<D64>>& x,
                              hn::Vec<HalfLanes<Real>> radius, std::size_t count, GridPlace* to) {
  const D64 d;
  const D32I di;
  constexpr std::size_t kLanes = hn::MaxLanes(d);
  const auto number = [&](auto v, std::size_t axis) HWY_ATTR {
    const auto moved =
        hn::Add(hn::Mul(v, hn::Set(d, grid.inverse[axis])), hn::Set(d, PlaceGrid::kToInteger));
    return hn::BitCast(di, hn::TruncateTo(D32U(), hn::BitCast(D64U(), moved)));
  };
  HWY_ALIGN GridPlace place[kLanes];
#if HWY_TARGET == HWY_SCALAR
  place[0] = {hn::GetLane(number(x.x, 0)), hn::GetLane(number(x.y, 1)), hn::GetLane(number(x.z, 2)),
              hn::GetLane(to_f32<Real>(radius))};
#else
  std::int32_t* const numbers = reinterpret_cast<std::int32_t*>(count == kLanes ? to : place);
  hn::StoreInterleaved4(number(x.x, 0), number(x.y, 1), number(x.z, 2),
                        hn::BitCast(di, to_f32<Real>(radius)), di, numbers);
  if (count == kLanes) return;
#endif
  std::copy_n(place, count, to);
}

// Asks for what a later block of the tile will need; past the end it is the next tile's.
template <class Real>
HWY_INLINE void prefetch_block(const MoveView<Real>& m, std::size_t at) {
  for (int a = 0; a < 3; ++a) {
    hwy::Prefetch(m.spin[a] + at);
    hwy::Prefetch(m.rest[a] + at);
    hwy::Prefetch(m.list_place[a] + at);
    hwy::Prefetch(m.list_velocity[a] + at);
  }
  hwy::Prefetch(m.list_allowance + at);
}

inline constexpr double kNeverSoFar = 1e30;  // m^2

struct MoveSumV {
  hn::Vec<D64> translational, rotational, momentum[3], moment[3], drag, deviation, strays, bad, fast;
};

template <class Real>
void move_spheres(const MoveView<Real>& m, const TileRows& tile, double dt, MoveTally& tally) {
  const D64 d;
  using V = hn::Vec<D64>;
  const std::size_t lanes = hn::Lanes(d);
  const V zero = hn::Zero(d), half = hn::Set(d, 0.5), dtv = hn::Set(d, dt);
  const V kick = hn::Set(d, m.kick);
  const V drag = hn::Set(d, m.drag), elapsed = hn::Set(d, m.list_time);
  const Vec3V<V> gravity = {hn::Set(d, m.gravity[0]), hn::Set(d, m.gravity[1]),
                            hn::Set(d, m.gravity[2])};
  const ParticleView<Real> view = {m.now, m.traits_now};
  MoveSumV sum = {zero, zero, {zero, zero, zero}, {zero, zero, zero}, zero, zero, zero, zero, zero};
  HWY_ALIGN Index lane[16];
  for (std::size_t k = 0; k < tile.size; k += lanes) {
    const std::size_t at = tile.first + k;
    const std::size_t count = HWY_MIN(lanes, tile.size - k);
    // Lanes beyond the tile repeat its last particle; they are not stored and not counted.
    for (std::size_t l = 0; l < lanes; ++l) {
      lane[l] = static_cast<Index>(at + HWY_MIN(l, count - 1));
    }
    prefetch_block(m, at + 8 * lanes);
    const auto live = hn::FirstN(d, count);
    const PartnerV<Real> p = load_partner(view, lane);
    V row[8];
    load_sums(tile.rows + k * kRowWidth, row);
    const V inverse_mass = to_f64(p.inverse_mass), radius = to_f64(p.radius);
    const V push = hn::Mul(kick, inverse_mass);
    const Vec3V<V> force = {row[0], row[1], row[2]}, torque = {row[3], row[4], row[5]};
    const Vec3V<V> kicked = add_scaled(add_scaled(p.velocity, push, force), kick, gravity);
    const Vec3V<V> velocity = scale(drag, kicked);
    // A particle at rest moves by less than a last place of where it is: what rounding leaves of a
    // step is added to the next.
    const hn::Rebind<float, D64> df;
    const auto rest = [&](int axis) HWY_ATTR {
      return hn::PromoteTo(d, hn::LoadU(df, m.rest[axis] + at));
    };
    const Vec3V<V> way = add_scaled(Vec3V<V>{rest(0), rest(1), rest(2)}, dtv, velocity);
    const Vec3V<V> place = p.place + way;
    const Vec3V<V> left = way - (place - p.place);
    const V r2 = hn::Mul(radius, radius);
    const V twist = hn::Div(hn::Mul(hn::Set(d, 2.5), push), r2);
    const Vec3V<V> spin_old = {hn::LoadU(d, m.spin[0] + at), hn::LoadU(d, m.spin[1] + at),
                               hn::LoadU(d, m.spin[2] + at)};
    const Vec3V<V> spin_kicked = add_scaled(spin_old, twist, torque);
    const Vec3V<V> spin = scale(drag, spin_kicked);
    if constexpr (sizeof(Real) == sizeof(float) && HWY_TARGET != HWY_SCALAR) {
      if (count == lanes) {
        store_full_records(place, velocity, spin, p.radius, m.next + at);
      } else {
        store_records<Real>(place, velocity, spin, p.radius, count, m.next + at);
      }
    } else {
      store_records<Real>(place, velocity, spin, p.radius, count, m.next + at);
    }
    if (m.on_grid_next != nullptr) {
      store_on_grid<Real>(*m.grid, place, p.radius, count, m.on_grid_next + at);
    }
    hn::BlendedStore(spin.x, live, d, m.spin[0] + at);
    hn::BlendedStore(spin.y, live, d, m.spin[1] + at);
    hn::BlendedStore(spin.z, live, d, m.spin[2] + at);
    hn::BlendedStore(hn::DemoteTo(df, left.x), hn::FirstN(df, count), df, m.rest[0] + at);
    hn::BlendedStore(hn::DemoteTo(df, left.y), hn::FirstN(df, count), df, m.rest[1] + at);
    hn::BlendedStore(hn::DemoteTo(df, left.z), hn::FirstN(df, count), df, m.rest[2] + at);
    HWY_ALIGN double touches[hn::MaxLanes(D64())];
    hn::Store(row[6], d, touches);
    for (std::size_t l = 0; l < count; ++l) {
      const Traits<Real>& now = m.traits_now[at + l];
      m.traits_next[at + l] = {
          now.inverse_mass, make_tag(tag_material(now.tag), static_cast<std::uint32_t>(touches[l]), tag_group(now.tag))};
    }

    const V mass = hn::Div(hn::Set(d, 1), inverse_mass);
    const auto count_if = [&](V v) HWY_ATTR { return hn::IfThenElseZero(live, v); };
    const V half_mass = count_if(hn::Mul(half, mass));
    sum.translational = hn::MulAdd(half_mass, dot(p.velocity, kicked), sum.translational);
    const V half_inertia = hn::Mul(half_mass, hn::Mul(hn::Set(d, 0.4), r2));
    sum.rotational = hn::MulAdd(half_inertia, dot(spin_old, spin_kicked), sum.rotational);
    const V counted_mass = count_if(mass);
    sum.momentum[0] = hn::MulAdd(counted_mass, p.velocity.x, sum.momentum[0]);
    sum.momentum[1] = hn::MulAdd(counted_mass, p.velocity.y, sum.momentum[1]);
    sum.momentum[2] = hn::MulAdd(counted_mass, p.velocity.z, sum.momentum[2]);
    sum.moment[0] = hn::MulAdd(counted_mass, p.place.x, sum.moment[0]);
    sum.moment[1] = hn::MulAdd(counted_mass, p.place.y, sum.moment[1]);
    sum.moment[2] = hn::MulAdd(counted_mass, p.place.z, sum.moment[2]);
    sum.drag = hn::MulAdd(half_mass, hn::Sub(dot(kicked, kicked), dot(velocity, velocity)), sum.drag);
    sum.drag = hn::MulAdd(half_inertia, hn::Sub(dot(spin_kicked, spin_kicked), dot(spin, spin)),
                          sum.drag);

    const auto line = [&](int axis) HWY_ATTR {
      const auto v = hn::PromoteTo(d, hn::LoadU(hn::Rebind<float, D64>(), m.list_velocity[axis] + at));
      return hn::MulAdd(v, elapsed, hn::LoadU(d, m.list_place[axis] + at));
    };
    const Vec3V<V> off = place - Vec3V<V>{line(0), line(1), line(2)};
    const V off2 = count_if(dot(off, off));
    const V allowed = hn::PromoteTo(d, hn::LoadU(hn::Rebind<float, D64>(), m.list_allowance + at));
    const V allowed2 = hn::Mul(allowed, allowed);
    sum.deviation = hn::Max(sum.deviation, off2);
    sum.strays =
        hn::Add(sum.strays, hn::IfThenElseZero(hn::Gt(off2, allowed2), hn::Set(d, 1)));
    const auto inside = [&](V v, int axis) HWY_ATTR {
      return hn::And(hn::Ge(v, hn::Set(d, m.low[axis])), hn::Le(v, hn::Set(d, m.high[axis])));
    };
    // A line or an allowance that is not finite would never let the lists go stale.
    const auto listed = hn::Lt(hn::Add(off2, allowed2), hn::Set(d, kNeverSoFar));
    // The spins that partners read are written anew: only a contact would show a wrong one elsewhere.
    const auto spins = hn::IsFinite(
        hn::Add(hn::Add(to_f64(p.spin.x), to_f64(p.spin.y)), to_f64(p.spin.z)));
    const auto good = hn::And(hn::And(listed, spins),
                              hn::And(inside(place.x, 0),
                                      hn::And(inside(place.y, 1), inside(place.z, 2))));
    sum.bad = hn::Add(sum.bad, count_if(hn::IfThenZeroElse(good, hn::Set(d, 1))));
    const auto fast = hn::Gt(hn::Mul(hn::Mul(dtv, dtv), dot(velocity, velocity)), r2);
    sum.fast = hn::Add(sum.fast, count_if(hn::IfThenElseZero(fast, hn::Set(d, 1))));
  }
  hwy::FlushStream();
  tally.translational += sum_lanes(sum.translational);
  tally.rotational += sum_lanes(sum.rotational);
  for (int axis = 0; axis < 3; ++axis) {
    tally.momentum[axis] += sum_lanes(sum.momentum[axis]);
    tally.moment_of_mass[axis] += sum_lanes(sum.moment[axis]);
  }
  tally.drag_loss += sum_lanes(sum.drag);
  tally.bad += sum_lanes(sum.bad);
  tally.fast += sum_lanes(sum.fast);
  tally.strays += sum_lanes(sum.strays);
  HWY_ALIGN double deviation[hn::MaxLanes(D64())];
  hn::Store(sum.deviation, d, deviation);
  for (std::size_t l = 0; l < lanes; ++l) {
    tally.max_deviation2 = HWY_MAX(tally.max_deviation2, deviation[l]);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace quern
HWY_AFTER_NAMESPACE();

#endif
