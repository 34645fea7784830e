// The same mechanisms, step by step, in this library and in engines packaged by Debian: a table of times and
// errors.
#include "linkage.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>

#include <fmt/core.h>

namespace higherpair::peers {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int kTurns = 5;  // the fastest one counts

struct Measured {
  double microseconds = INFINITY;  // per step
  double position = 0;             // largest error after the first turn [rad or lengths of 1]
  double rate = 0;                 // the same for the rate, relative to its largest value
};

using Exact = std::function<Output(double angle)>;

Measured measure(PeerRun& run, const Exact& exact, bool turns) {
  Measured measured;
  double fastest = 0;
  for (int turn = 0; turn < kTurns; ++turn) {
    std::vector<Output> outputs;
    outputs.reserve(kStepsPerTurn);
    const auto start = std::chrono::steady_clock::now();
    for (int k = 0; k < kStepsPerTurn; ++k) {
      run.step();
      outputs.push_back(run.output());
    }
    const std::chrono::duration<double, std::micro> time = std::chrono::steady_clock::now() - start;
    measured.microseconds = std::min(measured.microseconds, time.count() / kStepsPerTurn);
    for (int k = 0; turn > 0 && k < kStepsPerTurn; ++k) {  // engines settle in the first turn
      const Output expected = exact(2 * kPi * (k + 1) / kStepsPerTurn);
      const Output& output = outputs[k];
      const double error = output.position - expected.position;
      measured.position =
          std::max(measured.position, std::abs(turns ? std::remainder(error, 2 * kPi) : error));
      measured.rate = std::max(measured.rate, std::abs(output.rate - expected.rate));
      fastest = std::max(fastest, std::abs(expected.rate));
    }
  }
  measured.rate /= fastest;
  return measured;
}

void print(const std::string& mechanism, const Peer& peer, const std::string& text) {
  fmt::print("{:<14} {:<12} {}\n", mechanism, peer.name, text);
}

void print(const std::string& mechanism, const Peer& peer, const Measured& measured) {
  print(
      mechanism, peer,
      fmt::format("{:>10.3f} {:>12.1e} {:>12.1e}", measured.microseconds, measured.position, measured.rate));
}

int run() {
  const std::vector<Peer> peers{this_library(), simbody(), ode(), box2d(), chipmunk()};
  const std::vector<std::pair<std::string, Linkage>> linkages{
      {"four-bar", {.slides = false, .ground = 1, .crank = 0.35, .link = 0.9, .rocker = 0.7}},
      {"slider-crank", {.slides = true, .crank = 0.35, .link = 1.1, .offset = 0.1}}};
  fmt::print("{:<14} {:<12} {:>10} {:>12} {:>12}\n", "mechanism", "engine", "us a step", "position", "rate");
  for (const auto& [name, linkage] : linkages) {
    for (const Peer& peer : peers) {
      if (peer.linkage == nullptr) {
        print(name, peer, "not installed: " + peer.package);
        continue;
      }
      const auto exact = [&, &of = linkage](double angle) { return solution_at(of, angle).output; };
      print(name, peer, measure(*peer.linkage(linkage), exact, !linkage.slides));
    }
  }
  const Discs discs{.eccentricity = 0.1, .cam = 0.4, .ground = 0.9, .arm = 0.7, .roller = 0.25};
  for (const Peer& peer : peers) {
    if (peer.linkage == nullptr) {
      print("disc on disc", peer, "not installed: " + peer.package);
    } else if (peer.discs == nullptr) {
      print("disc on disc", peer, "not compared: contacts of solids in space only");
    } else {
      print("disc on disc", peer,
            measure(
                *peer.discs(discs), [&](double angle) { return discs_at(discs, angle); }, true));
    }
  }
  return 0;
}

}  // namespace
}  // namespace higherpair::peers

int main() {
  return higherpair::peers::run();
}
