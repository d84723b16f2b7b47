#pragma once

#include <array>

#include "services/plant/core/bodies.hpp"
#include "services/plant/core/morphology.hpp"

namespace scarab::plant {

/// Poses, velocities and joint axes of all bodies, from the trunk outwards.
///
/// What Simbody's realize(Velocity) gives (RobotTree; a test and SimbodyCheck compare the two) in a
/// twentieth of its time: the tree is known, every joint turns about an axis of its body, and a
/// turn about an axis of a frame moves only its two other axes.
class ForwardKinematics {
 public:
  /// Throws std::invalid_argument for a joint that does not turn about an axis of its body.
  explicit ForwardKinematics(const Morphology& morphology);

  void update(const MotionState& state, Kinematics& kinematics) const;

 private:
  struct Hinge {
    std::size_t parent = 0;
    std::size_t slot = 0;
    Eigen::Matrix3d R_parent_child = Eigen::Matrix3d::Identity();
    bool straight = true;  ///< R_parent_child is the identity
    Eigen::Vector3d position_in_parent = Eigen::Vector3d::Zero();
    int axis = 0;     ///< of the child's frame
    double sign = 1;  ///< -1: a positive angle turns about the opposite of the axis
  };

  static Hinge hinge(const Mounting& mounting);
  static void hang(const Hinge& hinge, double angle_rad, double speed_rad_s,
                   const BodyMotion& parent, BodyMotion& child, JointAxis& joint);

  std::array<Hinge, kObjectBody> hinge_;  ///< of every body but the two free ones
};

}  // namespace scarab::plant
