#include "higherpair/io/coordinate.hpp"
#include "io/tables/named_file.hpp"
#include "io/tolerances.hpp"
#include "laws.hpp"

#include <cmath>

#include <fmt/core.h>

namespace higherpair::io_detail {
namespace {

constexpr std::int64_t kFewestForOpenTurn = 8;  // with fewer points the last one must close the turn

class LawReader {
public:
  LawReader(TableReader& table, const LawQuantities& quantities)
      : table_(table), reading_(table.reading()), quantities_(quantities) {}

  std::optional<ReadLaw> read() {
    const Mistakes mistakes(reading_);
    const auto segments = table_.take("segments");
    const auto points = table_.take("points");
    const auto file = table_.take("file");
    const int given = int(segments.has_value()) + int(points.has_value()) + int(file.has_value());
    if (given != 1) {
      report_whole(table_, "expected one of `segments`, `points` and `file`",
                   {table_.path_to("segments"), table_.path_to("points"), table_.path_to("file")});
      table_.knows({"repeat", "origin", "start", "degree", "smoothing", "rounding"});
      table_.finish();
      return std::nullopt;
    }
    repeat_ = table_.take("repeat", as_flag);
    if (segments) {
      read_law_segments(table_, *segments, quantities_, law_);
    } else {
      points ? read_points_of(*points) : read_file(*file);
      read_spline();
    }
    table_.finish();
    if (!mistakes.none()) {
      return std::nullopt;
    }
    segments ? close_segments() : close_points(points ? *points : *file);
    if (!mistakes.none() || !check(segments, points, file)) {
      return std::nullopt;
    }
    return std::move(law_);
  }

private:
  [[nodiscard]] bool turns() const { return quantities_.coordinate == dimension::kAngle; }
  [[nodiscard]] double turn() const { return full_turn(reading_.units); }

  void add_point(const Quantity& x, const Quantity& s) {
    law_.profile.points.emplace_back(x.profile, s.profile);
    law_.si.points.emplace_back(x.si, s.si);
  }

  void read_points_of(const Item& item) {
    const auto items = as_items(reading_, item, "a list of points, [[x, s], ...]", 0);
    for (const Item& point : items.value_or(std::vector<Item>{})) {
      const auto pair = as_items(reading_, point, "a point, [x, s]", 2, 2);
      if (!pair) {
        continue;
      }
      const auto x = as_quantity(reading_, pair->front(), {quantities_.coordinate});
      const auto s = as_quantity(reading_, pair->back(), {quantities_.value});
      if (x && s) {
        add_point(*x, *s);
      }
    }
  }

  void read_file(const Item& item) {
    auto table = read_point_file(table_, item, {{"x", "s"}, {quantities_.coordinate, quantities_.value}},
                                 reading_.units);
    if (!table) {
      return;
    }
    for (const auto& [x, s] : table->points) {
      add_point(x, s);
    }
    law_.lines = std::move(table->lines);
  }

  void read_spline() {
    for (const char* key : {"origin", "start"}) {
      table_.refuse(key, "has a meaning for segments only: points have their own places");
    }
    if (const auto item = table_.take("degree")) {
      const auto degree = as_integer(reading_, *item);
      if (degree && *degree != 3 && *degree != 5) {
        report(reading_, *item, "must be 3 or 5");
      }
      law_.profile.degree = law_.si.degree = degree.value_or(5) == 3 ? 3 : 5;
    }
    if (const auto smoothing =
            table_.take("smoothing", as_quantity, {quantities_.value, Sign::kNotNegative})) {
      law_.profile.smoothing = smoothing->profile;
      law_.si.smoothing = smoothing->si;
    }
    (void)table_.quantity("rounding", {quantities_.value, Sign::kPositive});
  }

  // Segments that add up to one turn repeat; the last one is adjusted so that they fill the turn exactly.
  void close_segments() {
    const auto close = [](LawDescription& law, double turn) {
      double before = 0;
      for (std::size_t i = 0; i + 1 < law.segments.size(); ++i) {
        before += law.segments[i].over;
      }
      const bool closes = std::abs(before + law.segments.back().over - turn) <= kOneTurn * turn;
      if (closes) {
        law.segments.back().over = turn - before;
      }
      return closes;
    };
    const bool closes = turns() && close(law_.profile, turn()) && close(law_.si, 2 * kPi);
    law_.profile.repeats = law_.si.repeats = repeat_.value_or(closes);
  }

  // Points over one turn repeat; the last one may repeat the first one, or be one step short of the turn.
  void close_points(const Item& item) {
    const auto n = static_cast<std::int64_t>(law_.profile.points.size());
    if (n < 2) {
      return;
    }
    const auto& points = law_.profile.points;
    const double span = points.back().x() - points.front().x();
    const double step = points.back().x() - points[points.size() - 2].x();
    const double near = kOneTurn * turn();
    const bool whole = turns() && std::abs(span - turn()) <= near;
    const bool short_of = turns() && n >= kFewestForOpenTurn && std::abs(span + step - turn()) <= near;
    if (!repeat_.value_or(whole || short_of)) {
      return;
    }
    if (turns() && span > turn() + near) {
      report(reading_, item, "the points reach over more than one turn: a law cannot repeat every turn");
      return;
    }
    for (auto* law : {&law_.profile, &law_.si}) {
      const double full = law == &law_.profile ? turn() : 2 * kPi;
      law->repeats = true;
      law->ends = SplineEnds::kPeriodic;
      if (whole) {
        law->points.back().x() = law->points.front().x() + full;
      } else if (turns()) {
        law->period = full;
      }
    }
  }

  // Makes the law: some mistakes show only in the law as a whole.
  bool check(const std::optional<Item>& segments, const std::optional<Item>& points,
             const std::optional<Item>& file) {
    auto made = MotionLaw::make(law_.in(quantities_.units));
    if (made) {
      law_.made = *std::move(made);
      return true;
    }
    // Messages give numbers in the profile's units, unless the mistake occurs in SI units only.
    const auto named = MotionLaw::make(law_.profile);
    const LawFault& fault = named ? made.error() : named.error();
    if (fault.point && file) {
      report(reading_, *file, fmt::format("line {}: {}", law_.lines[*fault.point], fault.rule));
    } else if (fault.point) {
      const Value& value = std::get<Array>(points->value->content)[*fault.point];
      report(reading_, {&value}, fault.rule);
    } else if (fault.segment) {
      const Value& value = std::get<Array>(segments->value->content)[*fault.segment];
      const Value* key = find(std::get<Table>(value.content), fault.key);
      if (key != nullptr) {
        report(reading_, {key}, fault.rule);
      } else {
        const std::string path = path_of(reading_, {&value});
        reading_.mistakes.push_back({value.mark, fmt::format("{}{}{} {}", path, fault.key.empty() ? "" : ".",
                                                             fault.key, fault.rule)});
      }
    } else {
      reading_.mistakes.push_back(
          {table_.mark(),
           fmt::format("{}{}{}: {}", table_.path(), fault.key.empty() ? "" : ".", fault.key, fault.rule)});
    }
    return false;
  }

  TableReader& table_;
  Reading& reading_;
  LawQuantities quantities_;
  std::optional<bool> repeat_;
  ReadLaw law_;
};

}  // namespace

std::optional<ReadLaw> read_law(TableReader& table, const LawQuantities& quantities) {
  return LawReader(table, quantities).read();
}

}  // namespace higherpair::io_detail
