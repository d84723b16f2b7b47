#pragma once

#include <array>
#include <vector>

#include "services/plant/core/contact.hpp"
#include "services/plant/core/morphology.hpp"

namespace scarab::plant {

/// Finds every contact of the scene: feet, tibiae, femora, coxae and trunk with ground, object and
/// obstacle, legs with other legs, object with ground and obstacle. Left out: the segments of one
/// leg with each other (their joint ranges keep them apart), legs with the trunk, and the
/// shoulders, which are fixed beside the trunk's upper edge.
class Collision {
 public:
  /// `wall` lies flat (height 0) where the trial has no obstacle.
  Collision(const Morphology& morphology, const Wall& wall, double trunk_edge_radius_m);

  /// Clears and fills `contacts`, always in the same order.
  void detect(const Kinematics& kinematics, std::vector<Contact>& contacts);

 private:
  /// Coxa, femur, tibia and foot of a leg, in the world.
  struct LegShape {
    std::array<Capsule, 4> part;
    Eigen::Vector3d centre;
    double reach = 0;  ///< radius of a sphere about `centre` around the whole leg
    double lowest = 0;
  };
  struct TrunkEdge {
    std::size_t body;
    Capsule shape;  ///< in the body's frame
  };

  void add_trunk_edges(const TrunkBox& box, std::size_t body, double outer_x);
  void place_legs(const Kinematics& kinematics);
  void object_contacts(const Cylinder& object, std::vector<Contact>& contacts) const;
  void leg_contacts(const Cylinder& object, std::vector<Contact>& contacts) const;
  void leg_on_ground(std::size_t leg, std::vector<Contact>& contacts) const;
  void leg_on_leg(std::size_t first, std::size_t second, std::vector<Contact>& contacts) const;
  void trunk_contacts(const Kinematics& kinematics, const Cylinder& object,
                      std::vector<Contact>& contacts) const;

  Morphology morphology_;
  Wall wall_;
  double trunk_reach_ = 0;
  std::vector<TrunkEdge> trunk_edges_;
  std::array<LegShape, robot::kLegCount> legs_;
};

}  // namespace scarab::plant
