// What a report page carries inside itself: bytes as gzip in base64, texts as JSON strings.
//
// The browser turns them back with atob and DecompressionStream. No time stamp and no file name go
// into the gzip: the same bytes give the same text.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace quern {

// Characters A-Z a-z 0-9 + / = only: nothing that could end a script element.
std::string packed(std::span<const std::uint8_t> bytes);
std::string packed(std::string_view text);

std::string base64(std::span<const std::uint8_t> bytes);

// A JSON string in its quotes; valid in a script element too, as '<' is written as an escape.
std::string json_string(std::string_view text);
// Seven digits; null for what JSON lacks (NaN, infinity).
std::string json_number(double value);

// For text between tags and in quoted attributes.
std::string html_text(std::string_view text);

}  // namespace quern
