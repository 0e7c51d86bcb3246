// Values of toolboxes for robots: the Robotics Toolbox for MATLAB and for Python, RoboDK, MoveIt;
// and calls that people guess. Names that only differ are rows of the host
// (stdlib/src/messages/foreign_names.hpp).

#include <array>

#include "habits/rows.hpp"

namespace armlet::lang {
namespace {

constexpr std::string_view kArms =
    "an arm is a block with its joints: robot arm { joint revolute(a: 300mm, alpha: 90deg) }";
constexpr std::string_view kCatalog =
    "robots.ur5() gives a robot and object(\"cube\") a thing of the world";
constexpr std::string_view kSpeeds =
    "with (speed: 100mm/s) { ... } holds for the moves inside; a move takes speed: too";
constexpr std::string_view kZones =
    "a move stops at its goal; in a path, blend: 10mm rounds corners";
constexpr std::string_view kBase =
    "where a robot stands is said where it is made: robots.ur5(base: xyz(x: 1m))";
constexpr std::string_view kEvenSteps =
    "these poses have equal distances; ctraj speeds up and slows down";
constexpr std::string_view kTrajectory =
    "time: 2s would say how long it takes; tr.q(t), tr.qd(t) and tr.qdd(t) are its values";
constexpr std::string_view kPostures =
    "home() gives where a robot starts; other postures are written posJ(...)";
constexpr std::string_view kPath =
    "path (blend: 5mm) { moveL(a); moveL(b) } goes through poses without a stop";
constexpr std::string_view kPage = "armlet lab FILE shows the robot in a page, with sliders";
constexpr std::string_view kNamedSignals = "signals have names";

constexpr auto kToolboxes = std::to_array<Habit>({
    // poses
    {"SE3 ( $ , $ , $ )", "xyz({123:place})", ""},
    {"SE3 ( [ $ , $ , $ ] )", "xyz({123:place})", ""},
    {"SE3 ( )", "xyz()", ""},
    {"SE3 . Trans ( $ , $ , $ )", "xyz({123:place})", ""},
    {"SE3 . Trans ( [ $ , $ , $ ] )", "xyz({123:place})", ""},
    {"SE3 . Tx ( $ )", "xyz(x: {1:m})", ""},
    {"SE3 . Ty ( $ )", "xyz(y: {1:m})", ""},
    {"SE3 . Tz ( $ )", "xyz(z: {1:m})", ""},
    {"SE3 . Rx ( $ )", "rotX({1:rad})", ""},
    {"SE3 . Ry ( $ )", "rotY({1:rad})", ""},
    {"SE3 . Rz ( $ )", "rotZ({1:rad})", ""},
    {"SE3 . Rx ( $ , ? )", "rotX({12:angle})", ""},
    {"SE3 . Rx ( $ , unit = ? )", "rotX({12:angle})", ""},
    {"SE3 . Ry ( $ , ? )", "rotY({12:angle})", ""},
    {"SE3 . Ry ( $ , unit = ? )", "rotY({12:angle})", ""},
    {"SE3 . Rz ( $ , ? )", "rotZ({12:angle})", ""},
    {"SE3 . Rz ( $ , unit = ? )", "rotZ({12:angle})", ""},
    {"SE3 . RPY ( $ , $ , $ )", "rpy({1:rad}, {2:rad}, {3:rad})", ""},
    {"SE3 . RPY ( [ $ , $ , $ ] )", "rpy({1:rad}, {2:rad}, {3:rad})", ""},
    {"SE3 . RPY ( $ , $ , $ , unit = ? )", "rpy({14:angle}, {24:angle}, {34:angle})", ""},
    {"SE3 . RPY ( [ $ , $ , $ ] , unit = ? )", "rpy({14:angle}, {24:angle}, {34:angle})", ""},
    {"SE3 . Eul ( $ , $ , $ )", "eulerZYZ({1:rad}, {2:rad}, {3:rad})", ""},
    {"SE3 . AngVec ( $ , $ )", "axisAngle({2}, {1:rad})", ""},
    {"SE3 . AngleAxis ( $ , $ )", "axisAngle({2}, {1:rad})", ""},
    {"transl ( $ , $ , $ )", "xyz({123:place})", ""},
    {"transl ( [ $ , $ , $ ] )", "xyz({123:place})", ""},
    {"transl ( @ )", "{1}.p", ""},
    {"trotx ( $ )", "rotX({1:rad})", ""},
    {"troty ( $ )", "rotY({1:rad})", ""},
    {"trotz ( $ )", "rotZ({1:rad})", ""},
    {"trotx ( $ , ? )", "rotX({12:angle})", ""},
    {"troty ( $ , ? )", "rotY({12:angle})", ""},
    {"trotz ( $ , ? )", "rotZ({12:angle})", ""},
    {"^rotx ( $ )", "rotX({1:turned}).R", ""},
    {"^roty ( $ )", "rotY({1:turned}).R", ""},
    {"^rotz ( $ )", "rotZ({1:turned}).R", ""},
    {"^rotx ( $ , ? )", "rotX({12:angle}).R", ""},
    {"^roty ( $ , ? )", "rotY({12:angle}).R", ""},
    {"^rotz ( $ , ? )", "rotZ({12:angle}).R", ""},
    {"rpy2tr ( $ , $ , $ )", "rpy({1:rad}, {2:rad}, {3:rad})", ""},
    {"rpy2r ( $ , $ , $ )", "rpy({1:rad}, {2:rad}, {3:rad}).R", ""},
    {"rpy2tr ( [ $ , $ , $ ] )", "rpy({1:rad}, {2:rad}, {3:rad})", ""},
    {"rpy2tr ( $ , $ , $ , ? )", "rpy({14:angle}, {24:angle}, {34:angle})", ""},
    {"eul2tr ( $ , $ , $ )", "eulerZYZ({1:rad}, {2:rad}, {3:rad})", ""},
    {"eul2r ( $ , $ , $ )", "eulerZYZ({1:rad}, {2:rad}, {3:rad}).R", ""},
    {"eul2tr ( [ $ , $ , $ ] )", "eulerZYZ({1:rad}, {2:rad}, {3:rad})", ""},
    {"tr2rpy ( $ )", "[{1:operand}.roll, {1:operand}.pitch, {1:operand}.yaw]", ""},
    {"@ . rpy ( )", "[{1}.roll, {1}.pitch, {1}.yaw]", ""},
    {"tr2eul ( $ )", "{1:operand}.euler(\"ZYZ\")", ""},
    {"@ . eul ( )", "{1}.euler(\"ZYZ\")", ""},
    {"angvec2tr ( $ , $ )", "axisAngle({2}, {1:rad})", ""},
    {"tr2rt ( $ )", kNoSuchThing, "the turn of a pose is T.R, its place T.p"},
    {"@ . interp ( $ , $ )", "lerp({1}, {2}, {3})", ""},
    {"ctraj ( $ , $ , $ )", "?map(linspace(0.0, 1.0, {3}), fn(s) => lerp({1}, {2}, s))",
     kEvenSteps},
    {"rtb . ctraj ( $ , $ , $ )", "?map(linspace(0.0, 1.0, {3}), fn(s) => lerp({1}, {2}, s))",
     kEvenSteps},
    {"@ . ^t", "{1}.p", ""},
    // arms
    {"@ . ^n", "{1}.dof", ""},
    {"@ . numJoints", "{1}.dof", ""},
    {"@ . num_joints", "{1}.dof", ""},
    {"@ . qlim", "?{1}.limits()",
     "its first list has the lower limits, its second one the upper limits"},
    {"@ . ^q", "{1}.joints()", ""},
    {"@ . qz", kNoSuchThing, kPostures},
    {"@ . qr", kNoSuchThing, kPostures},
    {"@ . qn", kNoSuchThing, kPostures},
    {"@ . jacobe ( $ )", "{1}.jacobian({2}, frame: \"tool\")", ""},
    {"@ . jacobn ( $ )", "{1}.jacobian({2}, frame: \"tool\")", ""},
    {"@ . tool = $", "{1}.setTool({2})", ""},
    {"@ . base = $", kNoSuchThing, kBase},
    {"@ . setBase ( * )", kNoSuchThing, kBase},
    {"@ . teach ( * )", kNoSuchThing, kPage},
    {"jtraj ( $ , $ , $ )", "?trajectory(\"Syn\", [posJ({1}), posJ({2})])", kTrajectory},
    {"^rtb . jtraj ( $ , $ , $ )", "?trajectory(\"Syn\", [posJ({1}), posJ({2})])", kTrajectory},
    {"mtraj ( \\@ lspb , $ , $ , $ )", "?trajectory(\"Trap\", [posJ({1}), posJ({2})])",
     kTrajectory},
    {"mtraj ( \\@ tpoly , $ , $ , $ )", "?trajectory(\"Syn\", [posJ({1}), posJ({2})])",
     kTrajectory},
    {"^rtb . mtraj ( @ , $ , $ , $ )", "?trajectory(\"Syn\", [posJ({2}), posJ({3})])", kTrajectory},
    {"Link ( * )", kNoSuchThing, kArms},
    {"SerialLink ( * )", kNoSuchThing, kArms},
    {"DHRobot ( * )", kNoSuchThing, kArms},
    {"RevoluteDH ( * )", kNoSuchThing, kArms},
    {"PrismaticDH ( * )", kNoSuchThing, kArms},
    {"rigidBodyTree ( * )", kNoSuchThing, kArms},
    {"loadrobot ( * )", kNoSuchThing, kCatalog},
    {"importrobot ( $ )", "urdf({1})", ""},
    {"^rtb . models . DH . @ ( )", "robots.{1:lower}()", ""},
    {"^rtb . models . URDF . @ ( )", "robots.{1:lower}()", ""},
    {"^rtb . models . @ ( )", "robots.{1:lower}()", ""},
    // RoboDK
    {"@ . Pose ( )", "{1}.here()", ""},
    {"@ . setDO ( # , $ )", "setSignal(\"out{2}\", {3:truth})", kNamedSignals},
    {"@ . setDO ( ? , $ )", "setSignal({2}, {3:truth})", kNamedSignals},
    {"@ . getDI ( # )", "signal(\"in{2}\")", kNamedSignals},
    {"@ . getDI ( ? )", "signal({2})", kNamedSignals},
    {"@ . waitDI ( # , 1 )", "wait until signal(\"in{2}\")", kNamedSignals},
    {"@ . waitDI ( # , 0 )", "wait until !signal(\"in{2}\")", kNamedSignals},
    {"@ . Pause ( $ )", "wait({2:ms})", ""},
    {"@ . setSpeed ( * )", kNoSuchThing, kSpeeds},
    {"@ . setSpeedJoints ( * )", kNoSuchThing, kSpeeds},
    {"@ . setVelocity ( * )", kNoSuchThing, kSpeeds},
    {"@ . setAcceleration ( * )", kNoSuchThing, kSpeeds},
    {"@ . setRounding ( * )", kNoSuchThing, kZones},
    {"@ . setZoneData ( * )", kNoSuchThing, kZones},
    {"@ . setPoseFrame ( * )", kNoSuchThing, "with (frame: f) { ... } holds for the moves inside"},
    {"@ . AttachClosest ( )", "{1}.grasp()", ""},
    {"@ . DetachClosest ( )", "{1}.release()", ""},
    {"@ . DetachAll ( )", "{1}.release()", ""},
    {"^RDK . ShowMessage ( $ )", "print({1})", ""},
    {"^RDK . ShowMessage ( $ , $ )", "print({1})", ""},
    {"^RDK . Item ( * )", kNoSuchThing, kCatalog},
    {"Robolink ( )", kNoSuchThing, kCatalog},
    // MoveIt
    {"@ . set_joint_value_target ( $ )", "{1}.moveJ({2})", ""},
    {"@ . set_pose_target ( $ )", "{1}.moveJ({2})", ""},
    {"@ . set_max_velocity_scaling_factor ( * )", kNoSuchThing, kSpeeds},
    {"@ . set_max_acceleration_scaling_factor ( * )", kNoSuchThing, kSpeeds},
    {"@ . compute_cartesian_path ( * )", kNoSuchThing, kPath},
    {"@ . get_current_pose ( * ) . pose", "{1}.here()", ""},
    {"@ . get_current_pose ( * )", "{1}.here()", ""},
    {"rospy . sleep ( $ )", "wait({1:s})", ""},
    {"rospy . loginfo ( $ )", "print({1})", ""},
    {"rclpy . @ ( * )", kNoSuchThing, "a .rbt file runs from its first line, without ROS"},
    {"rospy . @ ( * )", kNoSuchThing, "a .rbt file runs from its first line, without ROS"},
    // MATLAB's Robotics System Toolbox
    {"eul2rotm ( [ $ , $ , $ ] )", "eulerZYX({1:rad}, {2:rad}, {3:rad}).R", ""},
    {"eul2tform ( [ $ , $ , $ ] )", "eulerZYX({1:rad}, {2:rad}, {3:rad})", ""},
    {"axang2tform ( [ $ , $ , $ , $ ] )", "axisAngle([{123}], {4:rad})", ""},
    {"axang2rotm ( [ $ , $ , $ , $ ] )", "axisAngle([{123}], {4:rad}).R", ""},
    {"quat2tform ( [ $ , $ , $ , $ ] )", "quat({1234})", ""},
    {"trvec2tform ( [ $ , $ , $ ] )", "xyz({123:place})", ""},
    {"tform2trvec ( $ )", "{1:operand}.p", ""},
    {"tform2rotm ( $ )", "{1:operand}.R", ""},
    {"tform2eul ( $ )", "{1:operand}.euler(\"ZYX\")", ""},
    {"getTransform ( @ , $ , ? )", "?{1}.fkine({2})", "fkine gives the pose of the tool point"},
    {"geometricJacobian ( @ , $ , ? )", "?{1}.jacobian({2})",
     "the first three rows are those of the linear speed here"},
    {"inverseKinematics ( * )", kNoSuchThing, "arm.ikine(p) gives joint values for a pose"},
    {"inverseDynamics ( @ , $ , $ , $ )", "{1}.invDyn({2}, {3}, {4})", ""},
    {"forwardDynamics ( @ , $ , $ , $ )", "{1}.fwdDyn({2}, {3}, {4})", ""},
    {"gravityTorque ( @ , $ )", "{1}.gravity({2})", ""},
    // what people guess
    {"@ . getPose ( )", "{1}.here()", ""},
    {"@ . getPose ( )", "poseOf({1})", ""},
    {"@ . pose ( )", "{1}.here()", ""},
    {"@ . pose ( )", "poseOf({1})", ""},
    {"@ . pose", "{1}.here()", ""},
    {"@ . pose", "poseOf({1})", ""},
    {"@ . getPosition ( )", "{1}.here().p", ""},
    {"@ . getPosition ( )", "poseOf({1}).p", ""},
    {"@ . position", "{1}.p", ""},
    {"@ . position", "{1}.here().p", ""},
    {"@ . position", "poseOf({1}).p", ""},
    {"@ . ^x", "poseOf({1}).x", ""},
    {"@ . ^y", "poseOf({1}).y", ""},
    {"@ . ^z", "poseOf({1}).z", ""},
    {"@ . ^x", "{1}.here().x", ""},
    {"@ . ^y", "{1}.here().y", ""},
    {"@ . ^z", "{1}.here().z", ""},
    {"@ . move ( $ )", "{1}.moveJ({2})", ""},
    {"@ . move ( $ )", "{1}.setPose({2})", ""},
    {"@ . gripper . open ( )", "{1}.release()", ""},
    {"@ . gripper . close ( )", "{1}.grasp()", ""},
    {"gripper . open ( )", "release()", ""},
    {"gripper . close ( )", "grasp()", ""},
    {"@ . goHome ( )", "{1}.moveJ({1}.home())", ""},
    {"@ . moveHome ( )", "{1}.moveJ({1}.home())", ""},
    {"goHome ( )", "moveJ(home())", ""},
    {"moveHome ( )", "moveJ(home())", ""},
    {"waitFor ( ? )", "wait until signal({1})", ""},
    {"waitFor ( $ )", "wait until {1:test}", ""},
    {"waitSignal ( ? )", "wait until signal({1})", ""},
    {"size ( @ )", "[{1}.rows, {1}.cols]", ""},
    {"@ . forEach ( fn ( @ ) => $ )", "for ({2} in {1}) { {3} }", ""},
    {"@ . forEach ( @ => $ )", "for ({2} in {1}) { {3} }", ""},
    {"transpose ( $ )", "{1:operand}.T", ""},
    {"@ . transpose ( )", "{1}.T", ""},
    {"np . linalg . solve ( $ , $ )", "{1:operand} \\ {2:operand}", ""},
    {"linsolve ( $ , $ )", "{1:operand} \\ {2:operand}", ""},
    {"solve ( $ , $ )", "{1:operand} \\ {2:operand}", ""},
    {"@ . toFixed ( # )", "f\"{{1}:.{2}f}\"", ""},
    {"@ . reduce ( $ , $ )", "{1}.fold({3}, {2})", ""},
    {"for ( @ , @ ) in @ {", "for ({1}, {2} in {3}) {", ""},
});

}  // namespace

std::span<const Habit> toolbox_habits() { return kToolboxes; }

}  // namespace armlet::lang
