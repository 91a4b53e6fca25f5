// Runs a fuzz target without libFuzzer: over each file of some folders, and over as many mutations
// of each as asked for. A mutation is a function of the file and its number, so that what fails
// fails again.
//
// usage: quern_fuzz_TARGET MUTATIONS FOLDER ...
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <vector>

#include "tests/fuzz/fuzz.h"

namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes read(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

// One of: a bit flipped, a byte replaced, a stretch dropped, doubled or taken from another file, a
// number or sign that readers trip over put in.
void mutate(Bytes& bytes, const std::vector<Bytes>& all, std::mt19937& random) {
  static const std::vector<std::string> kWords = {"-1",
                                                  "1e999",
                                                  "nan",
                                                  "inf",
                                                  "0",
                                                  "99999999999999999999",
                                                  "\"",
                                                  "[",
                                                  "}",
                                                  "\n",
                                                  "=",
                                                  ".",
                                                  "#",
                                                  "\\u0000",
                                                  "\xff",
                                                  "e",
                                                  " m/s",
                                                  "true",
                                                  "{ time = \"0 s\", value = 1 }"};
  const auto below = [&](std::size_t n) { return n == 0 ? 0 : random() % n; };
  const std::size_t at = below(bytes.size()),
                    length = below(std::min<std::size_t>(64, bytes.size() - at));
  const auto place = bytes.begin() + static_cast<std::ptrdiff_t>(at);
  const auto end = place + static_cast<std::ptrdiff_t>(length);
  switch (random() % 6) {
    case 0:
      if (!bytes.empty()) *place ^= static_cast<std::uint8_t>(1u << random() % 8);
      break;
    case 1:
      if (!bytes.empty()) *place = static_cast<std::uint8_t>(random());
      break;
    case 2:
      bytes.erase(place, end);
      break;
    case 3: {
      const Bytes part(place, end);
      bytes.insert(place, part.begin(), part.end());
      break;
    }
    case 4: {
      const Bytes& other = all[below(all.size())];
      const std::size_t from = below(other.size()),
                        n = below(std::min<std::size_t>(200, other.size() - from));
      bytes.insert(place, &other[from], &other[from] + n);
      break;
    }
    default: {
      const std::string& word = kWords[below(kWords.size())];
      bytes.insert(place, word.begin(), word.end());
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) return 2;
  const unsigned mutations = static_cast<unsigned>(std::atoi(argv[1]));
  std::vector<std::filesystem::path> paths;
  for (int k = 2; k < argc; ++k) {
    for (const auto& entry : std::filesystem::directory_iterator(argv[k])) {
      if (entry.is_regular_file()) paths.push_back(entry.path());
    }
  }
  std::sort(paths.begin(), paths.end());
  std::vector<Bytes> all;
  for (const auto& path : paths) all.push_back(read(path));
  for (std::size_t k = 0; k < all.size(); ++k) {
    LLVMFuzzerTestOneInput(all[k].data(), all[k].size());
    for (unsigned m = 1; m <= mutations; ++m) {
      std::fprintf(stderr, "\r%s, mutation %u    ", paths[k].filename().c_str(), m);
      Bytes bytes = all[k];
      std::mt19937 random(m);
      for (unsigned times = 1 + random() % 4; times > 0; --times) mutate(bytes, all, random);
      LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
    }
  }
  std::printf("\n%zu files, %u mutations of each\n", all.size(), mutations);
  return all.empty() ? 1 : 0;
}
