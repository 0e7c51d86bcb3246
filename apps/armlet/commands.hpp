#pragma once
// The sub-commands of armlet. Each returns the exit status of the process (language reference,
// section 22).

#include <cstdint>
#include <string>
#include <vector>

namespace armlet::cli {

enum Exit : int {
  kDone = 0,
  kUnformatted = 1,
  kUsage = 64,
  kRejected = 65,
  kNoFile = 66,
  kFailed = 70,
  kStopped = 130
};

// The options that run, check and test share.
struct ProgramOptions {
  std::string robot = "scara";  // a name of the catalogue
  std::string world;  // a .rbt file; empty: the command's default world, if the program needs one
  std::uint64_t steps = 10'000'000'000;
  bool json = false;
  std::vector<std::string> packages;  // NAME=DIR
};

struct RunOptions {
  ProgramOptions program;
  std::string file;
  std::string trace;                 // a file with the extension of a trace format; empty: none
  std::vector<std::string> cameras;  // NAME=FOLDER of recorded pictures
  std::string frames;                // folder for the pictures that cameras take; empty: none
  bool realtime = false;
  bool quiet = false;      // no progress, no summary
  bool plots = false;      // draw the figures in the terminal
  bool hash = false;       // print the hash of the run
  std::string storyboard;  // a .png file; empty: none
  std::string video;       // an .mp4 or .mkv file, or a folder for its pictures; empty: none
  std::string record;      // the file for the log of the session; empty: none
  std::string inputs;      // input script of a laboratory without a page; empty: no laboratory
};

struct ReplayOptions {
  std::string file;     // a log
  std::string to;       // a virtual time to go to, "3.2s"; empty: to the end
  bool verify = false;  // compare with the recorded run
  bool json = false;
  bool quiet = false;
};

struct EditorOptions {
  ProgramOptions program;
  std::string file;
  std::string position;  // LINE:COLUMN, counted from 1, columns in characters
};

struct FormatOptions {
  std::vector<std::string> files;  // "-" is standard input
  bool check = false;              // name the files that would change, change nothing
  bool json = false;
};

struct RobotOptions {
  std::string name;  // of the catalogue, or a .urdf file; empty: list the catalogue
  std::string tip;   // last link of the arm in a file; empty: the end of its only chain
  bool json = false;
  bool urdf = false;                  // write a URDF
  bool block = false;                 // write a robot block
  bool glb = false;                   // write its shapes as GLB
  std::string glb_file;               // to this file; empty: to standard output
  bool published = false;             // keep inertias that no rigid body can have
  std::vector<std::string> packages;  // NAME=DIR
};

struct MeshOptions {
  std::string from;  // a mesh of any supported format
  std::string to;    // a .glb file
  std::string unit;  // length of a unit of the file, "1mm"; empty: as the format says, else metres
  std::string up;    // the axis that points up, y or z; empty: as the format says
  bool quiet = false;
};

// name  a page, or words to look for; empty: all names are listed.
struct HelpQuestion {
  std::string name;
  bool markdown = false;   // the whole reference
  bool whole = false;      // all forms of a page, all pages that are found
  bool is_search = false;  // pages about the words, one line each, also if one has that name
  bool at_prompt = false;  // the hints are for the prompt
};

struct PromptOptions {
  ProgramOptions program;
  std::string record;  // the file for the log of the session; empty: none
};

inline constexpr const char* kLabHelp = "show a program, and what it does, in a browser";

// The prompt: runs lines from standard input until its end.
int prompt(const PromptOptions& options);
int run(const RunOptions& options);
int replay(const ReplayOptions& options);
int check(const ProgramOptions& options, const std::vector<std::string>& files);
int test(const ProgramOptions& options, const std::vector<std::string>& files);
int disasm(const ProgramOptions& options, const std::string& file);
int format(const FormatOptions& options);
int complete(const EditorOptions& options);
int hover(const EditorOptions& options);
int explain(const std::string& code);
int robot(const RobotOptions& options);
int convert_mesh(const MeshOptions& options);
int help(const HelpQuestion& asked);
int lists();

}  // namespace armlet::cli
