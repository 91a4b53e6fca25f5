// Which kind of STL a file is, and a reader for each.
#include "io/mesh_reader.h"

#include <fmt/format.h>

#include <cctype>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string_view>

namespace quern {
namespace {

constexpr std::size_t kHeader = 84, kRecord = 50, kMostErrors = 20;

class Errors {
 public:
  Errors(const std::string& path, std::vector<std::string>& out) : path_(path), out_(out) {}
  void add(const std::string& place, const std::string& what) {
    if (++count_ <= kMostErrors) out_.push_back(path_ + place + ": error: " + what);
  }
  void close() {
    if (count_ > kMostErrors)
      out_.push_back(fmt::format("{}: error: ... and {} more", path_, count_ - kMostErrors));
  }

 private:
  std::string path_;
  std::vector<std::string>& out_;
  std::size_t count_ = 0;
};

std::uint32_t little_endian(const char* bytes) {
  std::uint32_t value = 0;
  for (int k = 3; k >= 0; --k) value = value << 8 | static_cast<unsigned char>(bytes[k]);
  return value;
}

float float_at(const char* bytes) {
  const std::uint32_t bits = little_endian(bytes);
  float value;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

void read_binary(const std::string& bytes, double scale, std::vector<Triangle>& out,
                 Errors& errors) {
  const std::size_t count = (bytes.size() - kHeader) / kRecord;
  out.reserve(count);
  for (std::size_t t = 0; t < count; ++t) {
    Triangle triangle;
    for (std::size_t k = 0; k < 9; ++k) {
      const double x = float_at(&bytes[kHeader + t * kRecord + 12 + 4 * k]);
      if (!std::isfinite(x))
        errors.add("", fmt::format("triangle {}, corner {}: {} is {}, not a finite number", t + 1,
                                   k / 3 + 1, "xyz"[k % 3], std::isnan(x) ? "NaN" : "infinite"));
      triangle.corner[k / 3][static_cast<Eigen::Index>(k % 3)] = scale * x;
    }
    out.push_back(triangle);
  }
}

struct Token {
  std::string_view text;  // empty: the end of the file
  int line = 1, column = 1;
  std::string place() const { return fmt::format(":{}:{}", line, column); }
  std::string shown() const {
    return text.empty() ? "the end of the file" : fmt::format("'{}'", text.substr(0, 40));
  }
};

class AsciiReader {
 public:
  AsciiReader(std::string_view text, double scale, std::vector<Triangle>& out, Errors& errors)
      : text_(text), scale_(scale), out_(out), errors_(errors) {
    advance();
  }

  void read() {
    while (!at_end()) {
      if (!is("solid")) return fail("expected 'solid' or the end of the file, found {}");
      skip_line();
      while (!is("endsolid")) {
        if (at_end()) return fail("the file ends without 'endsolid': is it cut off?");
        if (!read_facet()) resume();
      }
      skip_line();
    }
  }

 private:
  bool at_end() const { return token_.text.empty(); }

  bool is(std::string_view word) const {
    if (token_.text.size() != word.size()) return false;
    for (std::size_t k = 0; k < word.size(); ++k)
      if (std::tolower(static_cast<unsigned char>(token_.text[k])) != word[k]) return false;
    return true;
  }

  // "{}" in the text becomes the token that was found.
  void fail(std::string what) {
    const std::size_t hole = what.find("{}");
    if (hole != std::string::npos) what.replace(hole, 2, token_.shown());
    errors_.add(token_.place(), what);
  }

  void step() {
    if (text_[at_] == '\n') {
      ++line_;
      column_ = 0;
    }
    ++column_;
    ++at_;
  }

  static bool blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

  void advance() {
    while (at_ < text_.size() && blank(text_[at_])) step();
    token_ = {{}, line_, column_};
    const std::size_t begin = at_;
    while (at_ < text_.size() && !blank(text_[at_])) step();
    token_.text = text_.substr(begin, at_ - begin);
  }

  // The rest of a "solid" line is a name.
  void skip_line() {
    while (at_ < text_.size() && text_[at_] != '\n') step();
    advance();
  }

  // After a mistake: to the next facet, so that one mistake gives one message.
  void resume() {
    if (is("facet")) advance();
    while (!at_end() && !is("facet") && !is("endsolid")) advance();
  }

  bool expect(std::string_view word) {
    if (!is(word)) {
      if (at_end())
        fail(fmt::format("the file ends inside a facet, where '{}' should stand: is it cut off?",
                         word));
      else
        fail(fmt::format("expected '{}', found {{}}", word));
      return false;
    }
    advance();
    return true;
  }

  bool read_number(double& value, bool must_be_finite) {
    std::string_view digits = token_.text;
    if (digits.starts_with('+')) digits.remove_prefix(1);
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    const bool whole = error == std::errc() && end == digits.data() + digits.size();
    if (at_end())
      fail("the file ends inside a facet, where a number should stand: is it cut off?");
    else if (!whole && digits.find(',') != std::string_view::npos)
      fail("{} has a comma: decimals need a point, numbers a space between them");
    else if (!whole)
      fail("expected a number, found {}");
    else if (must_be_finite && !std::isfinite(value))
      fail("{} is not a finite number");
    else
      return advance(), true;
    return false;
  }

  bool read_three(Vec3& v, bool must_be_finite) {
    for (Eigen::Index k = 0; k < 3; ++k)
      if (!read_number(v[k], must_be_finite)) return false;
    return true;
  }

  bool read_facet() {
    Vec3 normal;
    Triangle triangle;
    if (!expect("facet") || !expect("normal") || !read_three(normal, false) || !expect("outer") ||
        !expect("loop"))
      return false;
    for (Vec3& corner : triangle.corner) {
      if (!expect("vertex") || !read_three(corner, true)) return false;
      corner *= scale_;
    }
    if (is("vertex")) {
      fail("a facet must be a triangle, this one has more than 3 corners");
      return false;
    }
    if (!expect("endloop") || !expect("endfacet")) return false;
    out_.push_back(triangle);
    return true;
  }

  std::string_view text_;
  double scale_;
  std::vector<Triangle>& out_;
  Errors& errors_;
  std::size_t at_ = 0;
  int line_ = 1, column_ = 1;
  Token token_;
};

bool looks_like_text(const std::string& bytes) {
  for (const char c : bytes.substr(0, 1000))
    if (static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\r' && c != '\t') return false;
  return true;
}

void explain_size(const std::string& bytes, Errors& errors) {
  if (bytes.size() < kHeader)
    return errors.add("", fmt::format("no STL file: {} bytes are too few for a binary one, and an "
                                      "ASCII one begins with 'solid'",
                                      bytes.size()));
  const std::uint64_t count = little_endian(&bytes[kHeader - 4]);
  errors.add("", fmt::format("as binary STL it announces {} triangles, {} bytes, but the file has "
                             "{} bytes: cut off, or no STL file",
                             count, kHeader + kRecord * count, bytes.size()));
}

bool read_bytes(const std::string& path, std::string& bytes, Errors& errors) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    errors.add("", "cannot read the mesh: it is a folder");
    return false;
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    errors.add("", fmt::format("cannot read the mesh: {}", std::strerror(errno)));
    return false;
  }
  std::ostringstream all;
  all << file.rdbuf();
  bytes = std::move(all).str();
  if (bytes.empty()) errors.add("", "the file is empty");
  return !bytes.empty();
}

bool is_binary(const std::string& bytes) {
  return bytes.size() >= kHeader &&
         bytes.size() == kHeader + kRecord * std::uint64_t{little_endian(&bytes[kHeader - 4])};
}

}  // namespace

MeshResult read_stl(const std::string& path, double scale) {
  MeshResult result;
  Errors errors(path, result.errors);
  std::string bytes;
  if (!std::isfinite(scale) || scale <= 0)
    errors.add("", fmt::format("the scale of a mesh must be greater than 0, found {}", scale));
  else if (!read_bytes(path, bytes, errors))
    return result;
  else if (is_binary(bytes))
    read_binary(bytes, scale, result.triangles, errors);
  else if (looks_like_text(bytes) && bytes.size() >= 5)
    AsciiReader(bytes, scale, result.triangles, errors).read();
  else
    explain_size(bytes, errors);
  if (result.errors.empty() && result.triangles.empty())
    errors.add("", "the mesh has no triangles");
  errors.close();
  if (!result.errors.empty()) result.triangles.clear();
  return result;
}

}  // namespace quern
