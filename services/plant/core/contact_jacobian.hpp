#pragma once

#include <array>

#include "services/plant/core/bodies.hpp"
#include "services/plant/core/contact.hpp"
#include "services/plant/core/morphology.hpp"

namespace scarab::plant {

/// How the generalised speeds move solid b against solid a at a contact point: v_b - v_a = sum of
/// column * speed. Sparse: a robot body depends on at most ten speeds. When both solids are the
/// robot's, the trunk's six cancel and are left out.
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
  void add_body(const Kinematics& kinematics, const SolidId& solid, bool on_front, bool with_trunk,
                const Eigen::Vector3d& point, double sign);
  void add_column(std::size_t speed, const Eigen::Vector3d& column);

  static constexpr std::size_t kMaxColumns = 20;
  std::size_t count_ = 0;
  std::array<Eigen::Index, kMaxColumns> speed_;
  std::array<Eigen::Vector3d, kMaxColumns> column_;
};

}  // namespace scarab::plant
