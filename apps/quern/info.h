// The command `quern info`: what this program knows, printed from the code's own tables.
#pragma once

namespace quern {

int info_command();

}  // namespace quern
