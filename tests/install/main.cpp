// The motion of a cam mechanism that a profile describes.
#include <higherpair/higherpair.hpp>

#include <algorithm>
#include <iostream>

using namespace higherpair;

int main() {
  const Result<Model> model = Model::open("profiles/eccentric_disc_oscillating_roller.toml");
  if (!model) {
    std::cerr << to_string(model.error()) << '\n';
    return 2;
  }
  const Result<Motion> motion = model->run();
  if (!motion) {
    std::cerr << to_string(motion.error()) << '\n';
    return 3;
  }

  const ColumnValues driver = motion->column("driver");
  const ColumnValues angle = motion->column("follower.angle");
  const auto highest = std::max_element(angle.begin(), angle.end()) - angle.begin();
  const auto row = static_cast<std::size_t>(highest);
  std::cout << motion->size() << " rows, the whole path is " << (motion->good() ? "good" : "not good") << '\n'
            << "highest at driver = " << driver[row] << ' ' << driver.unit << ": " << angle[row] << ' '
            << angle.unit << '\n';
  for (const Event& event : motion->events()) {
    std::cout << name_of(event.type) << " at driver = " << event.driver << ": " << event.cause << '\n';
  }
}
