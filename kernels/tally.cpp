#include "kernels/tally.h"

#include <algorithm>
#include <cmath>

namespace quern {

namespace {

double mean(const TallyInput& in, double sum) {
  return in.window->steps > 0 ? sum / in.window->steps : 0;
}

// What all share; 0 while nobody has come in.
double share(double sum, double among) { return among > 0 ? sum / among : 0; }

double centre(const TallyInput& in, std::size_t axis) {
  return share(mean(in, in.window->moment_of_mass[axis]), in.mass);
}

}  // namespace

double ledger_error(const Ledger& l) {
  const double stored = l.kinetic + l.elastic - l.start_kinetic - l.start_elastic;
  const double missing = l.wall_work + l.gravity_work - stored - l.dissipated() - l.drag_loss;
  const double scale = std::max({l.wall_work, l.start_kinetic, l.dissipated()});
  return scale > 0 ? std::abs(missing) / scale : 0;
}

double numerical_loss_share(const Ledger& l) {
  return l.dissipated() > 0 ? l.numerical_loss / l.dissipated() : 0;
}

double model_work_share(const Ledger& l) {
  return l.dissipated() > 0 ? l.model_work / l.dissipated() : 0;
}

std::vector<TallyRow> tally_rows_of(bool polyhedra) {
  std::vector<TallyRow> rows;
  for (const TallyRow& row : tally_rows()) {
    if (polyhedra || !row.of_polyhedra) rows.push_back(row);
  }
  return rows;
}

const std::vector<TallyRow>& tally_rows() {
  using In = const TallyInput&;
  static const std::vector<TallyRow> rows = {
      {{"time", "s", "since the walls started to move"}, [](In in) { return in.time; }},
      {{"torque", "N m", "moment of the charge on the rotating walls about their axis, mean"},
       [](In in) { return mean(in, in.window->torque); }},
      {{"power", "W", "work of the moving walls on the charge per time, mean"},
       [](In in) { return mean(in, in.window->power); }},
      {{"kinetic_energy", "J", "translational, mean"},
       [](In in) { return mean(in, in.window->translational); }},
      {{"rotational_energy", "J", "mean"}, [](In in) { return mean(in, in.window->rotational); }},
      {{"elastic_energy", "J", "of all contact springs, mean"},
       [](In in) { return mean(in, in.window->elastic); }},
      {{"potential_energy", "J", "in gravity, relative to the origin, mean"},
       [](In in) {
         return -(in.gravity.x() * centre(in, 0) + in.gravity.y() * centre(in, 1) +
                  in.gravity.z() * centre(in, 2)) *
                in.mass;
       }},
      {{"center_of_mass_x", "m", "mean"}, [](In in) { return centre(in, 0); }},
      {{"center_of_mass_y", "m", "mean"}, [](In in) { return centre(in, 1); }},
      {{"center_of_mass_z", "m", "mean"}, [](In in) { return centre(in, 2); }},
      {{"contacts_per_particle", "1", "touching particles per particle, walls not counted, mean"},
       [](In in) { return share(2 * mean(in, in.window->pair_contacts), in.particles); }},
      {{"wall_contacts", "1", "contacts with walls, mean"},
       [](In in) { return mean(in, in.window->wall_contacts); }},
      {{"max_overlap", "1", "largest overlap over the smaller radius"},
       [](In in) { return in.window->max_overlap; }},
      {{"wall_work", "J", "by the walls on the charge, since the start"},
       [](In in) { return in.ledger->wall_work; }},
      {{"gravity_work", "J", "since the start"}, [](In in) { return in.ledger->gravity_work; }},
      {{"dissipation", "J", "all of it, since the start"},
       [](In in) { return in.ledger->dissipated(); }},
      {{"dissipation_normal", "J", "by normal damping, since the start"},
       [](In in) { return in.ledger->normal_damping(); }},
      {{"dissipation_sliding", "J", "by sliding, since the start"},
       [](In in) { return in.ledger->slide; }},
      {{"dissipation_tangential", "J", "by tangential damping, since the start"},
       [](In in) { return in.ledger->tangential_damping; }},
      {{"numerical_loss", "J", "part of the dissipation that is error of the time step"},
       [](In in) { return in.ledger->numerical_loss; }},
      {{"ledger_error", "1", "energy not accounted for, relative"},
       [](In in) { return ledger_error(*in.ledger); }},
      {{"polyhedron_sphere_contacts", "1", "touching pairs of a polyhedron and a sphere, mean"},
       [](In in) { return mean(in, in.window->polyhedron_sphere_contacts); },
       true},
      {{"polyhedron_pair_contacts", "1", "touching pairs of polyhedra, mean"},
       [](In in) { return mean(in, in.window->polyhedron_pair_contacts); },
       true},
      {{"polyhedron_wall_contacts", "1", "contacts of polyhedra with walls, mean"},
       [](In in) { return mean(in, in.window->polyhedron_wall_contacts); },
       true},
      {{"model_work", "J",
        "part of the dissipation: work of normal forces of polyhedra, which have no potential"},
       [](In in) { return in.ledger->model_work; },
       true},
  };
  return rows;
}

}  // namespace quern
