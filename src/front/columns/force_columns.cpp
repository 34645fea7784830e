#include "column_set.hpp"
#include "higherpair/dynamics/reactions.hpp"
#include "higherpair/io/coordinate.hpp"
#include "higherpair/mechanism/driver_name.hpp"

namespace higherpair {
void add_force_columns(ColumnSet& set, const Mechanism& mechanism) {
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const Joint& joint = mechanism.joints[i];
    std::vector<NewColumn> columns = {{joint.name + ".fx", dimension::kForce},
                                      {joint.name + ".fy", dimension::kForce}};
    const bool moment = has_moment(joint.type);
    if (moment) {
      columns.push_back({joint.name + ".m", dimension::kTorque});
    }
    set.add(columns, [i, moment](const RowSource& source, double* out) {
      const JointReaction& reaction = source.reactions->joints[i];
      put(reaction.fx, out);
      put(reaction.fy, out + 1);
      if (moment) {
        put(reaction.moment, out + 2);
      }
    });
  }
  for (std::size_t i = 0; i < mechanism.contacts.size(); ++i) {
    const std::string& name = mechanism.contacts[i].name;
    set.add({{name + ".force", dimension::kForce}, {name + ".friction", dimension::kForce}},
            [i](const RowSource& source, double* out) {
              put(source.reactions->contacts[i].force, out);
              put(source.reactions->contacts[i].friction, out + 1);
            });
  }
  for (std::size_t i = 0; i < mechanism.drivers.size(); ++i) {
    const std::string name = driver_name(mechanism.drivers[i]);
    const Dimension dimension = effort_dimension(driver_turns(mechanism, i));
    set.add({{name + ".effort", dimension}, {name + ".effort_check", dimension}},
            [i](const RowSource& source, double* out) {
              put(source.reactions->drivers[i].effort, out);
              put(source.reactions->drivers[i].by_power, out + 1);
            });
  }
}

}  // namespace higherpair
