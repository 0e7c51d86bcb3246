// PNG files with fixed Huffman codes and runs of one byte.

#include "armlet/image/plain_png.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <utility>

#include "armlet/core/checkpoint.hpp"
#include "armlet/image/check_kind.hpp"

namespace armlet {
namespace {

constexpr std::size_t kBlock = 1U << 16U;  // bytes between two checkpoints

void append_word(std::string& out, std::uint32_t word) {
  for (int shift = 24; shift >= 0; shift -= 8) out += static_cast<char>(word >> shift & 0xffU);
}

// The CRC remainders of all bytes (PNG, annex D).
constexpr std::array<std::uint32_t, 256> kRemainders = [] {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t n = 0; n < 256; ++n) {
    std::uint32_t word = n;
    for (int k = 0; k < 8; ++k) word = (word & 1U) != 0 ? 0xedb88320U ^ (word >> 1U) : word >> 1U;
    table[n] = word;
  }
  return table;
}();

std::uint32_t crc(std::string_view bytes) {
  std::uint32_t word = 0xffffffffU;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    if (i % kBlock == 0) checkpoint(2 * kBlock);
    word = kRemainders[(word ^ static_cast<std::uint8_t>(bytes[i])) & 0xffU] ^ (word >> 8U);
  }
  return ~word;
}

std::uint32_t adler(std::string_view bytes) {
  constexpr std::uint32_t kBase = 65521;
  std::uint32_t a = 1, b = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    if (i % kBlock == 0) checkpoint(2 * kBlock);
    a = (a + static_cast<std::uint8_t>(bytes[i])) % kBase;
    b = (b + a) % kBase;
  }
  return b << 16U | a;
}

void append_chunk(std::string& out, std::string_view kind, std::string_view data) {
  append_word(out, static_cast<std::uint32_t>(data.size()));
  std::string chunk(kind);
  chunk += data;
  out += chunk;
  append_word(out, crc(chunk));
}

// The fixed codes of RFC 1951, 3.2.6.
class FixedCodes {
 public:
  void literal(std::uint8_t byte) {
    byte < 144 ? code(0x30U + byte, 8) : code(0x190U + byte - 144U, 9);
  }
  // Repeats the last byte `length` times: 3 to 258.
  void run(unsigned length) {
    if (length == 258) {
      symbol(285);
    } else if (length < 7) {
      symbol(254 + length);
    } else {
      const unsigned more = length - 3;
      const unsigned extra = static_cast<unsigned>(std::bit_width(more)) - 3;
      symbol(257 + 4 * (extra + 1) + (more >> extra & 3U));
      bits(more & ((1U << extra) - 1U), extra);
    }
    code(0, 5);  // a distance of 1
  }
  void bits(unsigned value, unsigned count) {
    word_ |= std::uint64_t{value} << count_;
    for (count_ += count; count_ >= 8; count_ -= 8, word_ >>= 8U)
      out_ += static_cast<char>(word_ & 0xffU);
  }
  void symbol(unsigned value) {
    value < 280 ? code(value - 256U, 7) : code(0xc0U + value - 280U, 8);
  }
  std::string take() {
    if (count_ > 0) bits(0, 8 - count_);
    return std::move(out_);
  }

 private:
  // Huffman codes are written from their highest bit.
  void code(unsigned value, unsigned count) {
    unsigned turned = 0;
    for (unsigned k = 0; k < count; ++k) turned |= (value >> k & 1U) << (count - 1 - k);
    bits(turned, count);
  }

  std::string out_;
  std::uint64_t word_ = 0;
  unsigned count_ = 0;
};

std::string compressed(std::string_view bytes) {
  FixedCodes codes;
  codes.bits(1, 1);  // the last block
  codes.bits(1, 2);  // with fixed codes
  std::size_t looked = 0;
  for (std::size_t i = 0; i < bytes.size();) {
    if (i >= looked) {
      checkpoint(8 * kBlock);
      looked = i + kBlock;
    }
    unsigned run = 0;
    while (i > 0 && run < 258 && i + run < bytes.size() && bytes[i + run] == bytes[i - 1]) ++run;
    if (run >= 3) {
      codes.run(run);
      i += run;
    } else {
      codes.literal(static_cast<std::uint8_t>(bytes[i++]));
    }
  }
  codes.symbol(256);
  return codes.take();
}

// Filters each row: differences from the row above or from the pixels on the left, whichever are
// smaller.
std::string filtered(const Image& image) {
  const auto step = static_cast<std::size_t>(image.channels());
  const std::size_t size = static_cast<std::size_t>(image.width()) * step;
  const std::string nothing(size, '\0');
  std::string out;
  std::array<std::string, 2> rows;
  for (int y = 0; y < image.height(); ++y) {
    checkpoint(4 * size);
    const std::uint8_t* now = image.row(y);
    const std::uint8_t* above =
        y > 0 ? image.row(y - 1) : reinterpret_cast<const std::uint8_t*>(nothing.data());
    std::array<std::uint64_t, 2> sums{};
    for (std::size_t kind = 0; kind < 2; ++kind) {
      std::string& row = rows[kind];
      row.assign(1, static_cast<char>(kind + 1));
      for (std::size_t i = 0; i < size; ++i) {
        const int before = kind == 1 ? above[i] : i < step ? 0 : now[i - step];
        const auto difference = static_cast<std::int8_t>(now[i] - before);
        sums[kind] += static_cast<std::uint64_t>(std::abs(int{difference}));
        row += static_cast<char>(difference);
      }
    }
    out += rows[sums[1] < sums[0] ? 1 : 0];
  }
  return out;
}

}  // namespace

std::string plain_png(const Image& image) {
  check_8_bit("plain_png", image);
  std::string head;
  append_word(head, static_cast<std::uint32_t>(image.width()));
  append_word(head, static_cast<std::uint32_t>(image.height()));
  head += '\x08';                                 // bits of a value
  head += image.channels() == 3 ? '\x02' : '\0';  // RGB or grey
  head.append(3, '\0');
  const std::string rows = filtered(image);
  std::string data = "\x78\x01" + compressed(rows);
  append_word(data, adler(rows));
  std::string out = "\x89PNG\r\n\x1a\n";
  append_chunk(out, "IHDR", head);
  append_chunk(out, "IDAT", data);
  append_chunk(out, "IEND", {});
  return out;
}

}  // namespace armlet
