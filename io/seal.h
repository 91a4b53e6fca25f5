// Seals: a file's last 16 bytes are a mark and a checksum of all that is before them, so that damage is
// known before anybody takes the file apart.
//
// For checkpoints: HDF5 notices flipped bytes by its own checksums, but frees what it never had where
// they lie in the names of a large group (1.10.8), and the program ends. It passes over what lies
// behind its data; a file that it has written to again has lost its seal.
#pragma once

#include <string>

namespace quern {

// Appends the seal; for a file that is whole. Errors are SystemError.
void seal_file(const std::string& what, const std::string& path);
// SystemError if the seal is missing or broken.
void check_seal(const std::string& what, const std::string& path);

}  // namespace quern
