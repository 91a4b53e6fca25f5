#include "apps/quern/info.h"

#include <fmt/format.h>

#include "io/log.h"
#include "io/scene_reader.h"
#include "kernels/contact.h"
#include "kernels/simd_target.h"
#include "kernels/tally.h"
#include "soa/catalog.h"
#include "soa/fields.h"
#include "soa/polyhedra.h"

namespace quern {

namespace {

void print_catalog() {
  for (const CatalogEntry& entry : contact_catalog()) {
    log_info(fmt::format("{:<10} {:<24} {}", entry.kind, entry.name, entry.doc));
    for (const CatalogParameter& p : entry.parameters) {
      log_info(fmt::format("{:11}{:<24} {:<6} {:<22} {}{}", "", p.name, p.unit, p.range, p.doc,
                           p.fallback.empty() ? "" : " (default " + p.fallback + ")"));
    }
  }
}

}  // namespace

int info_command() {
  log_info(fmt::format("quern {} ({})\n", QUERN_VERSION, QUERN_COMMIT));
  log_info("Laws, pair types, walls");
  print_catalog();
  log_info("\nParticle fields");
#define QUERN_PRINT(type, name, unit, doc) \
  log_info(fmt::format("{:<16} {:<22} {:<22} {}", #name, #type, unit, doc));
  QUERN_PARTICLE_FIELDS(QUERN_PRINT)
  log_info("\nPolyhedron fields");
  QUERN_POLYHEDRON_FIELDS(QUERN_PRINT)
#undef QUERN_PRINT
  log_info("\nTallies (series in run.h5)");
  for (const TallyRow& row : tally_rows()) {
    log_info(fmt::format("{:<26} {:<6} {}{}", row.quantity.name, row.quantity.unit,
                         row.quantity.doc, row.of_polyhedra ? " (scenes with polyhedra)" : ""));
  }
  log_info("\nScene keys");
  for (const SceneKey& key : scene_keys()) {
    log_info(fmt::format("{:<40} {:<28} {:<14} {}", key.path, key.type,
                         key.required ? "required" : key.fallback, key.doc));
  }
  std::string targets;
  for (const std::string& target : simd_targets()) targets += ' ' + target;
  log_info(fmt::format("\nSIMD targets on this machine, best first:{}", targets));
  log_info(fmt::format("chosen: mixed and single {}, double {}", choose_kernels<float>().target,
                       choose_kernels<double>().target));
  return 0;
}

}  // namespace quern
