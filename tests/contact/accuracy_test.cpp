// Measures the table of docs/accuracy.md again: no error may exceed the printed one.
#include "contact/contact_laws.hpp"
#include "contact/oracle_case.hpp"
#include "contact/pair_follower.hpp"
#include "contact/random_pairs.hpp"
#include "higherpair/contact/finder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::OracleCase;
using testing::RandomCase;

constexpr std::array<const char*, 6> kKinds = {"circle", "ellipse", "parabola", "hyperbola", "line", "point"};
constexpr std::array<const char*, 5> kColumns = {"position", "velocity", "acceleration", "closure",
                                                 "normal speed"};

std::string name_of_pair(const ContactPair& pair) {
  const auto [a, b] = std::minmax({static_cast<int>(pair.curve1.kind), static_cast<int>(pair.curve2.kind)});
  return std::string(kKinds[a]) + ", " + kKinds[b];
}

// A row of the table: bounds in the order of kColumns, negative where there is no such case.
struct TableRow {
  std::string pair;
  std::array<double, 5> bounds{};
};

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

std::vector<TableRow> table() {
  std::vector<TableRow> rows;
  std::ifstream file(std::string(HIGHERPAIR_SOURCE_DIR) + "/docs/accuracy.md");
  for (std::string line; std::getline(file, line);) {
    std::istringstream cells(line);
    std::string cell;
    std::vector<std::string> words;
    while (std::getline(cells, cell, '|')) {
      words.push_back(trimmed(cell));
    }
    if (words.size() != 7 || std::find(words[1].begin(), words[1].end(), ',') == words[1].end()) {
      continue;
    }
    TableRow& row = rows.emplace_back();
    row.pair = words[1];
    for (std::size_t i = 0; i < 5; ++i) {
      row.bounds[i] = words[i + 2] == "-" ? -1 : std::stod(words[i + 2]);
    }
  }
  return rows;
}

using Errors = std::array<double, 5>;

void raise(double& worst, double error) {
  if (!(error <= worst)) {
    worst = error;
  }
}

// Errors of q, dq and d²q, relative to max(1, |reference value|). Rows in which a rounding of the driver's
// position alone changes a value by more than 1e-14 do not measure the program and are skipped.
void measure_references(const std::string& name, Errors& worst) {
  for (const OracleCase& reference : testing::oracle_cases()) {
    if (name_of_pair(reference.pair) != name) {
      continue;
    }
    const double u = reference.data.at("th1_start_deg").get<double>() * kPi / 180;
    const FindResult found =
        find_nearest_contact(reference.pair, u, reference.data.at("start").at("q2_near"));
    ASSERT_EQ(found.status, FindStatus::kFound);
    FollowedContact track = start_track(reference.pair, found.at, found.branch);
    for (const auto& row : reference.data.at("rows")) {
      ASSERT_EQ(follow_to(track, row.at("th1")).status, TrackStatus::kOk);
      const std::array<double, 3> ours = {track.at.q, track.at.dq, track.at.d2q};
      const std::array<const char*, 3> keys = {"q2", "dq2", "d2q2"};
      for (std::size_t i = 0; i < 3; ++i) {
        const double right = row.at(keys[i]);
        const auto& noise = row.at("noise");
        const bool sharp = !noise.is_null() && !noise.at(i).is_null() &&
                           noise.at(i).get<double>() <= 1e-14 * std::max(1.0, std::abs(right));
        if (sharp) {
          raise(worst[i], std::abs(ours[i] - right) / std::max(1.0, std::abs(right)));
        }
      }
    }
  }
}

// Distance of the contact points from each other and from their curves, relative to the lengths that enter
// the contact; difference of the normal speeds, relative to the speeds.
void measure_laws(const ContactPair& pair, const ContactPosition& at, Errors& worst) {
  const testing::Standing one(pair.curve1, pair.motion1, at.u);
  const testing::Standing two(pair.curve2, pair.motion2, at.q);
  const testing::Real apart = (at.p2_W - at.p1_W).norm();
  const testing::Real off1 = std::abs(one.shape_at(testing::wide(at.p1_W)).distance);
  const testing::Real off2 = std::abs(two.shape_at(testing::wide(at.p2_W)).distance);
  raise(worst[3], double(std::max({apart, off1, off2}) / testing::length_scale(pair, at)));
  const testing::Vec p = testing::wide((at.p1_W + at.p2_W) / 2);
  const testing::Vec v1 = one.velocity(p);
  const testing::Vec v2 = testing::Real(at.dq) * two.velocity(p);
  const testing::Real speed = v1.norm() + v2.norm();
  if (speed > 0) {
    raise(worst[4], double(std::abs(testing::wide(at.n_W).dot(v2 - v1)) / speed));
  }
}

void measure_random(const std::string& name, Errors& worst) {
  testing::RandomPairs random(2027);
  for (int i = 0; i < 3000; ++i) {
    const RandomCase one = random.next();
    if (name_of_pair(one.pair) != name) {
      continue;
    }
    const FindResult found = find_nearest_contact(one.pair, one.u, one.q);
    if (found.status != FindStatus::kFound) {
      continue;
    }
    measure_laws(one.pair, found.at, worst);
    FollowedContact track = start_track(one.pair, found.at, found.branch);
    const double step = (one.pair.motion1.turns ? 1.0 : one.size) * kPi / 36;
    for (int k = 1; k <= 12; ++k) {
      if (follow_to(track, one.u + k * step).status == TrackStatus::kOk) {
        measure_laws(one.pair, track.at, worst);
      }
    }
  }
}

TEST(Accuracy, IsNoWorseThanPrinted) {
  for (const TableRow& row : table()) {
    SCOPED_TRACE(row.pair);
    Errors worst{-1, -1, -1, -1, -1};
    measure_references(row.pair, worst);
    measure_random(row.pair, worst);
    for (std::size_t i = 0; i < worst.size(); ++i) {
      EXPECT_EQ(worst[i] < 0, row.bounds[i] < 0) << kColumns[i] << ": measured " << worst[i];
      EXPECT_LE(worst[i], row.bounds[i]) << kColumns[i];
      RecordProperty(fmt::format("{}: worst {}", row.pair, i), fmt::format("{:.1e}", worst[i]));
    }
  }
}

TEST(AccuracyTable, HasEveryPairOfCurvesThatCanTouchOnce) {
  std::map<std::string, int> seen;
  for (const TableRow& row : table()) {
    ++seen[row.pair];
  }
  for (std::size_t a = 0; a < kKinds.size(); ++a) {
    for (std::size_t b = a; b < kKinds.size(); ++b) {
      const bool possible = a < 4 || a != b;
      EXPECT_EQ(seen.count(std::string(kKinds[a]) + ", " + kKinds[b]), possible ? 1U : 0U);
    }
  }
  EXPECT_EQ(seen.size(), table().size());
}

}  // namespace
}  // namespace higherpair
