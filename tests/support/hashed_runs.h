// Runs that must end in the same bits: a charge in motion is made once and kept as a checkpoint;
// from there it goes on with any number of threads, any order of the tiles, with or without a
// restart.
#pragma once

#include <gtest/gtest.h>

#include <memory>

#include "io/checkpoint.h"
#include "soa/hash.h"
#include "tests/support/build_world.h"
#include "tests/support/temp_folder.h"
#include "tests/support/trap_fp.h"

namespace quern {

struct RunOptions {
  int threads = 1;
  std::uint64_t shuffle = 0;
  std::uint64_t checkpoint_at = 0;  // step at which one is written and forgotten
  std::uint64_t resume_at = 0;      // step at which the run goes on in a new world
};

template <class Real>
void write_state(World<Real>& world, const std::string& folder) {
  write_checkpoint(folder, CheckpointHeader(), [&](StateVisitor& v) { world.visit(v); });
}

template <class Real>
void advance(World<Real>& world, const RunOptions& o, std::uint64_t until) {
  Stepper<Real> stepper(world, o.threads);
  if (o.shuffle != 0) stepper.graph().shuffle(o.shuffle);
  while (world.clock.step < until) {
    const StepReport report = stepper.step();
    ASSERT_EQ(report.bits & kFatalBits, 0u) << "step " << world.clock.step;
  }
}

// A new world with the state of a checkpoint.
template <class Real = float>
std::unique_ptr<World<Real>> read_state(const Scene& scene, const std::string& folder) {
  auto world = std::make_unique<World<Real>>(world_of<Real>(scene));
  read_checkpoint(folder + "/checkpoint.h5", [&](StateVisitor& v) { world->visit(v); });
  return world;
}

// A scene with a charge in motion.
template <class Real>
struct StartIn {
  Scene scene;
  TempFolder folder;
  StartIn(const Scene& from, std::uint64_t warm_up) : scene(from) {
    World<Real> world = world_of<Real>(scene);
    advance(world, {}, warm_up);
    write_state(world, folder.path());
  }

  std::unique_ptr<World<Real>> world_after(const RunOptions& o, std::uint64_t steps) const {
    TempFolder between;
    std::unique_ptr<World<Real>> world = read_state<Real>(scene, folder.path());
    const std::uint64_t now = world->clock.step;
    if (o.checkpoint_at != 0) {
      advance(*world, o, now + o.checkpoint_at);
      write_state(*world, between.path());
    }
    if (o.resume_at != 0) {
      advance(*world, o, now + o.resume_at);
      write_state(*world, between.path());
      world = read_state<Real>(scene, between.path());
    }
    advance(*world, o, now + steps);
    EXPECT_GT(world->totals.pair_contacts + world->totals.wall_contacts, 100)
        << "a charge without contacts proves nothing";
    return world;
  }
  std::uint64_t hash_after(const RunOptions& o, std::uint64_t steps = 2000) const {
    return state_hash(*world_after(o, steps));
  }
};
using Start = StartIn<float>;  // in mixed precision, as scenes run by default

}  // namespace quern
