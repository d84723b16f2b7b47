#include "services/plant/core/robot_tree.hpp"

#include "services/plant/core/simbody_model.hpp"

namespace scarab::plant {

class RobotTree::Impl {
 public:
  explicit Impl(const Morphology& morphology) : model(morphology) {
    model.finish();
    state = model.system.getDefaultState();
    model.system.realizeModel(state);
    acceleration.resize(static_cast<int>(kSpeedCount));
  }

  SimbodyModel model;
  SimTK::State state;
  // Zero-length inputs mean zero to Simbody.
  SimTK::Vector no_mobility_force, acceleration, residual;
  SimTK::Vector_<SimTK::SpatialVec> no_body_force;
};

RobotTree::RobotTree(const Morphology& morphology) : impl_(std::make_unique<Impl>(morphology)) {}
RobotTree::~RobotTree() = default;
RobotTree::RobotTree(RobotTree&&) noexcept = default;
RobotTree& RobotTree::operator=(RobotTree&&) noexcept = default;

void RobotTree::update(const MotionState& state, Kinematics& kinematics) {
  impl_->model.write(state, impl_->state);
  impl_->model.system.realize(impl_->state, SimTK::Stage::Velocity);
  impl_->model.read_kinematics(impl_->state, kinematics);
}

void RobotTree::inverse_dynamics(const SpeedVector& acceleration, SpeedVector& force) {
  const auto& index = impl_->model.speed_index();
  for (std::size_t i = 0; i < kSpeedCount; ++i) {
    impl_->acceleration[index[i]] = acceleration(static_cast<Eigen::Index>(i));
  }
  impl_->model.matter.calcResidualForceIgnoringConstraints(impl_->state, impl_->no_mobility_force,
                                                           impl_->no_body_force,
                                                           impl_->acceleration, impl_->residual);
  for (std::size_t i = 0; i < kSpeedCount; ++i) {
    force(static_cast<Eigen::Index>(i)) = impl_->residual[index[i]];
  }
}

}  // namespace scarab::plant
