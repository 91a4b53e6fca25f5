// What must hold between the keys of a scene, once each was read for itself; and the parts of the
// Scene that follow from others (walls by kind, the domain of a periodic mill, particles from CSV).
#pragma once

#include "io/table_reader.h"

namespace quern {

// Checks the draft and completes draft.scene. Values whose path is spoiled are passed over.
void check_scene(SceneDraft& draft, ReadContext& context);

}  // namespace quern
