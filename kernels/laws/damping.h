// From the coefficient of restitution to the damping ratio zeta, and contact times.
//
// Unclamped: zeta = -ln e / sqrt(pi^2 + ln^2 e), the plain damped oscillator over half a period.
// Clamped: the contact ends when the force would pull (Schwager and Poeschel, Granular Matter 9
// (2007) 465, equations 20-21); no closed inverse, so it is inverted numerically. Critical damping
// delivers e^-2 = 0.135; scenes that ask for less get that, with a warning from the reader.
#pragma once

#include "soa/scene.h"

namespace quern {

inline constexpr double kLeastClampedRestitution = 0.1353352832366127;  // e^-2

// Coefficient of restitution delivered by a clamped spring-dashpot of damping ratio zeta >= 0.
double clamped_restitution(double zeta);

// Damping ratio for 0 < e <= 1.
double damping_ratio(double restitution, NormalForce normal_force);

// pi sqrt(m_e / k), s.
double contact_time(double reduced_mass, double stiffness);

}  // namespace quern
