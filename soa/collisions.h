// Collisions: what a run tells of who collided with whom, once it is asked to record them.
//
// A collision, or episode, is a contact from the first step in which two touch to the last. What it
// has dissipated is kept with the contact's history as D + U, its dissipation so far and the energy
// of its springs: a step subtracts the work of the contact force, nothing else, and when the
// contact ends U is zero. Energies of all contacts are summed by kind (pair of groups), and each
// episode is binned when it ends. Contacts open when recording begins start from D = 0 and no
// approach.
//
// Recording begins with an opening step, which takes the energies of the springs and counts
// nothing. All of it is state: saved, and part of what resumes bit for bit.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "soa/column.h"
#include "soa/ledger.h"
#include "soa/state.h"

namespace quern {

enum class Recording : std::uint64_t { kOff, kOpening, kOn };

// Bin 0: below 1e-12 J, negative ones included; then ten a decade; the last: from 1e3 J on.
inline constexpr std::size_t kEnergyBins = 152;
inline constexpr int kBinsPerDecade = 10, kFirstDecade = -12;

// Of contacts of one kind. Of work, sliding and tangential damping: sums over the recorded steps.
struct ContactEnergies {
  double work = 0;                           // J, of the contact force on the relative motion
  double elastic = 0;                        // J, of the springs, now
  double slide = 0, tangential_damping = 0;  // J, dissipated
  void add(const ContactEnergies& o) {
    work += o.work;
    elastic += o.elastic;
    slide += o.slide;
    tangential_damping += o.tangential_damping;
  }
};
static_assert(sizeof(ContactEnergies) == 4 * sizeof(double), "saved as numbers");

struct EnergySpectrum {
  std::array<double, kEnergyBins> count{}, energy{};  // 1, J
};

struct KindSpectra {
  EnergySpectrum dissipated;  // by an episode; counted when it ends
  EnergySpectrum approach;    // 1/2 m_e v_n^2 at first touch; counted when it ends
  EnergySpectrum impact;  // 1/2 m_e |v_rel|^2 at the contact point at first touch; counted there
};

// What an open contact with a wall, or of two polyhedra, keeps besides its spring.
struct Episode {
  double energy = 0;    // J, dissipated so far and stored
  double approach = 0;  // J, 1/2 m_e v_n^2 at first touch
};
static_assert(sizeof(Episode) == 2 * sizeof(double), "saved as bytes");

struct Collisions {
  Recording recording = Recording::kOff;
  double steps = 0;  // recorded, the opening one not counted
  Ledger start;      // when recording began
  std::vector<ContactEnergies> kinds;
  std::vector<double> start_elastic;  // J, of each kind, when recording began
  std::vector<KindSpectra> spectra;   // of each kind

  bool on() const { return recording != Recording::kOff; }
  double dissipated(std::size_t kind) const {
    return -kinds[kind].work - (kinds[kind].elastic - start_elastic[kind]);
  }
  double normal_damping(std::size_t kind) const {
    return dissipated(kind) - kinds[kind].slide - kinds[kind].tangential_damping;
  }
  // The next step is the opening one.
  void begin(std::size_t all_kinds) {
    *this = Collisions();
    recording = Recording::kOpening;
    kinds.resize(all_kinds);
    start_elastic.resize(all_kinds);
    spectra.resize(all_kinds);
  }
  void visit(StateVisitor& v);
};

}  // namespace quern
