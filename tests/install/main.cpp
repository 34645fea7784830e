// The centre of an eccentric disc cam that turns at a constant speed.
#include <higherpair/geometry/curve.hpp>
#include <higherpair/geometry/motion.hpp>

#include <iostream>

int main() {
  using higherpair::Vector2d;

  // Lengths in metres, angles in radians: a disc of radius 20 mm, its centre 10 mm off the pivot.
  const higherpair::CurveResult disc = higherpair::make_circle(Vector2d(0.010, 0), 0.020);
  if (!disc) {
    std::cerr << "the disc " << describe(disc.error()) << '\n';
    return 1;
  }

  higherpair::BodyMotion cam;
  cam.X_WB.R_WB = higherpair::Rotation<double>::from_angle(higherpair::kPi / 6);
  cam.omega = 4;
  const higherpair::PointMotion center = point_motion(cam, higherpair::center(*disc));

  std::cout << "speed " << center.v_W.norm() << " m/s, acceleration " << center.a_W.norm() << " m/s^2\n";
}
