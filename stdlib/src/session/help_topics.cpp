#include "armlet/stdlib/help_topics.hpp"

namespace armlet {
namespace {

// Words in small letters, separated by commas; pages in the order in which they are shown.
constexpr HelpTopic kTopics[] = {
    // kinematics
    {"inverse kinematics, inverse kinematic problem, solve for joints, ikcon, ikine6s, invk",
     "ikine ikineAll ikineInfo explain reachable moveJ robot.IKinematics"},
    {"forward kinematics, direct kinematics, tool pose, end effector, tcp pose",
     "fkine here linkFrames robot.forwardKinematics"},
    {"denavit-hartenberg, denavit hartenberg, dh parameters, dh table, dh, link parameters, serial "
     "link, seriallink, link",
     "robot dh dhTable robot.joint.revolute robot.joint.prismatic robot.DHTable Robot"},
    {"jacobian, jacob0, jacobe, velocity kinematics, differential kinematics, twist",
     "jacobian jacobianDot jacobianRate tcpSpeed"},
    {"singularity, singular, manipulability, maniplty, yoshikawa, condition number",
     "manipulability jacobian svd explain"},
    {"workspace, reach, reachable", "reachable explain ikineInfo limits"},
    {"redundancy, redundant, null space, self-motion, arm angle, posture", "ikine ikineAll speedJ"},
    {"joint limits, qlim, range of a joint", "limits robot.qLimits robot.joint.revolute"},
    {"joint space, configuration, joint values, joint angles", "posJ joints moveJ randomJoints"},
    // poses
    {"pose, transform, homogeneous, homogeneous transformation, se3, cartesian position, place, "
     "position in space",
     "posC pose xyz here poseOf"},
    {"so3, rotation matrix, rotation, rotx, roty, rotz", "rotX rotY rotZ posC.R axisAngle"},
    {"orientation, rpy, roll pitch yaw, tr2rpy, rpy2tr, fixed angles",
     "rpy posC.roll posC.pitch posC.yaw"},
    {"euler, euler angles, tr2eul, eul2tr", "eulerZYZ eulerXYZ posC.euler"},
    {"quaternion, unitquaternion, unit quaternion", "quat posC.quat axisAngle"},
    {"exponential, exponential coordinates, screw, product of exponentials, twist coordinates, "
     "angvec2tr",
     "expPose logPose hat adjoint axisAngle"},
    {"trplot, tranimate, plot a frame, coordinate frame, axes in space", "draw.arrow frame trail"},
    {"frame, coordinate system, work object, wobj, user frame", "frame with (frame:) setPose"},
    {"tool centre point, tool center point, tcp, tool frame", "setTool tcp with (tool:) here"},
    // motion
    {"trajectory, trajectory generation, interpolation, jtraj, mtraj, mstraj, lspb, tpoly, "
     "quintic, "
     "trapezoidal, s-curve, jerk",
     "trajectory moveJ planners plan addPlanner"},
    {"cartesian motion, straight line, ctraj, linear motion", "moveL moveC path (blend:)"},
    {"point to point, ptp, joint motion, joint interpolation", "moveJ setJoints"},
    {"arc, circle, circular", "moveCirc"},
    {"spline, via points, way points, waypoints", "moveSpline trajectory path (blend:)"},
    {"velocity control, jogging, resolved rate, speed control, rmrc", "speedJ speedC"},
    {"blending, zone, rounding", "path (blend:) moveL"},
    {"collision, collision avoidance, obstacle, motion planning, path planning, rrt, prm",
     "plan with (avoid:) touching distance closestPoints with (collisions:)"},
    {"speed limit, velocity limit, override", "with (speed:) limits moveJ moveL"},
    // dynamics and control
    {"inverse dynamics, newton-euler, newton euler, rne, torque", "invDyn torques gravity"},
    {"forward dynamics, accel, simulation, nofriction", "fwdDyn simulate torqueJ"},
    {"inertia, inertia matrix, mass matrix", "massMatrix setLink setPayload"},
    {"gravity, gravload", "gravity pdTorques"},
    {"coriolis, centripetal, centrifugal", "coriolis"},
    {"control, pd, pid, computed torque, feedback linearisation",
     "pdTorques computedTorques torqueJ"},
    {"impedance, admittance, compliance, force control, hybrid",
     "impedanceTorques compliance giveWay force operationalTorques"},
    {"identification, base parameters, regressor", "regressor baseParameters dynamicParameters"},
    {"load, payload", "setPayload"},
    // grasping and the world
    {"gripper, grasping, pick and place, pick, place", "grasp release parallelGripper topGrasp"},
    {"suction, vacuum", "suctionCup grasp release"},
    {"grasp quality, force closure, epsilon", "graspQuality"},
    {"scene, world, part, workpiece, obstacle", "object spawn box cylinder poseOf"},
    // vision
    {"visual servoing, ibvs, pbvs, image jacobian", "visualServo interactionMatrix track"},
    {"camera calibration, hand-eye, hand eye", "calibrateCamera calibrateHandEye camera"},
    {"feature detection, harris, corner", "corners blobs edges"},
    {"aruco, apriltag, tag, marker", "markers markerPicture poseFromMarker"},
    // numbers and pictures
    {"figure, graph, diagram, draw, curve", "plot figure scatter scatter3 savePlot"},
    {"linear algebra, least squares, linear system", "\\ solve pinv svd qr lu"},
    {"differential equation, ode45, integrate, integration", "ode odeTimes trapz"},
    {"output, write, display, disp, message", "print error"},
    {"slider, button, user interface, page, laboratory, gui", "lab lab.field.NAME lab.button.NAME"},
    {"wait, sleep, pause, delay, time", "now signal"},
};

}  // namespace

std::span<const HelpTopic> help_topics() { return kTopics; }

}  // namespace armlet
