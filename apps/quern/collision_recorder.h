// CollisionRecorder: power by kind of collision and collision spectra, from World's Collisions into
// run.h5 and the summary.
//
//   series/dissipation_by_kind/KIND    J since recording began; normal_, sliding_, tangential_
//   likewise power_by_kind                      W over the recorded window, a row a kind, with
//   standard errors spectra, spectra/KIND              a row a bin of energy
//
// Nothing of it is state: what it writes is worked out anew from the World and the series.
#pragma once

#include <string>
#include <vector>

#include "io/series.h"
#include "io/summary.h"
#include "soa/world.h"

namespace quern {

class CollisionRecorder {
 public:
  explicit CollisionRecorder(const Groups& groups);

  std::vector<Quantity> quantities() const;
  void append(const Collisions& collisions, std::vector<double>& row) const;
  // Tables of run.h5 and rows of the summary; nothing before recording has begun.
  template <class Real>
  void write(const World<Real>& world, double record_from, SeriesWriter& series,
             Summary& summary) const;

 private:
  void write_power(const Collisions& collisions, double time, double record_from,
                   SeriesWriter& series, Summary& summary) const;
  template <class Real>
  void write_spectra(const World<Real>& world, double time, SeriesWriter& series,
                     Summary& summary) const;

  std::vector<std::string> kinds_;
};

}  // namespace quern
