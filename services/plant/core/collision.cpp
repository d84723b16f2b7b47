#include "services/plant/core/collision.hpp"

#include <algorithm>

namespace scarab::plant {
namespace {

using Eigen::Vector3d;
using robot::Leg;

constexpr SolidId kGroundId{Solid::kGround, 0, kWorldBody};
constexpr SolidId kObjectId{Solid::kObject, 0, kObjectBody};
constexpr SolidId kObstacleId{Solid::kObstacle, 0, kWorldBody};
constexpr std::array<Solid, 4> kParts = {Solid::kCoxa, Solid::kFemur, Solid::kTibia, Solid::kFoot};
constexpr std::size_t kTibiaPart = 2;

/// The foot is fixed to the tibia's body.
SolidId part_id(std::size_t leg, std::size_t part) {
  const std::size_t segment = std::min(part, kTibiaPart);
  return {kParts[part], static_cast<std::uint16_t>(leg),
          leg_body(robot::kLegs[leg], static_cast<LegSegment>(segment))};
}

void add(const SolidId& a, const SolidId& b, const std::optional<Touch>& touch, std::size_t place,
         std::vector<Contact>& contacts) {
  if (touch) contacts.push_back({a, b, *touch, feature(a, b, place)});
}

bool near_wall(const Wall& wall, const Vector3d& centre, double reach) {
  return wall.height > 0 && std::abs(centre.x() - wall.x) < reach + wall.half_thickness &&
         centre.z() < reach + wall.height;
}

bool near_object(const Cylinder& object, const Vector3d& centre, double reach) {
  const Vector3d offset = centre - object.centre;
  const double along = offset.dot(object.axis);
  const double limit = object.radius + reach;
  return std::abs(along) < object.half_length + reach &&
         offset.squaredNorm() - along * along < limit * limit;
}

}  // namespace

Collision::Collision(const Morphology& morphology, const Wall& wall, double trunk_edge_radius_m)
    : morphology_(morphology), wall_(wall) {
  const double inset = trunk_edge_radius_m;
  const auto shrunk = [inset](const TrunkBox& box) {
    const Vector3d margin(0, inset, inset);
    return TrunkBox{box.low + margin, box.high - margin};
  };
  TrunkBox rear = shrunk(morphology.rear_box);
  rear.low.x() += inset;
  TrunkBox front = shrunk(morphology.front_box);
  front.high.x() -= inset;
  trunk_edges_.reserve(12);
  add_trunk_edges(rear, kRearTrunkBody, rear.low.x());
  add_trunk_edges(front, kFrontTrunkBody, front.high.x());
  for (TrunkEdge& edge : trunk_edges_) edge.shape.radius = inset;
  trunk_reach_ = morphology.rear_box.low.norm() + morphology.front_box.high.norm();
}

/// The box's edges along x, and the upright ones of its outer end.
void Collision::add_trunk_edges(const TrunkBox& box, std::size_t body, double outer_x) {
  for (const double y : {box.low.y(), box.high.y()}) {
    for (const double z : {box.low.z(), box.high.z()}) {
      trunk_edges_.push_back(
          {body, {Vector3d(box.low.x(), y, z), Vector3d(box.high.x(), y, z), 0}});
    }
    trunk_edges_.push_back(
        {body, {Vector3d(outer_x, y, box.low.z()), Vector3d(outer_x, y, box.high.z()), 0}});
  }
}

void Collision::place_legs(const Kinematics& kinematics) {
  for (std::size_t leg = 0; leg < robot::kLegCount; ++leg) {
    LegShape& shape = legs_[leg];
    for (std::size_t part = 0; part <= kTibiaPart; ++part) {
      const std::size_t body = part_id(leg, part).body;
      const BodyMotion& motion = kinematics.body[body];
      const SegmentShape& segment = morphology_.segment[body];
      shape.part[part] = {motion.position, motion.to_world(segment.tip), segment.radius_m};
    }
    const Vector3d& foot = shape.part[kTibiaPart].b;
    shape.part[3] = {foot, foot, morphology_.foot_radius_m[leg]};
    shape.centre = 0.5 * (shape.part[0].a + foot);
    shape.reach = 0;
    shape.lowest = foot.z();
    double widest = 0;
    for (const Capsule& part : shape.part) {
      shape.reach = std::max({shape.reach, (part.a - shape.centre).squaredNorm(),
                              (part.b - shape.centre).squaredNorm()});
      shape.lowest = std::min({shape.lowest, part.a.z(), part.b.z()});
      widest = std::max(widest, part.radius);
    }
    shape.reach = std::sqrt(shape.reach) + widest;
    shape.lowest -= widest;
  }
}

void Collision::object_contacts(const Cylinder& object, std::vector<Contact>& contacts) const {
  const AxisTouches ground = cylinder_on_ground(object);
  for (std::size_t i = 0; i < ground.size(); ++i) add(kGroundId, kObjectId, ground[i], i, contacts);
  if (!near_wall(wall_, object.centre, object.radius + object.half_length)) return;
  const AxisTouches wall = cylinder_on_wall(object, wall_);
  for (std::size_t i = 0; i < wall.size(); ++i) add(kObjectId, kObstacleId, wall[i], i, contacts);
}

/// Joints between segments are covered by the proximal segment, the foot by itself.
void Collision::leg_on_ground(std::size_t leg, std::vector<Contact>& contacts) const {
  const LegShape& shape = legs_[leg];
  if (shape.lowest > 0) return;
  add(kGroundId, part_id(leg, 0), touch_ground(shape.part[0].a, shape.part[0].radius), 0, contacts);
  add(kGroundId, part_id(leg, 0), touch_ground(shape.part[0].b, shape.part[0].radius), 1, contacts);
  add(kGroundId, part_id(leg, 1), touch_ground(shape.part[1].b, shape.part[1].radius), 0, contacts);
  add(kGroundId, part_id(leg, 3), touch_ground(shape.part[3].a, shape.part[3].radius), 0, contacts);
}

void Collision::leg_on_leg(std::size_t first, std::size_t second,
                           std::vector<Contact>& contacts) const {
  const LegShape& a = legs_[first];
  const LegShape& b = legs_[second];
  const double limit = a.reach + b.reach;
  if ((a.centre - b.centre).squaredNorm() > limit * limit) return;
  for (std::size_t i = 0; i < kParts.size(); ++i) {
    const Capsule& p = a.part[i];
    const Vector3d p_centre = 0.5 * (p.a + p.b);
    const double p_reach = 0.5 * (p.b - p.a).norm() + p.radius;
    for (std::size_t j = 0; j < kParts.size(); ++j) {
      const Capsule& q = b.part[j];
      const double reach = p_reach + 0.5 * (q.b - q.a).norm() + q.radius;
      if ((p_centre - 0.5 * (q.a + q.b)).squaredNorm() > reach * reach) continue;
      bool p_end = false;
      bool q_end = false;
      const auto touch = touch_capsules(p, q, &p_end, &q_end);
      // At its lower end the tibia is inside the foot, which touches for it.
      if ((i == kTibiaPart && p_end) || (j == kTibiaPart && q_end)) continue;
      add(part_id(first, i), part_id(second, j), touch, 0, contacts);
    }
  }
}

void Collision::leg_contacts(const Cylinder& object, std::vector<Contact>& contacts) const {
  for (std::size_t leg = 0; leg < robot::kLegCount; ++leg) {
    leg_on_ground(leg, contacts);
    const LegShape& shape = legs_[leg];
    const bool at_object = near_object(object, shape.centre, shape.reach);
    const bool at_wall = near_wall(wall_, shape.centre, shape.reach);
    for (std::size_t part = 0; part < kParts.size() && (at_object || at_wall); ++part) {
      bool at_foot = false;
      if (at_object) {
        const auto touch = touch_cylinder(object, shape.part[part], &at_foot);
        if (part != kTibiaPart || !at_foot) {
          add(kObjectId, part_id(leg, part), touch, 0, contacts);
        }
      }
      if (at_wall) {
        const auto touch = touch_wall(wall_, shape.part[part], &at_foot);
        if (part != kTibiaPart || !at_foot) {
          add(kObstacleId, part_id(leg, part), touch, 0, contacts);
        }
      }
    }
    for (std::size_t other = leg + 1; other < robot::kLegCount; ++other) {
      leg_on_leg(leg, other, contacts);
    }
  }
}

void Collision::trunk_contacts(const Kinematics& kinematics, const Cylinder& object,
                               std::vector<Contact>& contacts) const {
  const Vector3d& centre = kinematics.body[kRearTrunkBody].position;
  const bool at_ground = centre.z() < trunk_reach_;
  const bool at_object = near_object(object, centre, trunk_reach_);
  const bool at_wall = near_wall(wall_, centre, trunk_reach_);
  // Of each side of each box (three edges) only the deepest contact with a solid counts.
  for (std::size_t side = 0; side < trunk_edges_.size(); side += 3) {
    std::optional<Touch> on_object;
    std::optional<Touch> on_wall;
    const SolidId trunk{Solid::kTrunk, 0, trunk_edges_[side].body};
    const std::size_t place = side / 3;
    const BodyMotion& body = kinematics.body[trunk.body];
    const auto keep_deeper = [](std::optional<Touch>& best, const std::optional<Touch>& next) {
      if (next && (!best || next->depth > best->depth)) best = next;
    };
    for (std::size_t i = 0; i < 3; ++i) {
      const Capsule& local = trunk_edges_[side + i].shape;
      const Capsule edge{body.to_world(local.a), body.to_world(local.b), local.radius};
      if (at_object) keep_deeper(on_object, touch_cylinder(object, edge));
      if (at_wall) keep_deeper(on_wall, touch_wall(wall_, edge));
      if (at_ground && i < 2) {  // the edges along x hold all corners
        add(kGroundId, trunk, touch_ground(edge.a, edge.radius), 2 * i, contacts);
        add(kGroundId, trunk, touch_ground(edge.b, edge.radius), 2 * i + 1, contacts);
      }
    }
    add(kObjectId, trunk, on_object, place, contacts);
    add(kObstacleId, trunk, on_wall, place, contacts);
  }
}

void Collision::detect(const Kinematics& kinematics, std::vector<Contact>& contacts) {
  contacts.clear();
  const BodyMotion& body = kinematics.body[kObjectBody];
  const Cylinder object{body.position, body.R_world_body.col(1), morphology_.object_radius_m,
                        morphology_.object_half_length_m};
  place_legs(kinematics);
  object_contacts(object, contacts);
  leg_contacts(object, contacts);
  trunk_contacts(kinematics, object, contacts);
}

}  // namespace scarab::plant
