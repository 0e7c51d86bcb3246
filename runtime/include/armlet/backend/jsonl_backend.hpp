#pragma once

#include <iosfwd>
#include <memory>

#include "armlet/backend/backend.hpp"

namespace armlet {

// A backend that writes a run as one JSON object per line; numbers read back to the same bits.
//
//   {"what":"begin","robots":[{"name":"arm","joints":["rad","m"]}]}
//   {"t":0.000000000,"what":"added","name":"cube","shape":"box","size":[...],"mass":0.2,
//    "color":"red","p":[x,y,z],"r":[w,x,y,z]}
//   {"t":0.010000000,"what":"robot","name":"arm","q":[...],"qd":[...],"qdd":[...],"p":..,"r":..}
//   {"t":..,"what":"object","name":"cube","p":..,"r":..}
//   {"t":..,"what":"attached","name":"cube","robot":"arm"}          (also detached, removed)
//   {"t":..,"what":"output","text":"..."}                           (also message, advice)
//   {"t":..,"what":"figure","title":"...","x":"s","y":"rad","z":"","right":"","series":
//    [{"kind":"line","label":"...","axis":"left","x":[...],"y":[...],"z":[]}]}    (units of SI;
//    null: no number; with logarithmic axes "log":"y", with names below bars "names":["a","b"], in
//    panels "panels":[{"title":"...","x":..., "series":[...]}])
//   {"t":..,"what":"robotAdded","name":"late","joints":["rad"]}
//   {"t":..,"what":"end"}
//
// A robot's p and r are those of its tool point in the world; r is a unit quaternion.
//
// out  not owned; lives at least as long as the backend.
[[nodiscard]] std::unique_ptr<Backend> make_jsonl_backend(std::ostream& out);

}  // namespace armlet
