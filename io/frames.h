// FrameWriter: pictures of the run for ParaView, one file a moment, in OUT/frames.
//
// particles_000123.hdf (one vertex cell a sphere), polyhedra_000123.hdf and liner_000123.hdf
// (triangles) are VTKHDF 1.0 UnstructuredGrid, which is what ParaView 5.11 reads;
// contacts_000123.hdf, where asked for, is one vertex cell a contact;
// particles.hdf.series and so on give the times. For scripts, polyhedra_000123.hdf has a group
// `polyhedra` with one row a body: place, orientation, velocities. Files appear by renaming, the
// series after the frame it lists, so a viewer or a killed run never meets half a file. Every
// dataset carries its unit.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "soa/output.h"

namespace quern {

struct FrameEntry {
  int number = 0;
  double time = 0;  // s
};

// What FOLDER/NAME.hdf.series lists, in its order; nothing if there is no such file.
std::vector<FrameEntry> read_frame_list(const std::string& folder, const std::string& name);
// FOLDER/NAME_000123.hdf
std::string frame_path(const std::string& folder, const std::string& name, int number);

class FrameWriter {
 public:
  // Makes the folder if needed and continues the series it holds.
  explicit FrameWriter(std::string folder);

  // Writes frame `number` >= 0. Frames from `number` on that a resumed run has left are deleted.
  // Without triangles no liner file is written; `polyhedra` is absent in a scene that has none,
  // `contacts` where nobody asks for them.
  void write(int number, const ParticleFrame& particles, const WallFrame& walls,
             const std::optional<PolyhedronFrame>& polyhedra = {},
             const std::optional<ContactFrame>& contacts = {});

 private:
  struct FileSeries {
    std::string name;  // "particles", "polyhedra", "liner", "contacts"
    std::vector<FrameEntry> entries;
  };
  void drop_from(FileSeries& series, int number) const;
  void list(const FileSeries& series) const;  // writes the list of its files

  std::string folder_;
  FileSeries particles_{"particles", {}};
  FileSeries polyhedra_{"polyhedra", {}};
  FileSeries liner_{"liner", {}};
  FileSeries contacts_{"contacts", {}};
};

// A single surface, in the units of its file.
void write_surface(const std::string& path, const SurfaceFrame& frame);

}  // namespace quern
