#pragma once
// A sheet with a picture of the cell at the end of each move: armlet run FILE --storyboard FILE.png

#include <cstdint>
#include <string>
#include <vector>

#include "armlet/cell/overview.hpp"
#include "armlet/stdlib/host.hpp"
#include "console/output_file.hpp"

namespace armlet::cli {

inline constexpr int kPictureWidth = 480, kPictureHeight = 360;  // pixels of one picture

class Storyboard {
 public:
  // Returns the exit status, after a message if this is no name of a picture; empty: no storyboard.
  int choose(const std::string& path);
  [[nodiscard]] bool is_wanted() const { return file_.is_wanted(); }
  // Called once it is known that the program runs. The texts are files that the picture must not
  // overwrite. Returns the exit status, after a message if the picture cannot be written.
  int open(const std::vector<std::string>& texts);
  // Stores the state of the cell at the end of a move. If there are more moves than a sheet can
  // show, every second, fourth ... one is stored.
  void take(const FinishedMove& move, const Cell& cell);
  // Draws the sheet. Returns the exit status, after a message if it cannot be written or shows only
  // a part of the moves.
  int finish();

 private:
  struct Frame {
    std::string label;
    Scene scene;
  };
  [[nodiscard]] Image sheet() const;

  OutputFile file_{"storyboard"};
  Cameras cameras_;  // caches the surfaces of drawn bodies
  std::vector<Frame> frames_;
  Overview view_{kPictureWidth, kPictureHeight};  // of the whole cell
  std::uint64_t moves_ = 0;
  std::uint64_t each_ = 1;  // one of this number of moves is stored
};

}  // namespace armlet::cli
