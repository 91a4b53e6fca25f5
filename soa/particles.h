// Particles: the columns of fields.h, plus the second copy of what a step rewrites.
//
// Order is the order of the space-filling curve of the last rebuild; identity is the column `id`.
// Tile t owns [t * tile_size, (t + 1) * tile_size). A step reads record and traits, writes
// record_next and traits_next, then swaps.
#pragma once

#include "soa/column.h"
#include "soa/fields.h"
#include "soa/record.h"
#include "soa/state.h"

namespace quern {

template <class Real>
struct Particles {
#define QUERN_DECLARE(type, name, unit, doc) Column<type> name;
  QUERN_PARTICLE_FIELDS(QUERN_DECLARE)
#undef QUERN_DECLARE
  Column<Record<Real>> record_next;
  Column<Traits<Real>> traits_next;

  std::size_t size() const { return record.size(); }

  void reset(std::size_t n) {
#define QUERN_RESET(type, name, unit, doc) name.reset(n);
    QUERN_PARTICLE_FIELDS(QUERN_RESET)
#undef QUERN_RESET
  }
  void resize(std::size_t n) {
#define QUERN_RESIZE(type, name, unit, doc) name.resize(n);
    QUERN_PARTICLE_FIELDS(QUERN_RESIZE)
#undef QUERN_RESIZE
    reset_next();
  }
  void release() {
#define QUERN_RELEASE(type, name, unit, doc) name.release();
    QUERN_PARTICLE_FIELDS(QUERN_RELEASE)
#undef QUERN_RELEASE
  }
  void reset_next() {
    record_next.reset(record.size());
    traits_next.reset(record.size());
  }
  void visit(StateVisitor& visitor) {
#define QUERN_VISIT(type, name, unit, doc) visitor.column("particles/" #name, unit, name, 1);
    QUERN_PARTICLE_FIELDS(QUERN_VISIT)
#undef QUERN_VISIT
    reset_next();
  }
};

}  // namespace quern
