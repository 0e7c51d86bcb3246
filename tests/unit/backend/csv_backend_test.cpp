#include "armlet/backend/csv_backend.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <sstream>

#include "run.hpp"

using namespace armlet;

TEST_CASE("a run is one table with as many columns in every row") {
  std::ostringstream out;
  const std::unique_ptr<Backend> backend = make_csv_backend(out);
  play_short_run(*backend);
  CHECK(backend->error().empty());
  CHECK(out.str() ==
        "t [s],what,name,x [m],y [m],z [m],qw,qx,qy,qz,q1 [rad],q2 [m],qd1 [rad/s],qd2 [m/s],"
        "qdd1 [rad/s^2],qdd2 [m/s^2],text\n"
        "0.000000000,object,cube,0,0,0,1,0,0,0,,,,,,,\n"
        "0.010000000,robot,arm,1,2,3,1,0,0,0,0.1,0,0.333333333,2.5,-1e-20,4,\n"
        "0.010000000,attached,cube,,,,,,,,,,,,,,left\n"
        "0.020000001,object,cube,0,0,0,1,0,0,0,,,,,,,\n"
        "0.020000001,object,ball,0,0,0,1,0,0,0,,,,,,,\n"
        "0.030000000,removed,ball,,,,,,,,,,,,,,\n"
        "0.030000000,output,,,,,,,,,,,,,,,\"say \"\"hi\"\",\n now\"\n"
        "0.030000000,advice,,,,,,,,,,,,,,,slower\n"
        "3.000000000,end,,,,,,,,,,,,,,,\n");
}

TEST_CASE("a robot with fewer joints leaves its last cells empty") {
  std::ostringstream out;
  const std::unique_ptr<Backend> backend = make_csv_backend(out);
  backend->on(BeginRun{.run = {.robots = {{"arm", {{JointUnit::kRadian}, {JointUnit::kMetre}}},
                                          {"left", {{JointUnit::kRadian}}}},
                               .objects = {}}});
  const double one = 1.0;
  const std::span<const double> q(&one, 1);
  backend->on(JointSample{.robot = 1, .q = q, .qd = q, .qdd = q});
  backend->on(EndRun{});
  CHECK(out.str().find("0.000000000,robot,left,0,0,0,1,0,0,0,1,,1,,1,,\n") != std::string::npos);
}

TEST_CASE("a column has a unit where all robots have the same in it") {
  std::ostringstream out;
  const std::unique_ptr<Backend> backend = make_csv_backend(out);
  backend->on(BeginRun{.run = {.robots = {{"arm", {{JointUnit::kRadian}, {JointUnit::kMetre}}},
                                          {"left", {{JointUnit::kMetre}}},
                                          {"right", {{JointUnit::kMetre}}}},
                               .objects = {}}});
  backend->on(EndRun{});
  CHECK(out.str().find(",q1,q2 [m],qd1,qd2 [m/s],qdd1,qdd2 [m/s^2],text\n") != std::string::npos);
}

TEST_CASE("half a revolution is written with one sign whatever the rounding") {
  for (const double rounding : {1e-17, -1e-17}) {
    std::ostringstream out;
    const std::unique_ptr<Backend> backend = make_csv_backend(out);
    backend->on(BeginRun{});
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    T.linear() = Eigen::AngleAxisd(M_PI + rounding, Eigen::Vector3d::UnitX()).matrix();
    T.linear()(2, 1) = rounding;
    T.linear()(1, 2) = -rounding;
    backend->on(ObjectSample{.name = "a", .T_world_obj = T});
    backend->on(EndRun{});
    CHECK(out.str().find(",1,0,0,") != std::string::npos);
  }
}

TEST_CASE("a stream that cannot be written is reported, once, and stops the writing") {
  std::ofstream full("/dev/full");
  const std::unique_ptr<Backend> backend = make_csv_backend(full);
  play_short_run(*backend);
  CHECK(backend->error() == "The trace could not be written; is the disk full?");
}

TEST_CASE("a robot that joins later and is too wide for the table is an error") {
  std::ostringstream out;
  const std::unique_ptr<Backend> backend = make_csv_backend(out);
  backend->on(BeginRun{.run = {.robots = {{"arm", {{JointUnit::kRadian}}}}, .objects = {}}});
  backend->on(
      RobotAdded{.t_ns = 5, .robot = {"wide", {{JointUnit::kRadian}, {JointUnit::kMetre}}}});
  const std::array q{1.0, 2.0};
  backend->on(JointSample{.t_ns = 5, .robot = 1, .q = q, .qd = q, .qdd = q});
  backend->on(EndRun{.t_ns = 5});
  CHECK(out.str().find("wide") == std::string::npos);
  CHECK(backend->error() ==
        "The table was begun for robots of 1 joints; \"wide\" has 2. Declare it before the first "
        "motion.");
}

TEST_CASE("a picture is a row with the pose of the camera and the name of its file") {
  std::ostringstream out;
  const std::unique_ptr<Backend> backend = make_csv_backend(out);
  backend->on(BeginRun{.run = {.robots = {{"arm", {{JointUnit::kRadian}}}}, .objects = {}}});
  ImageFrame frame{.t_ns = 40'000'000, .camera = "eye", .frame = 3, .width = 1, .height = 1};
  frame.T_world_camera.translation().z() = 0.5;
  backend->on(frame);
  frame.file = "frames/eye-000003.png";
  backend->on(frame);
  backend->on(EndRun{});
  CHECK(out.str().find("0.040000000,frame,eye,0,0,0.5,1,0,0,0,,,,\n") != std::string::npos);
  CHECK(out.str().find("0.040000000,frame,eye,0,0,0.5,1,0,0,0,,,,frames/eye-000003.png\n") !=
        std::string::npos);
}
