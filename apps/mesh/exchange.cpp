#include "exchange.hpp"

namespace armlet::mesh {

std::string say_header(Say what, std::size_t length) {
  std::string header(1, static_cast<char>(what));
  for (int k = 0; k < 4; ++k) header += static_cast<char>((length >> (8 * k)) & 0xffU);
  return header;
}

std::size_t said_length(const char* header) {
  std::size_t length = 0;
  for (std::size_t k = 4; k-- > 0;)
    length = length << 8 | static_cast<unsigned char>(header[1 + k]);
  return length;
}

std::string shown_text(std::string_view text) {
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    const auto byte = static_cast<unsigned char>(text[at]);
    const std::size_t length = byte < 0x80                    ? 1
                               : byte >= 0xc2 && byte <= 0xdf ? 2
                               : byte >= 0xe1 && byte <= 0xec ? 3
                                                              : 0;
    bool whole = length > 0 && at + length <= text.size();
    for (std::size_t k = 1; whole && k < length; ++k)
      whole = (static_cast<unsigned char>(text[at + k]) & 0xc0U) == 0x80;
    if (!whole) {
      out += '?';
      ++at;
    } else if (byte < ' ' || byte == 0x7f) {
      out += ' ';
      ++at;
    } else {
      out += text.substr(at, length);
      at += length;
    }
  }
  return out;
}

}  // namespace armlet::mesh
