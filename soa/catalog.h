// Catalog: how laws, pair types, walls and tallies describe themselves.
//
// The rows stand beside the code they describe; `quern info` and the writers iterate them, so that
// adding one needs no edit elsewhere. The catalog reaches io as an argument.
#pragma once

#include <string>
#include <vector>

#include "soa/output.h"

namespace quern {

struct CatalogParameter {
  std::string name, unit, fallback, range, doc;
};

struct CatalogEntry {
  std::string kind;  // "law", "pair type", "wall"
  std::string name;
  std::string doc;   // one line, with its source
  std::vector<CatalogParameter> parameters;
};

std::vector<CatalogEntry> contact_catalog();  // kernels/catalog.cpp

}  // namespace quern
