#include "laws.hpp"
#include "point_table.hpp"
#include "text_file.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace higherpair::io_detail {
namespace {

// Segments that miss one turn by less than this, relative to a turn, are one: degrees as decimals of radians.
constexpr double kOneTurn = 1e-6;

constexpr std::int64_t kFewestForOpenTurn = 8;  // points of which the last is a step short of the turn

class LawReader {
public:
  LawReader(TableReader& table, const LawQuantities& quantities)
      : table_(table), reading_(table.reading()), quantities_(quantities) {}

  std::optional<ReadLaw> read() {
    const std::size_t mistakes = reading_.mistakes.size();
    const auto segments = table_.take("segments");
    const auto points = table_.take("points");
    const auto file = table_.take("file");
    const int given = int(segments.has_value()) + int(points.has_value()) + int(file.has_value());
    if (given != 1) {
      reading_.mistakes.push_back(
          {table_.mark(), fmt::format("{}: expected one of `segments`, `points` and `file`", table_.path())});
      return std::nullopt;
    }
    if (const auto repeat = table_.take("repeat")) {
      repeat_ = as_flag(reading_, *repeat);
    }
    if (segments) {
      read_segments(*segments);
    } else {
      points ? read_points_of(*points) : read_file(*file);
      read_spline();
    }
    table_.finish();
    if (reading_.mistakes.size() > mistakes) {
      return std::nullopt;
    }
    segments ? close_segments() : close_points(points ? *points : *file);
    if (reading_.mistakes.size() > mistakes || !check(segments, points, file)) {
      return std::nullopt;
    }
    return std::move(law_);
  }

private:
  [[nodiscard]] bool turns() const { return quantities_.coordinate == dimension::kAngle; }
  [[nodiscard]] double turn() const { return from_si(dimension::kAngle, reading_.units).apply(2 * kPi); }

  void set(const std::string& key, double LawDescription::*member, const Expected& expected) {
    const auto item = table_.take(key);
    if (const auto quantity = item ? as_quantity(reading_, *item, expected) : std::nullopt) {
      law_.profile.*member = quantity->profile;
      law_.si.*member = quantity->si;
    }
  }

  void read_segments(const Item& item) {
    set("origin", &LawDescription::origin, {quantities_.coordinate});
    set("start", &LawDescription::start, {quantities_.value});
    const auto* items = std::get_if<Array>(&item.value->content);
    if (items == nullptr || items->empty()) {
      report(reading_, item,
             "expected a list of segments, [{ over = 120, law = \"cycloidal\", rise = 20 }, ...]");
      return;
    }
    for (std::size_t i = 0; i < items->size(); ++i) {
      const Item segment{&(*items)[i], fmt::format("{}.{}", item.path, i)};
      law_.profile.segments.emplace_back();
      law_.si.segments.emplace_back();
      if (const Table* content = as_table(reading_, segment, "a segment (a table)")) {
        TableReader table(reading_, *content, segment.value->mark, segment.path);
        read_segment(table);
      }
    }
  }

  [[nodiscard]] LawSegment& profile() { return law_.profile.segments.back(); }
  [[nodiscard]] LawSegment& si() { return law_.si.segments.back(); }

  void set(TableReader& table, const std::string& key, double LawSegment::*member, const Expected& expected,
           std::string_view missing) {
    const auto item = missing.empty() ? table.take(key) : table.need(key, missing);
    if (const auto quantity = item ? as_quantity(reading_, *item, expected) : std::nullopt) {
      profile().*member = quantity->profile;
      si().*member = quantity->si;
    }
  }

  void read_segment(TableReader& table) {
    static const std::vector<std::string> names(kLawNames.begin(), kLawNames.end());
    set(table, "over", &LawSegment::over, {quantities_.coordinate, Sign::kPositive},
        "the length of the segment");
    const auto item = table.need("law", "the name of a law, \"cycloidal\"");
    const auto choice = item ? as_choice(reading_, *item, names) : std::nullopt;
    if (!choice) {
      return;
    }
    const auto type = static_cast<LawType>(*choice);
    profile().type = si().type = type;
    const bool polynomial = type == LawType::kPolynomial;
    const bool harmonics = type == LawType::kHarmonics;
    const bool must_rise = !polynomial && !harmonics && type != LawType::kDwell;
    set(table, "rise", &LawSegment::rise, {quantities_.value},
        must_rise ? "by how much the value grows over the segment" : "");
    for (const auto& [key, member] :
         {std::pair("start", &LawSegment::start), std::pair("end", &LawSegment::end)}) {
      polynomial ? read_conditions(table, key, member)
                 : table.refuse(key, "has a meaning for law = \"polynomial\" only");
    }
    for (const auto& [key, member] :
         {std::pair("cosines", &LawSegment::cosines), std::pair("sines", &LawSegment::sines)}) {
      harmonics ? read_amplitudes(table, key, member)
                : table.refuse(key, "has a meaning for law = \"harmonics\" only");
    }
    table.finish();
  }

  // [s, v, a, …], each in its own unit.
  void read_conditions(TableReader& table, const std::string& key, std::vector<double> LawSegment::*member) {
    const auto item =
        table.need(key, "the value there and as many derivatives as are to be given, [s, v, a, ...]");
    const auto* items = item ? std::get_if<Array>(&item->value->content) : nullptr;
    if (item && (items == nullptr || items->empty())) {
      report(reading_, *item, "expected a list, [s, v, a, ...]");
    }
    Dimension dimension = quantities_.value;
    for (std::size_t k = 0; items != nullptr && k < items->size(); ++k) {
      const Item number{&(*items)[k], fmt::format("{}.{}", item->path, k)};
      const Quantity quantity = as_quantity(reading_, number, {dimension}).value_or(Quantity{});
      (profile().*member).push_back(quantity.profile);
      (si().*member).push_back(quantity.si);
      dimension = dimension / quantities_.coordinate;
    }
  }

  void read_amplitudes(TableReader& table, const std::string& key, std::vector<double> LawSegment::*member) {
    const auto item = table.take(key);
    const auto list = item ? as_list(reading_, *item, {quantities_.value}) : std::nullopt;
    for (const Quantity& amplitude : list.value_or(std::vector<Quantity>{})) {
      (profile().*member).push_back(amplitude.profile);
      (si().*member).push_back(amplitude.si);
    }
  }

  void add_point(const Quantity& x, const Quantity& s) {
    law_.profile.points.emplace_back(x.profile, s.profile);
    law_.si.points.emplace_back(x.si, s.si);
  }

  void read_points_of(const Item& item) {
    const auto* items = std::get_if<Array>(&item.value->content);
    if (items == nullptr) {
      report(reading_, item, "expected a list of points, [[x, s], ...]");
      return;
    }
    for (std::size_t i = 0; i < items->size(); ++i) {
      const Item point{&(*items)[i], fmt::format("{}.{}", item.path, i)};
      const auto* pair = std::get_if<Array>(&point.value->content);
      if (pair == nullptr || pair->size() != 2) {
        report(reading_, point, "expected a point, [x, s]");
        continue;
      }
      const auto x = as_quantity(reading_, {&(*pair)[0], point.path + ".0"}, {quantities_.coordinate});
      const auto s = as_quantity(reading_, {&(*pair)[1], point.path + ".1"}, {quantities_.value});
      if (x && s) {
        add_point(*x, *s);
      }
    }
  }

  void read_file(const Item& item) {
    const auto name = as_text(reading_, item);
    if (!name) {
      return;
    }
    const std::string path = beside(reading_.sources.front(), *name);
    reading_.files.push_back(path);
    const auto text = read_text_file(path, "table");
    if (!text) {
      report(reading_, item, text.error());
      return;
    }
    auto table =
        read_points(*text, {{"x", "s"}, {quantities_.coordinate, quantities_.value}}, reading_.units);
    if (!table) {
      for (const std::string& mistake : table.error()) {
        report(reading_, item, mistake);
      }
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
    set("smoothing", &LawDescription::smoothing, {quantities_.value, Sign::kNotNegative});
    (void)table_.quantity("rounding", {quantities_.value, Sign::kPositive});
  }

  // Segments that add up to one turn repeat, and fill it exactly.
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

  // Points over one turn repeat; the last one may be the first one again, or a step short of it.
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

  // What only the law as a whole can show.
  bool check(const std::optional<Item>& segments, const std::optional<Item>& points,
             const std::optional<Item>& file) {
    auto made = MotionLaw::make(law_.in(quantities_.units));
    if (made) {
      law_.made = *std::move(made);
      return true;
    }
    // Numbers are named as the profile has them, unless only in SI units they have a mistake.
    const auto named = MotionLaw::make(law_.profile);
    const LawFault& fault = named ? made.error() : named.error();
    if (fault.point && file) {
      report(reading_, *file, fmt::format("line {}: {}", law_.lines[*fault.point], fault.rule));
    } else if (fault.point) {
      const Value& value = std::get<Array>(points->value->content)[*fault.point];
      report(reading_, {&value, fmt::format("{}.{}", points->path, *fault.point)}, fault.rule);
    } else if (fault.segment) {
      const Value& value = std::get<Array>(segments->value->content)[*fault.segment];
      const Item segment{&value, fmt::format("{}.{}", segments->path, *fault.segment)};
      const Value* key = find(std::get<Table>(value.content), fault.key);
      const std::string path = fault.key.empty() ? segment.path : segment.path + "." + fault.key;
      if (key != nullptr) {
        report(reading_, {key, path}, fault.rule);
      } else {
        reading_.mistakes.push_back({value.mark, path + " " + fault.rule});
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
