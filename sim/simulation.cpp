#include "sim/simulation.hpp"

#include <box2d/box2d.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/check.hpp"
#include "sim/wheel_motor.hpp"
#include "sim/wheel_roughness.hpp"

namespace cogslam {
namespace {

constexpr double kGravity = 9.81;  // [m/s^2]
// Box2D keeps a polygon and an edge 15 to 20 mm apart (two polygon radii, less a slop): a body smaller by this much on
// every side comes to rest with its true outline 5 to 10 mm short of the surface.
constexpr double kSkin = 0.010;  // [m]
constexpr int kVelocityIterations = 8, kPositionIterations = 3;

b2Vec2 to_box2d(const Eigen::Vector2d& v) { return {static_cast<float>(v.x()), static_cast<float>(v.y())}; }

/// Nearest surface of a ray, the vehicle left out.
class NearestSurface : public b2RayCastCallback {
 public:
  explicit NearestSurface(const b2Body* vehicle) : vehicle_(vehicle) {}

  float ReportFixture(b2Fixture* fixture, const b2Vec2&, const b2Vec2&, float fraction) override {
    if (fixture->GetBody() == vehicle_) return -1.0F;  // Box2D: go on as if it were not there
    nearest = fraction;
    return fraction;  // Box2D: look for nearer ones only
  }

  std::optional<float> nearest;  // share of the ray

 private:
  const b2Body* vehicle_;
};

void add_surfaces(b2World& box2d, const World& world) {
  const b2BodyDef definition;
  b2Body* surfaces = box2d.CreateBody(&definition);
  for (const Segment& segment : world.segments()) {
    b2EdgeShape edge;
    edge.SetTwoSided(to_box2d(segment.a), to_box2d(segment.b));
    surfaces->CreateFixture(&edge, 0.0F);
  }
}

b2Body* add_vehicle(b2World& box2d, const RobotConfig& config, const Pose2& start) {
  b2BodyDef definition;
  definition.type = b2_dynamicBody;
  definition.position = to_box2d(start.position());
  definition.angle = static_cast<float>(start.theta);
  b2Body* body = box2d.CreateBody(&definition);
  b2PolygonShape box;
  box.SetAsBox(static_cast<float>(config.length / 2.0 - kSkin), static_cast<float>(config.width / 2.0 - kSkin));
  b2FixtureDef fixture;
  fixture.shape = &box;
  fixture.density = 1.0F;
  fixture.friction = static_cast<float>(config.wall_friction);
  body->CreateFixture(&fixture);
  const b2MassData mass{static_cast<float>(config.mass), b2Vec2_zero, static_cast<float>(config.inertia)};
  body->SetMassData(&mass);
  return body;
}

Twist2 rotated(double angle, const Twist2& v) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v.x - s * v.y, s * v.x + c * v.y, v.theta};
}

}  // namespace

struct Simulation::State {
  State(const World& world, const RobotConfig& robot, std::uint32_t seed)
      : config(robot), patches(world.slip_patches), friction(robot), roughness(robot.roughness, seed) {
    config.check();
    box2d.SetAllowSleeping(false);
    add_surfaces(box2d, world);
    body = add_vehicle(box2d, config, world.start);
    read_truth();
  }

  /// Velocity of the body in its own frame.
  [[nodiscard]] Twist2 twist() const {
    const b2Vec2 v = body->GetLinearVelocity();
    return rotated(-body->GetAngle(), {v.x, v.y, body->GetAngularVelocity()});
  }

  void set_twist(const Twist2& twist_base) {
    const Twist2 v = rotated(body->GetAngle(), twist_base);
    body->SetLinearVelocity(to_box2d({v.x, v.y}));
    body->SetAngularVelocity(static_cast<float>(v.theta));
  }

  /// Share of the usual friction at a point of the map: the most slippery patch there counts.
  [[nodiscard]] double patch_factor(const Eigen::Vector2d& p_map) const {
    double factor = 1.0;
    for (const SlipPatch& patch : patches) {
      if ((p_map - patch.centre).norm() <= patch.radius) factor = std::min(factor, patch.friction);
    }
    return factor;
  }

  void drive_motors(double dt) {
    if (!powered) return;
    for (std::size_t i = 0; i < 4; ++i) {
      const double torque = motors[i].torque(config.motor, set_points[i], truth.wheel_speeds[i], dt);
      truth.wheel_speeds[i] += torque * dt / config.wheel_inertia;
    }
  }

  void roll_wheels(double dt) {
    const double load_impulse = config.mass * kGravity / 4.0 * dt;
    WheelValues way, radius, limit;
    for (std::size_t i = 0; i < 4; ++i) way[i] = config.geometry.wheel_radius * std::abs(truth.wheel_speeds[i]) * dt;
    roughness.roll(way, steps);
    for (std::size_t i = 0; i < 4; ++i) {
      radius[i] = config.geometry.wheel_radius * roughness.radius_factor(i);
      limit[i] = config.friction * roughness.grip_factor(i) *
                 patch_factor(truth.T_map_base * friction.wheel_position(i)) * load_impulse;
    }
    Twist2 velocity = twist();
    friction.solve(radius, limit, velocity, truth.wheel_speeds);
    set_twist(velocity);
  }

  void read_truth() {
    // A float counts turns badly: after some minutes of turning, one step would be near its last digit.
    if (std::abs(body->GetAngle()) > std::numbers::pi) {
      body->SetTransform(body->GetPosition(), static_cast<float>(wrap_angle(body->GetAngle())));
    }
    truth.T_map_base = {body->GetPosition().x, body->GetPosition().y, wrap_angle(body->GetAngle())};
    truth.twist = twist();
    truth.in_contact = false;
    for (const b2ContactEdge* edge = body->GetContactList(); edge != nullptr; edge = edge->next) {
      truth.in_contact = truth.in_contact || edge->contact->IsTouching();
    }
  }

  RobotConfig config;
  std::vector<SlipPatch> patches;
  RollerFriction friction;
  WheelRoughness roughness;
  std::array<WheelMotor, 4> motors{};
  WheelSpeeds set_points{};
  bool powered = true;
  std::uint64_t steps = 0;
  Truth truth{};
  b2World box2d{b2Vec2_zero};
  b2Body* body = nullptr;  // owned by box2d
};

Simulation::Simulation(const World& world, const RobotConfig& config, std::uint32_t seed)
    : state_(std::make_unique<State>(world, config, seed)) {}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

void Simulation::command(const WheelSpeeds& set_points) {
  double fastest = state_->config.motor.max_speed;
  for (const double speed : set_points) fastest = std::max(fastest, std::abs(speed));
  EXPECTS(std::isfinite(fastest));
  const double share = state_->config.motor.max_speed / fastest;
  for (std::size_t i = 0; i < 4; ++i) state_->set_points[i] = share * set_points[i];
  state_->powered = true;
}

void Simulation::command(const Twist2& twist) { command(wheel_speeds(state_->config.geometry, twist)); }

void Simulation::coast() {
  state_->powered = false;
  for (WheelMotor& motor : state_->motors) motor.reset();
}

void Simulation::push(const Eigen::Vector2d& impulse_map, double angular_impulse) {
  state_->body->ApplyLinearImpulseToCenter(to_box2d(impulse_map), true);
  state_->body->ApplyAngularImpulse(static_cast<float>(angular_impulse), true);
}

void Simulation::put(const Pose2& T_map_base) {
  state_->body->SetTransform(to_box2d(T_map_base.position()), static_cast<float>(T_map_base.theta));
  state_->set_twist({});
  state_->read_truth();
}

const Truth& Simulation::step() {
  State& s = *state_;
  const double dt = s.config.step.seconds();
  ++s.steps;
  s.drive_motors(dt);
  s.roll_wheels(dt);
  s.box2d.Step(static_cast<float>(dt), kVelocityIterations, kPositionIterations);
  for (std::size_t i = 0; i < 4; ++i) s.truth.wheel_angles[i] += s.truth.wheel_speeds[i] * dt;
  s.truth.time = Time{} + static_cast<std::int64_t>(s.steps) * s.config.step;
  s.read_truth();
  return s.truth;
}

const Truth& Simulation::truth() const { return state_->truth; }

const WheelContacts& Simulation::wheel_contacts() const { return state_->friction.contacts(); }

std::optional<double> Simulation::cast_ray(const Eigen::Vector2d& origin, const Eigen::Vector2d& direction,
                                           double max_range) const {
  NearestSurface callback(state_->body);
  state_->box2d.RayCast(&callback, to_box2d(origin), to_box2d(origin + max_range * direction));
  if (!callback.nearest) return std::nullopt;
  return *callback.nearest * max_range;
}

}  // namespace cogslam
