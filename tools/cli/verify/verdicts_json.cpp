#include "verify/verdicts_json.hpp"

#include "json_text.hpp"

namespace higherpair::cli {
namespace {

using Json = nlohmann::ordered_json;

Json verdict_json(const Verdict& verdict, double bound) {
  Json columns = Json::array();
  for (const ColumnCheck& check : verdict.columns) {
    columns.push_back({{"column", check.column},
                       {"at", check.key},
                       {"value", check.value},
                       {"expected", check.expected},
                       {"error", check.error}});
  }
  Json json = {{"title", verdict.title},
               {"source", verdict.source},
               {"ok", verdict.holds(bound)},
               {"seconds", verdict.seconds},
               {"columns", columns}};
  if (!verdict.failure.empty()) {
    json["failure"] = verdict.failure;
  }
  return json;
}

}  // namespace

std::string verdicts_json(const std::vector<Verdict>& verdicts, double bound) {
  Json references = Json::array();
  for (const Verdict& verdict : verdicts) {
    references.push_back(verdict_json(verdict, bound));
  }
  return document_of({{"format", 1}, {"bound", bound}, {"references", references}}, 1);
}

}  // namespace higherpair::cli
