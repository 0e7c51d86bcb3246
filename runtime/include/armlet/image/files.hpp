#pragma once
// Encoding and decoding of picture files. No function here opens a file: core/files.hpp reads and
// writes the bytes.

#include <string>
#include <string_view>

#include "armlet/core/error.hpp"
#include "armlet/image/image.hpp"

namespace armlet {

// Decodes a PNG, JPEG, PGM or PPM file. The first bytes determine the format.
//
// PNG    grey, RGB and palettes of 1 to 16 bits, interlaced or not. 16 bits become 8 by the high
//        byte. Pixels that are partly transparent are laid over white.
// JPEG   baseline and progressive, 8 bits; CMYK becomes RGB. The orientation tag is ignored.
// PGM, PPM  text and binary (P2, P3, P5, P6); scaled to 0 ... 255 where their largest value
//        differs.
//
// returns  a grey picture for one channel, else RGB, with sides up to Image::kMostSide; or an error
//          with the code "picture" whose message is a sentence with the position and the numbers.
//          Memory is allocated only if the file is long enough for the pixels.
//
// WebAssembly has no codecs: read_image returns such an error, and the others throw ArgumentError.
[[nodiscard]] Result<Image> read_image(std::string_view bytes);

// The bytes of a PNG file, by libpng. Reading them gives the same picture.
//
// image    grey or RGB.
// throws   ArgumentError for a picture of depths or without pixels.
[[nodiscard]] std::string write_png(const Image& image);

// The bytes of a baseline JPEG file; the same on every machine. It always has three channels, so
// that a grey picture is read back as RGB.
//
// quality  1 to 100.
// throws   ArgumentError as write_png does, or for a quality out of range.
[[nodiscard]] std::string write_jpeg(const Image& image, int quality = 90);

// The bytes of a binary PGM file for a grey picture, or PPM for RGB. Reading them gives the same
// picture.
//
// throws   ArgumentError as write_png does.
[[nodiscard]] std::string write_netpbm(const Image& image);

}  // namespace armlet
