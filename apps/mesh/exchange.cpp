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

}  // namespace armlet::mesh
