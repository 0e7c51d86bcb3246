#pragma once

#include <iosfwd>
#include <memory>

#include "armlet/backend/backend.hpp"

namespace armlet {

// A backend that writes a run as one JSON object per line; numbers read back to the same bits.
//
//   {"what":"begin","robots":[{"name":"arm","joints":["rad","m"],"links":[{"before":[..],
//    "after":[..],"limits":[-2,2],"speed":3.1,"mesh":"upper_arm.stl"},..],"home":[..],"base":[..],
//    "tool":{"kind":"gripper","pose":[..],"stroke":0.1,"radius":0,"length":0.12}}]}
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
//   {"t":..,"what":"robotAdded","name":"late","joints":["rad"],..}  (as at the beginning)
//   {"t":..,"what":"robotChanged","name":"arm",..}                  (its tool or its base)
//   {"t":..,"what":"frame","camera":"eye","number":0,"size":[640,480,3],"hash":"16 digits",
//    "file":"frames/eye-000000.png","p":..,"r":..}                  (a picture; file if written)
//   {"t":..,"what":"cameraAdded","name":"eye","size":[640,480],"K":[fx,fy,cx,cy],"distortion":[..],
//    "range":[0.01,20],"rate":25,"robot":"arm","link":-1,"on":[..]}   (or "object", "frame")
//   {"t":..,"what":"undone","line":17,"back":1.5}                   (or redone: see below)
//   {"t":..,"what":"end"}
//
// Cameras of the beginning are in "cameras" after "robots". The hash is FNV-1a of the bytes of the
// pixels; "on" is the pose of the camera on what carries it, link -1 the flange. A robot's p and r
// are those of its tool point in the world; r is a unit quaternion. The number "on" before "base"
// is only written for a hand with fingers: the robot whose flange carries it and in whose frame
// "base" is. before, after, base and pose are p and r in one list of seven numbers; with them the
// arm can be drawn: see JointInfo and ToolInfo (event.hpp). A limit that does not exist is null,
// and a link without a file of its shape has no mesh. With mimic joints there are more links than
// joints, and each has "joint":0,"ratio":1,"offset":0: see RowInfo. "undone" marks the lines of the
// file from `line` (from 1) up to itself as undone, and time continues at `back`; "redone" says
// that the lines that were undone last count again up to `back`.
//
// out  not owned; lives at least as long as the backend.
[[nodiscard]] std::unique_ptr<Backend> make_jsonl_backend(std::ostream& out);

}  // namespace armlet
