#pragma once
// A sheet with a picture of the cell at the end of each move: armlet run FILE --storyboard FILE.png

#include <cstdint>
#include <string>
#include <vector>

#include "armlet/cell/overview.hpp"
#include "armlet/stdlib/host.hpp"
#include "output_file.hpp"

namespace armlet::cli {

inline constexpr int kPictureWidth = 480, kPictureHeight = 360;  // pixels of one picture

class Storyboard {
 public:
  // The exit status, after a message if this is no name of a picture; empty: none is wanted.
  int choose(const std::string& path);
  [[nodiscard]] bool is_wanted() const { return file_.is_wanted(); }
  // As OutputFile does.
  int open(const std::vector<std::string>& texts);
  // Keeps the cell as it is at the end of a move. Of more moves than a sheet has room for, every
  // second, fourth ... one is kept.
  void take(const MoveReport& move, const Cell& cell);
  // Draws the sheet. The exit status, and a message if it cannot be written or shows a part of the
  // moves.
  int finish();

 private:
  struct Frame {
    std::string label;
    Scene scene;
  };
  [[nodiscard]] Image sheet() const;

  OutputFile file_{"storyboard"};
  Cameras cameras_;  // keeps the surfaces of what is drawn
  std::vector<Frame> frames_;
  Overview view_{kPictureWidth, kPictureHeight};  // of all that is to be seen
  std::uint64_t moves_ = 0;
  std::uint64_t each_ = 1;  // of so many moves one is kept
};

}  // namespace armlet::cli
