// Checkpoints: the whole state of a run, bit for bit, in OUT/checkpoint.h5.
//
// Written under a temporary name, synced, then renamed, with the one before kept as
// checkpoint.previous.h5: a kill at any moment leaves a whole checkpoint. Layout: attributes of the
// root (format, time, step, versions), header/scene_text, and state/NAME for every column and value
// that World::visit() names. Each dataset has a 64-bit hash of its contents besides HDF5's
// checksums, which take a block of zeros for good, and the file ends with a seal (seal.h). Plain records are stored as bytes, n x size.
#pragma once

#include <functional>
#include <string>

#include "soa/state.h"

namespace quern {

// Others are refused. One more whenever the state that World::visit() names changes.
inline constexpr std::uint64_t kCheckpointFormat = 4;

struct CheckpointHeader {
  std::string scene_text, scene_name, simd_target, precision, version;
  double time = 0;  // s
  std::uint64_t step = 0;
};

using VisitState = std::function<void(StateVisitor&)>;

// Writes folder/checkpoint.h5. On SystemError the checkpoints already there are untouched.
void write_checkpoint(const std::string& folder, const CheckpointHeader& header,
                      const VisitState& visit_state);

CheckpointHeader read_checkpoint_header(const std::string& path);

// Resizes and fills what `visit_state` names. SystemError if anything is missing, left over,
// damaged or of another type or size; the state is then partly overwritten and must not be used.
void read_checkpoint(const std::string& path, const VisitState& visit_state);

// Reads the whole file and checks every hash; SystemError if damaged.
void verify_checkpoint(const std::string& path);

bool has_checkpoint(const std::string& folder);  // usable or not

// Path of the newest checkpoint in the folder that verifies. `warning` (may be null) is set if that
// is the previous one, saying why, and else emptied. SystemError if there is none.
std::string usable_checkpoint(const std::string& folder, std::string* warning = nullptr);

}  // namespace quern
