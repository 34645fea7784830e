#pragma once

#include "higherpair/dynamics/inverse_dynamics.hpp"
#include "higherpair/dynamics/reactions.hpp"
#include "higherpair/io/profile_reader.hpp"

#include <stdexcept>
#include <string>
#include <vector>

namespace higherpair::testing {

/// Metres and radians, so that a test's numbers are the library's.
inline constexpr const char* kSi = "units = { length = \"m\", angle = \"rad\" }\n";

inline Profile read_or_throw(const std::string& text) {
  auto profile = read_profile_text(text, "test.toml");
  if (!profile) {
    throw std::runtime_error(to_string(profile.error().front()));
  }
  return *profile;
}

inline std::vector<double> starts_of(const Profile& profile) {
  std::vector<double> starts;
  for (const DriverProgram& program : profile.programs) {
    starts.push_back(program.start);
  }
  return starts;
}

/// A profile in metres and radians, with its run started.
struct Analysis {
  explicit Analysis(const std::string& text)
      : profile(read_or_throw(kSi + text)), run(started(profile)), dynamics(run) {}

  const Reactions& at(const std::vector<DriverMotion>& drivers) {
    move_to(run, drivers);
    return dynamics.solve(run);
  }

  const Reactions& at(double position, double velocity, double acceleration) {
    return at({{position, velocity, acceleration}});
  }

  [[nodiscard]] std::size_t joint(const std::string& name) const {
    return index(run.mechanism().joints, name);
  }
  [[nodiscard]] std::size_t body(const std::string& name) const {
    return index(run.mechanism().bodies, name);
  }

  Profile profile;
  Run run;
  InverseDynamics dynamics;

private:
  static Run started(const Profile& profile) {
    auto run = start_run(profile.mechanism, starts_of(profile));
    if (!run) {
      throw std::runtime_error(run.error().reason);
    }
    return *std::move(run);
  }

  template <class Items>
  static std::size_t index(const Items& items, const std::string& name) {
    for (std::size_t i = 0; i < items.size(); ++i) {
      if (items[i].name == name) {
        return i;
      }
    }
    throw std::out_of_range(name);
  }
};

}  // namespace higherpair::testing
