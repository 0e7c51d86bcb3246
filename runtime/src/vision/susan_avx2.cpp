#include <cstring>

#include "vision/susan_rows.hpp"

// Processes 32 pixels at once. A table of 256 similarities does not fit into a register, but only
// differences between the last one of similarity 100 and the first one of similarity 0 need it:
// these are looked up in pieces of 16 with vpshufb, which gives 0 where the highest bit of an index
// is set.

namespace armlet {
namespace {

using Bytes = unsigned char __attribute__((vector_size(32)));
using Words = short __attribute__((vector_size(32)));
using Long = long long __attribute__((vector_size(32)));
using Chars = char __attribute__((vector_size(32)));

constexpr int kLanes = 32;
constexpr int kMostPieces = 16;

struct Pieces {
  Chars entries[kMostPieces];
  Bytes last_alike;
  int count;
};

// Areas of the even and of the odd pixels.
struct Areas {
  Words even;
  Words odd;
};

Pieces pieces_of(const SusanTable& table) {
  Pieces pieces;
  pieces.last_alike = Bytes{} + static_cast<unsigned char>(table.last_alike);
  pieces.count = (table.steps + 15) / 16;
  for (int piece = 0; piece < pieces.count; ++piece) {
    char entries[kLanes];
    for (int i = 0; i < 16; ++i) {
      const int difference = table.last_alike + 16 * piece + i;
      entries[i] = static_cast<char>(difference < 256 ? table.similarity[difference] : 0);
      entries[i + 16] = entries[i];
    }
    std::memcpy(&pieces.entries[piece], entries, kLanes);
  }
  return pieces;
}

inline Bytes load(const std::uint8_t* pixels) {
  Bytes bytes;
  std::memcpy(&bytes, pixels, kLanes);
  return bytes;
}

inline Bytes larger(Bytes a, Bytes b) { return a > b ? a : b; }
inline Bytes smaller(Bytes a, Bytes b) { return a < b ? a : b; }

// kPieces is the number of pieces if it is known at compile time, else 0.
template <int kPieces>
inline Bytes similarity(Bytes a, Bytes b, const Pieces& pieces) {
  const Bytes difference = larger(a, b) - smaller(a, b);
  Bytes step = larger(difference, pieces.last_alike) - pieces.last_alike;
  const int count = kPieces == 0 ? pieces.count : kPieces;
  Bytes sum{};
  for (int piece = 0; piece < count; ++piece) {
    // 0 to 15 become 112 to 127; all larger ones, also after overflow, have the highest bit set.
    const Bytes index = smaller(step, Bytes{} + 0x8f) + 0x70;
    sum |= (Bytes)__builtin_ia32_pshufb256(pieces.entries[piece], (Chars)index);
    step -= 16;
  }
  return sum;
}

inline void add(Areas& areas, Bytes similarities) {
  areas.even += (Words)similarities & 0xff;
  areas.odd += (Words)((Words)similarities >> 8) & 0xff;
}

inline bool has_candidate(const Areas& areas) {
  const Long below = (Long)((areas.even < kSusanLimit) | (areas.odd < kSusanLimit));
  return (below[0] | below[1] | below[2] | below[3]) != 0;
}

// Adds the pixels x = -half ... half of the rows above and below, without the nucleus.
template <int kPieces>
inline void add_rows(Areas& areas, const std::uint8_t* nucleus, std::ptrdiff_t row, int half,
                     const Pieces& pieces) {
  const Bytes centre = load(nucleus);
  for (int x = -half; x <= half; ++x) {
    // The sum of two similarities fits into a byte.
    add(areas, similarity<kPieces>(centre, load(nucleus + row + x), pieces) +
                   similarity<kPieces>(centre, load(nucleus - row + x), pieces));
  }
}

template <int kPieces>
Areas areas_of(const std::uint8_t* nucleus, std::ptrdiff_t stride, const Pieces& pieces) {
  Areas areas{Words{} + 100, Words{} + 100};
  const Bytes centre = load(nucleus);
  for (int x = 1; x <= 3; ++x) {
    add(areas, similarity<kPieces>(centre, load(nucleus + x), pieces) +
                   similarity<kPieces>(centre, load(nucleus - x), pieces));
  }
  add_rows<kPieces>(areas, nucleus, stride, 3, pieces);
  if (!has_candidate(areas)) return areas;
  add_rows<kPieces>(areas, nucleus, 2 * stride, 2, pieces);
  if (!has_candidate(areas)) return areas;
  add_rows<kPieces>(areas, nucleus, 3 * stride, 1, pieces);
  return areas;
}

void store(const Areas& areas, std::uint16_t* out) {
  std::uint16_t even[kLanes / 2];
  std::uint16_t odd[kLanes / 2];
  std::memcpy(even, &areas.even, sizeof even);
  std::memcpy(odd, &areas.odd, sizeof odd);
  for (int i = 0; i < kLanes / 2; ++i) {
    out[2 * i] = even[i];
    out[2 * i + 1] = odd[i];
  }
}

template <int kPieces>
void compute_row(const std::uint8_t* nucleus, std::ptrdiff_t stride, int count,
                 const Pieces& pieces, std::uint16_t* areas) {
  for (int x = 0; x < count; x += kLanes) {
    // The last block overlaps the one before, so that no pixel after the row is read.
    const int first = x + kLanes <= count ? x : count - kLanes;
    store(areas_of<kPieces>(nucleus + first, stride, pieces), areas + first);
  }
}

}  // namespace

void susan_row_avx2(const std::uint8_t* nucleus, std::ptrdiff_t stride, int count,
                    const SusanTable& table, std::uint16_t* areas) {
  if (count < kLanes) return susan_row_scalar(nucleus, stride, count, table, areas);
  const Pieces pieces = pieces_of(table);
  if (pieces.count == 1) return compute_row<1>(nucleus, stride, count, pieces, areas);
  if (pieces.count == 2) return compute_row<2>(nucleus, stride, count, pieces, areas);
  if (pieces.count == 3) return compute_row<3>(nucleus, stride, count, pieces, areas);
  compute_row<0>(nucleus, stride, count, pieces, areas);
}

}  // namespace armlet
