#include "higherpair/io/tasks.hpp"
#include "number_unit.hpp"
#include "read_design.hpp"
#include "reading.hpp"

#include <memory>
#include <utility>

namespace higherpair {
namespace io_detail {
namespace {

class FitReader {
public:
  FitReader(Reading& reading, const Mechanism& mechanism) : reading_(reading), mechanism_(mechanism) {}

  FitTask read(TableReader& table) {
    task_.place = place_of(reading_, table.mark());
    for_each_in_list(table, "columns", [&](TableReader& item) { read_column(item); });
    for_each_in_list(table, "frames", [&](TableReader& item) { read_frame(item); });
    if (const auto use = table.take("use")) read_use(*use);
    if (const auto loss = table.take("loss")) {
      if (const auto choice = as_choice(reading_, *loss, fit_loss_names())) {
        task_.loss = static_cast<FitLoss>(*choice);
      }
    }
    if (const auto confidence = table.take("confidence")) {
      const auto share = as_number_in(reading_, *confidence, no_unit());
      if (share && !(*share > 0 && *share < 1)) {
        report(reading_, *confidence, "expected a share between 0 and 1, such as 0.95");
      }
      task_.confidence = share.value_or(task_.confidence);
    }
    if (const auto starts = table.take("starts", as_count, {1})) task_.starts = static_cast<int>(*starts);
    task_.seed = table.take("seed", as_seed);
    table.refuse("variables", "the numbers to be found are the variables of [design], [design.variables]");
    table.finish();
    return std::move(task_);
  }

private:
  void read_column(TableReader& table) {
    FitTask::Column column;
    column.place = place_of(reading_, table.mark());
    column.path = table.path();
    if (const auto name = table.need("column", "the name of a measured column, or a glob")) {
      column.column = as_text(reading_, *name).value_or("");
    }
    column.deviation =
        table.take("deviation", as_positive_in, unit_of_column(reading_, mechanism_, column.column));
    column.weight = table.take("weight", as_positive_in, no_unit()).value_or(1);
    column.offset = table.flag("offset", false);
    task_.columns.push_back(std::move(column));
  }

  void read_frame(TableReader& table) {
    FitTask::Frame frame;
    frame.place = place_of(reading_, table.mark());
    frame.path = table.path();
    if (const auto point = table.need("point", "the point whose path was measured, \"coupler.E\"")) {
      frame.point = read_point(*point).value_or("");
    }
    if (const auto free =
            table.need("free", "what is not known of its frame, [\"position\", \"turn\", \"scale\"]")) {
      const FreePlacement placement = read_free(reading_, *free);
      frame.position = placement.position;
      frame.turn = placement.turn;
      frame.scale = placement.scale;
    }
    task_.frames.push_back(std::move(frame));
  }

  std::optional<std::string> read_point(const Item& item) {
    const auto point = as_point(reading_, item, mechanism_);
    if (!point) return std::nullopt;
    auto name = as_text(reading_, item);
    if (point->body == 0) report(reading_, item, "a point of ground does not move");
    for (const FitTask::Frame& other : task_.frames) {
      if (other.point == name) report(reading_, item, "this point has a frame already");
    }
    return name;
  }

  void read_use(const Item& item) {
    const auto items = as_items(reading_, item, "a list of names or globs of columns, [\"slider.*\"]");
    for (const Item& one : items.value_or(std::vector<Item>{})) {
      if (const auto name = as_text(reading_, one)) task_.use.push_back(*name);
    }
  }

  Reading& reading_;
  const Mechanism& mechanism_;
  FitTask task_;
};

}  // namespace

void read_fit(TableReader& root, Profile& profile) {
  if (auto table = as_reader(root.reading(), root.take("fit"), "a fit (a table)")) {
    profile.fit = std::make_shared<const FitTask>(FitReader(root.reading(), profile.mechanism).read(*table));
  }
}

}  // namespace io_detail

const std::vector<std::string>& fit_loss_names() {
  static const std::vector<std::string> names = {"squares", "huber", "tukey"};
  return names;
}

std::string_view name_of(FitLoss loss) {
  return fit_loss_names()[static_cast<std::size_t>(loss)];
}

}  // namespace higherpair
