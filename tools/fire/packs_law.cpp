#include "packs_law.hpp"

#include "analysis/random_cam.hpp"
#include "analysis/random_mechanism.hpp"
#include "dynamics/chain_agreement.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include <fmt/ranges.h>

namespace higherpair::fire {
namespace {

using namespace higherpair::testing;

constexpr std::array<std::string_view, 8> kKinds{"rrr",      "rrp",   "rrp-slot", "rpr",
                                                 "rpr-slot", "chain", "discs",    "ovals"};
constexpr std::array kDyads{RandomGroup::kRrr, RandomGroup::kRrp, RandomGroup::kRrpS, RandomGroup::kRpr,
                            RandomGroup::kRprS};
constexpr std::size_t kRows = 17;  // more than are computed at once
constexpr double kMost = 0.999;    // fraction of the cases
constexpr double kFarthest = 2e6;  // [ulp] ten times the largest error found in a million cases

ChainAgreement try_cam(std::string_view kind, unsigned seed) {
  const bool ovals = kind == "ovals";
  const CamShape own = ovals ? CamShape::kOval : CamShape::kDisc;
  const CamShape other = seed % 3 == 0 ? CamShape::kEdge : ovals && seed % 3 == 1 ? CamShape::kDisc : own;
  Mechanism mechanism = RandomCam(seed, 1).build(own, other);
  const bool turns = mechanism.joints[0].type == JointType::kRevolute;
  const auto rows = turn(turns ? mechanism.bodies[1].guess_theta : 0.0, turns ? 0.3 : 0.05, kRows);
  Random random(seed);
  add_random_loads(mechanism, random);
  press_follower(mechanism, rows.front(), random.between(-5, 100), random);
  return agreement(mechanism, rows, true);
}

ChainAgreement try_linkage(std::string_view kind, unsigned seed) {
  const auto index = static_cast<std::size_t>(std::find(kKinds.begin(), kKinds.end(), kind) - kKinds.begin());
  const bool chain = index >= kDyads.size();
  const std::span<const RandomGroup> groups = chain ? kDyads : std::span(kDyads).subspan(index, 1);
  RandomMechanism made = RandomBuilder(seed, chain ? 8 : 4, groups).build();
  Random random(seed);
  add_random_loads(made.mechanism, random);
  return agreement(made.mechanism, turn(made.start, seed % 2 == 0 ? 0.6 : -0.3, kRows), true);
}

// What is wrong with a case; empty: nothing.
std::string fault_of(const ChainAgreement& agrees) {
  const ChainErrors& is = agrees.errors;
  if (!agrees.broken.empty()) {
    return agrees.broken;
  }
  const std::array errors{is.place, is.rate, is.second_rate, is.force};
  const bool near =
      std::all_of(errors.begin(), errors.end(), [](double error) { return error <= kFarthest; });
  return near ? "" : fmt::format("{:.3g} units in the last place from the run", fmt::join(errors, ", "));
}

// Errors of all cases: the largest, and a bound that most of them keep.
class Spread {
public:
  void see(double error) { errors_.push_back(static_cast<float>(std::isnan(error) ? INFINITY : error)); }

  [[nodiscard]] std::string text() {
    if (errors_.empty()) {
      return "-";
    }
    std::sort(errors_.begin(), errors_.end());
    const auto most = static_cast<std::size_t>(kMost * static_cast<double>(errors_.size() - 1));
    return fmt::format("{:.3g} ({:.3g})", errors_.back(), errors_[most]);
  }

private:
  std::vector<float> errors_;
};

}  // namespace

std::span<const std::string_view> chain_kinds() {
  return kKinds;
}

long try_packs(std::string_view kind, std::uint64_t seed, long first, long count) {
  const bool cam = kind == "discs" || kind == "ovals";
  long proven = 0;
  long broken = 0;
  Spread place, rate, second_rate, force;
  for (long i = first; i < first + count; ++i) {
    const auto number = static_cast<unsigned>(seed * 1000003 + static_cast<std::uint64_t>(i));
    const ChainAgreement agrees = cam ? try_cam(kind, number) : try_linkage(kind, number);
    if (const std::string fault = fault_of(agrees); !fault.empty()) {
      ++broken;
      fmt::print("# {} {}: {}\n", kind, i, fault);
      std::fflush(stdout);
    } else if (agrees.outcome == Outcome::kProven) {
      ++proven;
      place.see(agrees.errors.place);
      rate.see(agrees.errors.rate);
      second_rate.see(agrees.errors.second_rate);
      force.see(agrees.errors.force);
    }
  }
  fmt::print(
      "{}: {} cases, {} worked out by packs, {} wrong; ulps, the worst (99.9 %): places {}, rates {}, second "
      "rates {}, forces {}\n",
      kind, count, proven, broken, place.text(), rate.text(), second_rate.text(), force.text());
  std::fflush(stdout);
  return broken;
}

}  // namespace higherpair::fire
