#include "contact/oracle_case.hpp"

#include <array>
#include <filesystem>
#include <fstream>
#include <optional>

namespace higherpair::testing {

double noise(const nlohmann::json& row, std::size_t i) {
  return row.at("noise").is_null() || row.at("noise").at(i).is_null()
             ? 1e-6
             : 20 * row.at("noise").at(i).get<double>();
}

Vector2d vector_of(const nlohmann::json& xy) {
  return {xy.at(0).get<double>(), xy.at(1).get<double>()};
}

namespace {

Curve curve_of(const nlohmann::json& body) {
  const auto k = body.at("conic").at("coef").get<std::array<double, 6>>();
  if (body.at("conic").at("kind") == "line") {
    const Vector2d normal(k[3], k[4]);
    return make_line(-k[5] / normal.squaredNorm() * normal, normal).value();
  }
  std::optional<Vector2d> near;
  if (body.at("conic").contains("branch") && body.at("conic").at("branch").is_array()) {
    near = vector_of(body.at("conic").at("branch"));
  }
  // Material where f < 0: on the outside if f is positive on the convex side.
  const Curve inside = make_conic(k, Side::kInside, near).value();
  const Vector2d inner = inside.vertex_B + 1e-3 * inside.semi_latus * inside.axis_B;
  const double f =
      (k[0] * inner.x() + k[2] * inner.y() + k[3]) * inner.x() + (k[1] * inner.y() + k[4]) * inner.y() + k[5];
  return make_conic(k, f < 0 ? Side::kInside : Side::kOutside, near).value();
}

OneFreedom freedom_of(const nlohmann::json& body) {
  OneFreedom freedom;
  freedom.turns = body.at("mode") == "rot";
  freedom.p_WO = vector_of(body.at("origin"));
  if (!freedom.turns) {
    freedom.direction_W = vector_of(body.at("direction"));
    const Vector2d turn = vector_of(body.at("orientation_cos_sin"));
    freedom.R_WB = {turn.x(), turn.y()};
    freedom.theta = angle_of(turn);
  }
  return freedom;
}

std::vector<OracleCase> read_cases() {
  std::vector<OracleCase> cases;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(HIGHERPAIR_TEST_DATA) + "/contact")) {
    const nlohmann::json data = nlohmann::json::parse(std::ifstream(entry.path()));
    const nlohmann::json& body1 = data.at("body1");
    const nlohmann::json& body2 = data.at("body2");
    cases.push_back(
        {data.at("id"), {curve_of(body1), freedom_of(body1), curve_of(body2), freedom_of(body2)}, data});
  }
  return cases;
}

}  // namespace

const std::vector<OracleCase>& oracle_cases() {
  static const std::vector<OracleCase> cases = read_cases();
  return cases;
}

}  // namespace higherpair::testing
