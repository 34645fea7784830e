// Reads drawings back as XML, with the profiles that they show.
#pragma once

#include "higherpair/higherpair.hpp"

#include <filesystem>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

namespace higherpair::testing {

struct Element {
  std::string tag, role, name, text;
  std::map<std::string, std::string> attributes;

  [[nodiscard]] double number(const std::string& key) const { return std::stod(attributes.at(key)); }
};

inline void collect(const boost::property_tree::ptree& tree, std::vector<Element>& found) {
  for (const auto& [tag, child] : tree) {
    if (tag == "<xmlattr>") continue;
    Element element;
    element.tag = tag;
    element.text = child.data();
    if (const auto attributes = child.get_child_optional("<xmlattr>")) {
      for (const auto& [key, value] : *attributes) element.attributes[key] = value.data();
    }
    element.role = element.attributes["data-role"];
    element.name = element.attributes["data-name"];
    found.push_back(element);
    collect(child, found);
  }
}

/// All elements, the top one first. Text that is not XML fails the test.
inline std::vector<Element> read_back(const std::string& svg) {
  std::istringstream in(svg);
  boost::property_tree::ptree tree;
  boost::property_tree::read_xml(in, tree);
  std::vector<Element> found;
  collect(tree, found);
  return found;
}

inline Model shipped(const std::string& name, const std::vector<std::string>& settings = {}) {
  return Model::open(HIGHERPAIR_SOURCE_DIR "/profiles/" + name + ".toml", settings).value();
}

inline std::vector<std::string> all_shipped() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(HIGHERPAIR_SOURCE_DIR "/profiles")) {
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem());
  }
  return names;
}

}  // namespace higherpair::testing
