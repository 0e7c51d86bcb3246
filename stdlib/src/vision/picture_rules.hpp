#pragma once
// Kinds of pictures that are known from the text; they decide the type of elements.

#include "armlet/image/image.hpp"
#include "armlet/interpreter/native.hpp"

namespace armlet::bind {

// Notes the kind of the result: elements of a grey picture are whole numbers, those of depths are
// lengths, all others are colours.
void note_kind(CheckCall& call, PixelKind kind);
template <PixelKind kKind>
void gives_kind(CheckCall& call) {
  note_kind(call, kKind);
}
// The result has the kind of argument kName, if that is known.
void note_same_kind(CheckCall& call, CallPart part);
template <ParameterName kName>
void gives_same_kind(CheckCall& call) {
  note_same_kind(call, kPart<kName>);
}

}  // namespace armlet::bind
