#pragma once

#include <array>

#include "services/plant/core/bodies.hpp"
#include "services/plant/core/contact.hpp"
#include "services/plant/core/morphology.hpp"

namespace scarab::plant {

/// How the generalised speeds move solid b against solid a at a contact point: v_b - v_a = sum of
/// column * speed. Sparse: a robot body depends on at most ten speeds, of which the trunk's six
/// have columns that need no multiplication with what is known to be 0 or 1. When both solids are
/// the robot's, the trunk's six cancel and are left out.
class ContactJacobian {
 public:
  ContactJacobian(const Kinematics& kinematics,
                  const std::array<bool, robot::kLegCount>& leg_on_front, const Contact& contact);

  [[nodiscard]] Eigen::Vector3d velocity(const SpeedVector& speed) const;

  /// force += J^T f.
  void add_force(const Eigen::Vector3d& f, SpeedVector& force) const;

  /// Lower triangle of system += J^T (slip I + (normal - slip) n n^T) J.
  void add_damping(const Eigen::Vector3d& n, double normal, double slip, SpeedMatrix& system) const;

 private:
  /// The six speeds of the trunk or the object: columns sign (e_k x arm) and sign e_k.
  struct FreeBody {
    Eigen::Index first_speed = 0;
    Eigen::Vector3d arm;
    double sign = 1;
  };
  struct Hinge {
    Eigen::Index speed = 0;
    Eigen::Vector3d column;
  };

  void add_free_body(std::size_t first_speed, const Eigen::Vector3d& arm, double sign);
  void add_hinges(const Kinematics& kinematics, const SolidId& solid, bool on_front,
                  const Eigen::Vector3d& point, double sign);
  void add_solid(const Kinematics& kinematics, const SolidId& solid, bool on_front, bool with_trunk,
                 const Eigen::Vector3d& point, double sign);
  void add_row(Eigen::Index row, const Eigen::Vector3d& weighted, SpeedMatrix& system) const;

  std::size_t free_count_ = 0;
  std::array<FreeBody, 2> free_;
  std::size_t hinge_count_ = 0;
  std::array<Hinge, 8> hinge_;
};

}  // namespace scarab::plant
