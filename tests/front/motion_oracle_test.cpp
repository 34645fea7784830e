#include "contact/oracle_case.hpp"
#include "higherpair/higherpair.hpp"

#include <cmath>
#include <map>

#include <fmt/ranges.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::OracleCase;

std::string conic_text(const nlohmann::json& conic, Side side) {
  const auto k = conic.at("coef").get<std::array<double, 6>>();
  if (conic.at("kind") == "line") {
    const double scale = -k[5] / (k[3] * k[3] + k[4] * k[4]);
    return fmt::format("{{ type = \"line\", point = [{}, {}], normal = [{}, {}] }}", scale * k[3],
                       scale * k[4], k[3], k[4]);
  }
  return fmt::format("{{ type = \"conic\", coefficients = [{}], side = \"{}\" }}", fmt::join(k, ", "),
                     side == Side::kOutside ? "outside" : "inside");
}

// The case as a user would write it, with an approximate pose of the follower.
std::string profile_text(const OracleCase& reference) {
  const nlohmann::json& data = reference.data;
  const auto o1 = testing::vector_of(data.at("body1").at("origin"));
  const auto o2 = testing::vector_of(data.at("body2").at("origin"));
  const auto e = testing::vector_of(data.at("interest_point_local"));
  const bool turns = data.at("body2").at("mode") == "rot";
  const double q = data.at("start").at("q2_near").get<double>();
  const double rough = q + 1e-3 * (1 + std::abs(q));
  std::string text =
      fmt::format("units = {{ length = \"{}\", angle = \"rad\" }}\n", data.at("units").get<std::string>());
  text += fmt::format("[bodies.ground]\npoints.A = [{}, {}]\npoints.B = [{}, {}]\n", o1.x(), o1.y(), o2.x(),
                      o2.y());
  text += fmt::format("[bodies.driver]\npoints.O = [0, 0]\ncurves.c = {}\n",
                      conic_text(data.at("body1").at("conic"), reference.pair.curve1.side));
  text += fmt::format("[bodies.follower]\npoints.O = [0, 0]\npoints.E = [{}, {}]\ncurves.c = {}\n", e.x(),
                      e.y(), conic_text(data.at("body2").at("conic"), reference.pair.curve2.side));
  if (turns) {
    text += fmt::format("pose = {{ x = {}, y = {}, angle = {} }}\n", o2.x(), o2.y(), rough);
  } else {
    const auto d = testing::vector_of(data.at("body2").at("direction"));
    text += fmt::format("pose = {{ x = {}, y = {} }}\n", o2.x() + rough * d.x(), o2.y() + rough * d.y());
  }
  text += "[joints.a]\ntype = \"revolute\"\nbetween = [\"ground.A\", \"driver.O\"]\n";
  if (turns) {
    text += "[joints.b]\ntype = \"revolute\"\nbetween = [\"ground.B\", \"follower.O\"]\n";
  } else {
    const auto d = testing::vector_of(data.at("body2").at("direction"));
    text += fmt::format(
        "[joints.b]\ntype = \"prismatic\"\nbetween = [\"ground.B\", \"follower.O\"]\ndirection = [{}, {}]\n",
        d.x(), d.y());
  }
  text += "[contacts.k]\nbetween = [\"driver.c\", \"follower.c\"]\n";
  std::vector<double> positions = {data.at("th1_start_deg").get<double>() * kPi / 180};
  for (const auto& row : data.at("rows")) {
    positions.push_back(row.at("th1"));
  }
  text += fmt::format("[driver]\njoint = \"a\"\nvelocity = {}\nacceleration = {}\npositions = [{}]\n",
                      data.at("omega1").get<double>(), data.at("alpha1").get<double>(),
                      fmt::join(positions, ", "));
  return text;
}

using NamedRow = std::map<std::string, double>;

NamedRow named(const std::vector<Column>& columns, const higherpair::Row& row) {
  NamedRow named;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (!std::isnan(row.values[i])) {
      named[columns[i].name] = row.values[i];
    }
  }
  return named;
}

// |error| <= 1e-10 max(|value|, scale) + 20 times the case's own noise.
void expect_near(const NamedRow& row, const std::string& column, const nlohmann::json& value, double scale,
                 double noise) {
  if (value.is_null()) {
    EXPECT_FALSE(row.contains(column)) << column;
    return;
  }
  ASSERT_TRUE(row.contains(column)) << column;
  const double expected = value;
  const double error = std::abs(row.at(column) - expected);
  EXPECT_TRUE(error <= 1e-10 * std::max(std::abs(expected), scale) + 20 * noise)
      << column << " = " << row.at(column) << ", expected " << expected << ", error " << error;
}

TEST(MotionOracle, AgreesInEveryColumnWithTheIndependentAnswers) {
  for (const OracleCase& reference : testing::oracle_cases()) {
    SCOPED_TRACE(reference.id);
    const nlohmann::json& data = reference.data;
    const auto model = Model::from_text(profile_text(reference), reference.id);
    ASSERT_TRUE(model.has_value()) << to_string(model.error());
    auto analysis = model->start();
    ASSERT_TRUE(analysis.has_value()) << to_string(analysis.error());
    double arc1 = 0;
    double arc2 = 0;
    higherpair::Row line;
    for (std::int64_t k = 0; analysis->next(line); ++k) {
      ASSERT_EQ(line.status, RowStatus::kOk);
      const NamedRow row = named(analysis->columns(), line);
      if (k == 0) {
        continue;
      }
      const nlohmann::json& expected = data.at("rows").at(static_cast<std::size_t>(k - 1));
      if (k == 1) {
        arc1 = row.at("k.arc1");
        arc2 = row.at("k.arc2");
      }
      SCOPED_TRACE(expected.at("th1_deg").dump());
      const auto noise = [&](std::size_t i) {
        const auto& values = expected.at("noise");
        return values.is_null() || values.at(i).is_null() ? 1e-8 : values.at(i).get<double>();
      };
      const bool turns = data.at("body2").at("mode") == "rot";
      const double omega1 = data.at("omega1");
      const double size = std::abs(expected.at("P").at(0).get<double>()) +
                          std::abs(expected.at("P").at(1).get<double>()) +
                          std::abs(expected.at("rho1").is_null() ? 0 : expected.at("rho1").get<double>());
      const double noise_p = noise(0) * size;
      expect_near(row, "b.position", expected.at("q2"), 1, noise(0));
      expect_near(row, "b.velocity", expected.at(turns ? "omega2" : "v2"), 1, noise(1) * std::abs(omega1));
      expect_near(row, "b.acceleration", expected.at(turns ? "alpha2" : "a2"), 1, noise(2) * omega1 * omega1);
      expect_near(row, "k.x", expected.at("P").at(0), size, noise_p);
      expect_near(row, "k.y", expected.at("P").at(1), size, noise_p);
      expect_near(row, "k.rho1", expected.at("rho1"), size, noise_p);
      expect_near(row, "k.rho2", expected.at("rho2"), size, noise_p);
      for (const auto& [column, key] : {std::pair{"k.c1", "C1"}, {"k.c2", "C2"}}) {
        const nlohmann::json& center = expected.at(key);
        expect_near(row, std::string(column) + "x", center.is_null() ? center : center.at(0), size, noise_p);
        expect_near(row, std::string(column) + "y", center.is_null() ? center : center.at(1), size, noise_p);
      }
      EXPECT_LE((unit_vector(row.at("k.normal")) - testing::vector_of(expected.at("n"))).norm(),
                1e-10 + 20 * noise(0));
      expect_near(row, "k.sliding", expected.at("v_slide"), size * std::abs(omega1),
                  noise(1) * size * std::abs(omega1));
      expect_near(row, "k.pressure", expected.at("pressure_angle"), 1, noise(0));
      expect_near(row, "k.transmission", expected.at("transmission_angle"), 1, noise(0));
      EXPECT_LE(std::abs(row.at("k.arc1") - arc1 - expected.at("s1").get<double>()),
                1e-9 * size + 100 * noise_p);
      EXPECT_LE(std::abs(row.at("k.arc2") - arc2 - expected.at("s2").get<double>()),
                1e-9 * size + 100 * noise_p);
      expect_near(row, "follower.E.x", expected.at("P4").at(0), size, noise_p);
      expect_near(row, "follower.E.vy", expected.at("v4").at(1), size * std::abs(omega1),
                  noise(1) * size * std::abs(omega1));
      expect_near(row, "follower.E.ax", expected.at("a4").at(0), size * omega1 * omega1,
                  noise(2) * size * omega1 * omega1);
      expect_near(row, "follower.E.ay", expected.at("a4").at(1), size * omega1 * omega1,
                  noise(2) * size * omega1 * omega1);
    }
  }
}

}  // namespace
}  // namespace higherpair
