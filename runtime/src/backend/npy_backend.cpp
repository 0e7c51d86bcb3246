#include "armlet/backend/npy_backend.hpp"

#include <bit>
#include <limits>

#include "backend/joint_columns.hpp"
#include "backend/text_sink.hpp"

namespace armlet {
namespace {

// The magic bytes, the version, the length of the text that follows (least significant byte first),
// and that text: a literal of Python, padded with blanks, so that the numbers begin at a multiple
// of 64 bytes.
//
// rows  does not change the length of the header, which is written again at the end of the run.
std::string npy_header(std::size_t joints, std::uint64_t rows) {
  constexpr std::size_t kFirst = 10, kAlignment = 64;
  constexpr std::size_t kFieldDigits = std::numeric_limits<std::uint64_t>::digits10 + 1;
  const std::string number = fmt::format("{}", rows);
  std::string text = fmt::format(
      "{{'descr': [('t', '<f8'), ('robot', '<i8'), ('p', '<f8', (3,)), ('r', '<f8', (4,)), "
      "('q', '<f8', ({0},)), ('qd', '<f8', ({0},)), ('qdd', '<f8', ({0},))], "
      "'fortran_order': False, 'shape': ({1},), }}",
      joints, number);
  const std::size_t longest = kFirst + text.size() - number.size() + kFieldDigits + 1;
  const std::size_t whole = (longest + kAlignment - 1) / kAlignment * kAlignment;
  text.resize(whole - kFirst - 1, ' ');
  const auto low = static_cast<char>((text.size() + 1) & 0xff);
  const auto high = static_cast<char>((text.size() + 1) >> 8);
  return std::string("\x93NUMPY\x01\x00", 8) + low + high + text + '\n';
}

class NpyBackend final : public Backend {
 public:
  explicit NpyBackend(std::ostream& out) : sink_(out) {}

  void on(const Event& event) override {
    std::visit(Overload{[this](const auto& each) { add(each); }, kIgnored}, event);
  }
  [[nodiscard]] EventKinds ignores() const override { return kIgnored.kinds(); }

  [[nodiscard]] std::string error() const override {
    return sink_.error().empty() ? columns_.error() : sink_.error();
  }

 private:
  // A row cannot be marked as undone. Where the time goes back, the rows before it are undone.
  static constexpr Ignore<RobotChanged, ObjectAdded, ObjectSample, ObjectEvent, Note, FigureChanged,
                          FinalFigure, Undone, DrawingChanged, CameraAdded, ImageFrame>
      kIgnored{};

  void add(const BeginRun& begin) {
    columns_.begin(begin.run);
    sink_.text(npy_header(columns_.count(), 0));
  }

  void add(const RobotAdded& added) { columns_.add(added.robot); }

  void add(const JointSample& sample) {
    if (!columns_.hold(sample)) return;
    write(static_cast<double>(sample.t_ns) / 1e9);
    write(static_cast<std::uint64_t>(sample.robot));
    const Eigen::Vector3d p = sample.T_world_tool.translation();
    const Eigen::Quaterniond r = positive_quaternion(sample.T_world_tool);
    for (const double value : {p.x(), p.y(), p.z(), r.w(), r.x(), r.y(), r.z()}) write(value);
    for (const auto values : {sample.q, sample.qd, sample.qdd}) write_joints(values);
    sink_.flush_if_much();
    ++rows_;
  }

  void add(const EndRun&) { sink_.replace_beginning(npy_header(columns_.count(), rows_)); }

  void write(std::uint64_t bits) {
    char bytes[sizeof bits];
    for (char& byte : bytes) {
      byte = static_cast<char>(bits & 0xff);
      bits >>= 8;
    }
    sink_.text({bytes, sizeof bytes});
  }
  void write(double value) { write(std::bit_cast<std::uint64_t>(value)); }

  void write_joints(std::span<const double> values) {
    for (const double value : values) write(value);
    for (std::size_t i = values.size(); i < columns_.count(); ++i)
      write(std::numeric_limits<double>::quiet_NaN());
  }

  TextSink sink_;
  JointColumns columns_;
  std::uint64_t rows_ = 0;
};

}  // namespace

std::unique_ptr<Backend> make_npy_backend(std::ostream& out) {
  return std::make_unique<NpyBackend>(out);
}

}  // namespace armlet
