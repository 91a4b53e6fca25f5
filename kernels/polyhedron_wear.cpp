// What polyhedra wear off walls, from the lanes of their contacts.
#include "kernels/polyhedron_contacts.h"

namespace quern {

template <class Real>
void PolyhedronContacts<Real>::list_wear(const World<Real>& world,
                                         const StepConstants<double>& step, WearList& list) const {
  using B = BodyContacts;
  const Polyhedra<Real>& p = world.polyhedra;
  for (std::size_t k = 0; k < count_; ++k) {
    const Lane& lane = lanes_[k];
    if (lane.pair) continue;
    const std::size_t body = lane.wall.particle;
    WearContact c;
    c.normal = get3(B::kNormal, k);
    c.force = get3(B::kForce, k);
    c.velocity = p.velocity(body) - lane.wall_velocity;
    c.at_point = get3(B::kAtPoint, k);
    c.braked = world.wear.velocity == WearVelocity::kAbsolute ? p.velocity(body) : c.velocity;
    c.slide = get(B::kSlide, k);
    c.mass = 1 / p.inverse_mass[body];
    c.friction = step.law.sliding_friction[law_row_[k]];
    c.touching = lane.touching;
    c.first_touch = lane.touching && !(get(B::kOverlapOld, k) > 0);
    add_wear(world, c, lane.wall.wall, lane.wall.point, lane.smaller, p.species[body], list);
  }
}

template void PolyhedronContacts<float>::list_wear(const World<float>&,
                                                   const StepConstants<double>&, WearList&) const;
template void PolyhedronContacts<double>::list_wear(const World<double>&,
                                                    const StepConstants<double>&, WearList&) const;

}  // namespace quern
