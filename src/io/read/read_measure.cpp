#include "read_measure.hpp"

#include "numeric/joined_words.hpp"

#include <string>
#include <vector>

namespace higherpair::io_detail {
namespace {

std::optional<std::string> read_column(TableReader& table, Measure& measure) {
  const auto item = table.need("column", "the name of a column, such as \"follower.alpha\"");
  if (!item) {
    return std::nullopt;
  }
  measure.place = place_of(table.reading(), item->value->mark);
  measure.path = path_of(table.reading(), *item);
  auto name = as_text(table.reading(), *item);
  if (name && (name->empty() || name->find_first_of("*?[,") != std::string::npos)) {
    report(table.reading(), *item, "expected the name of one column, without its unit");
    return std::nullopt;
  }
  return name;
}

std::optional<MeasureKind> read_kind(TableReader& table) {
  const std::vector<std::string> names(kMeasureNames.begin(), kMeasureNames.end());
  const auto choice = table.need("of", "one of " + joined_words(names), as_choice, names);
  return choice ? std::optional(static_cast<MeasureKind>(*choice)) : std::nullopt;
}

}  // namespace

std::optional<Measure> read_measure(TableReader& table, const NumberUnit& place) {
  Measure measure;
  const auto column = read_column(table, measure);
  const auto kind = read_kind(table);
  std::optional<double> at = 0;
  if (kind == MeasureKind::kAt) {
    at = table.need("at", "the driver's position (in time: the time), in the profile's unit", as_number_in,
                    place);
  } else if (kind) {
    table.refuse("at", "belongs to of = \"at\"");
  } else {
    table.knows({"at"});
  }
  if (!column || !kind || !at) {
    return std::nullopt;
  }
  measure.column = *column;
  measure.of = *kind;
  measure.at = *at;
  return measure;
}

}  // namespace higherpair::io_detail
