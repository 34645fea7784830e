#include "plot_marks.hpp"

#include "front/tolerances.hpp"
#include "higherpair/numeric/contains.hpp"
#include "jumps.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <string>
#include <vector>

#include <fmt/ranges.h>

namespace higherpair {
namespace {

bool is_monotone(std::span<const double> values) {
  return std::none_of(values.begin(), values.end(), [](double x) { return std::isnan(x); }) &&
         (std::is_sorted(values.begin(), values.end()) || std::is_sorted(values.rbegin(), values.rend()));
}

std::string spaced(std::string_view name) {
  std::string text(name);
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

// Rows of one status that follow each other, [begin, end).
struct Stretch {
  RowStatus status;
  std::size_t begin, end;
};

std::vector<Stretch> bad_stretches(std::span<const RowStatus> statuses) {
  std::vector<Stretch> stretches;
  for (std::size_t i = 0; i < statuses.size(); ++i) {
    if (statuses[i] == RowStatus::kOk) continue;
    if (i > 0 && statuses[i - 1] == statuses[i]) {
      stretches.back().end = i + 1;
    } else {
      stretches.push_back({statuses[i], i, i + 1});
    }
  }
  return stretches;
}

// The rows between which an event is, and where between them.
struct Between {
  std::size_t before, after;
  double share;

  [[nodiscard]] double of(std::span<const double> values) const {
    return before == after ? values[after] : values[before] + share * (values[after] - values[before]);
  }
};

// The end of the drawn line that leads to the event, where it is interrupted between these rows.
Between on_line(const PlotSeries& series, Between place) {
  return contains(series.breaks, place.after) ? Between{place.before, place.before, 0} : place;
}

Between place_of(const Event& event) {
  const auto row = static_cast<std::size_t>(event.row);
  return row == 0 ? Between{0, 0, 0} : Between{row - 1, row, std::max(event.share, 0.0)};
}

// Where rows begin to have another status: at the event between `row` and the row before, else halfway.
double edge_at(std::size_t row, const Motion& motion, std::span<const double> x) {
  if (row == 0 || row == x.size()) {
    return row == 0 ? x.front() : x.back();
  }
  const auto decides = [&](const Event& event) {
    return ends_path(event.type) && static_cast<std::size_t>(event.row) == row;
  };
  const auto event = std::find_if(motion.events().begin(), motion.events().end(), decides);
  return event == motion.events().end() ? (x[row - 1] + x[row]) / 2 : place_of(*event).of(x);
}

// Events of one kind at one place are one mark.
struct Happening {
  const Event* first;
  std::vector<std::string> items;

  [[nodiscard]] std::string all_items() const { return fmt::format("{}", fmt::join(items, ", ")); }
  // For a label; the sentence has all of them.
  [[nodiscard]] std::string few_items() const {
    constexpr std::size_t kFew = 3;
    if (items.size() <= kFew) return all_items();
    return fmt::format("{}, {} and {} more", items[0], items[1], items.size() - 2);
  }
};

// Events come in the order of the path.
std::vector<Happening> happenings(const std::vector<Event>& events) {
  std::vector<Happening> all;
  for (const Event& event : events) {
    const auto is_here = [&](const Happening& other) {
      return other.first->row == event.row && std::abs(other.first->driver_si - event.driver_si) < kSameMark;
    };
    const auto elsewhere = std::find_if_not(all.rbegin(), all.rend(), is_here);
    const auto same = std::find_if(all.rbegin(), elsewhere,
                                   [&](const Happening& other) { return other.first->type == event.type; });
    if (same == elsewhere) {
      all.push_back({&event, {}});
      if (!event.item.empty()) all.back().items.push_back(event.item);
    } else if (!event.item.empty() && !same->items.empty()) {
      same->items.push_back(event.item);
    }
  }
  return all;
}

bool several_items(const std::vector<Event>& events) {
  return std::any_of(events.begin(), events.end(),
                     [&](const Event& event) { return event.item != events.front().item; });
}

}  // namespace

XColumn x_column(const ColumnValues& x) {
  return {x.values, is_monotone(x.values)};
}

void add_ranges(const Motion& motion, const XColumn& x, const ColumnValues& driver, PlotData& data) {
  for (const Stretch& stretch : bad_stretches(motion.statuses())) {
    const std::string label = spaced(name_of(stretch.status));
    if (x.monotone) {
      data.ranges.push_back(
          {edge_at(stretch.begin, motion, x.values), edge_at(stretch.end, motion, x.values), label});
    } else {
      data.notes.push_back(fmt::format("{}: {} from {:.6g} to {:.6g} {}", label, driver.name,
                                       driver[stretch.begin], driver[stretch.end - 1], driver.unit));
    }
  }
}

void add_breaks(const Motion& motion, const XColumn& x, PlotData& data) {
  const auto at = [](std::int64_t row) { return static_cast<std::size_t>(row); };
  const std::vector<std::size_t> of_x = jumps_of(x.values, motion.events(), at);
  for (PlotSeries& series : data.series) {
    const std::vector<std::size_t> of_y = jumps_of(series.y, motion.events(), at);
    std::set_union(of_x.begin(), of_x.end(), of_y.begin(), of_y.end(), std::back_inserter(series.breaks));
  }
}

void add_events(const Motion& motion, const XColumn& x, const ColumnValues& driver, PlotData& data) {
  const bool name_items = several_items(motion.events());
  for (const Happening& happening : happenings(motion.events())) {
    const Event& event = *happening.first;
    const std::string kind = spaced(name_of(event.type));
    const std::string label =
        kind + (name_items && !happening.items.empty() ? ": " + happening.few_items() : "");
    const std::string detail =
        fmt::format("{} at {} = {:.6g} {}{}{}: {}", kind, driver.name, event.driver, driver.unit,
                    happening.items.empty() ? "" : ", ", happening.all_items(), event.cause);
    const Between place = place_of(event);
    const double at = event.time && data.x.name == "time" ? *event.time
                      : data.x.name == driver.name        ? event.driver
                                                          : place.of(x.values);
    if (std::isnan(at)) continue;
    if (x.monotone) {
      data.marks.push_back({at, label, happening.all_items(), detail});
      continue;
    }
    bool labelled = false;
    for (const PlotSeries& series : data.series) {
      const Between shown = on_line(series, place);
      const double x_shown = shown.before == shown.after ? shown.of(x.values) : at;
      const double y = shown.of(series.y);
      if (std::isnan(x_shown) || std::isnan(y)) continue;
      data.points.push_back({x_shown, y, series.unit, labelled ? "" : label, happening.all_items(), detail});
      labelled = true;
    }
  }
}

}  // namespace higherpair
