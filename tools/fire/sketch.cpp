#include "sketch.hpp"

#include <fmt/core.h>

namespace higherpair::fire {
namespace {

std::string body_name(int body) {
  return body == 0 ? "ground" : fmt::format("b{}", body);
}

std::string outline_text(const Sketch::Outline& outline) {
  if (!outline.text.empty()) {
    return outline.text;
  }
  const auto place = [&](std::size_t i) {
    const Sketch::Point& p = outline.points[i % outline.points.size()];
    return fmt::format("[{}, {}]", p.x, p.y);
  };
  std::string items;
  for (std::size_t i = 0; i < outline.points.size(); ++i) {
    items += i == 0 ? "" : ", ";
    items += outline.spline
                 ? place(i)
                 : fmt::format(R"({{ type = "segment", from = {}, to = {} }})", place(i), place(i + 1));
  }
  return outline.spline ? fmt::format(R"({{ type = "spline", closed = true, points = [{}] }})", items)
                        : fmt::format(R"({{ type = "chain", closed = true, fillet = {}, spans = [{}] }})",
                                      outline.fillet, items);
}

std::string body_text(const Sketch::Body& body, int index) {
  std::string text = fmt::format("[bodies.{}]\n", body_name(index));
  if (index > 0) {
    text += fmt::format("pose = {{ x = {}, y = {}, angle = {} }}\n", body.x, body.y, body.angle);
  }
  for (std::size_t i = 0; i < body.points.size(); ++i) {
    text += fmt::format("points.P{} = [{}, {}]\n", i, body.points[i].x, body.points[i].y);
  }
  for (std::size_t i = 0; i < body.curves.size(); ++i) {
    text += fmt::format("curves.C{} = {}\n", i, curve_text(body.curves[i]));
  }
  for (std::size_t i = 0; i < body.outlines.size(); ++i) {
    text += fmt::format("curves.K{} = {}\n", i, outline_text(body.outlines[i]));
  }
  return text;
}

std::string between(const char* item, const Sketch::Ref& first, const char* other,
                    const Sketch::Ref& second) {
  return fmt::format("between = [\"{}.{}{}\", \"{}.{}{}\"]", body_name(first.body), item, first.item,
                     body_name(second.body), other, second.item);
}

std::string joint_text(const Sketch::Joint& joint) {
  const std::string ends = between("P", joint.first, "P", joint.second);
  const auto coupled = [&](const char* type, bool flag, const char* word) {
    return fmt::format(R"({{ type = "{}", {}, ratio = {}, carrier = "{}"{} }})", type, ends, joint.ratio,
                       body_name(joint.carrier), flag ? fmt::format(", {} = true", word) : "");
  };
  const std::string limits =
      std::isfinite(joint.from) ? fmt::format(", from = {}, to = {}", joint.from, joint.to) : "";
  switch (joint.kind) {
    case Sketch::JointKind::kRevolute:
      break;
    case Sketch::JointKind::kPrismatic:
      return fmt::format(R"({{ type = "prismatic", {}, direction = {}{} }})", ends, joint.direction, limits);
    case Sketch::JointKind::kSlot:
      return fmt::format(R"({{ type = "slot", {}, direction = {}{} }})", ends, joint.direction, limits);
    case Sketch::JointKind::kGears:
      return coupled("gears", joint.same_sense, "internal");
    case Sketch::JointKind::kBelt:
      return coupled("belt", !joint.same_sense, "crossed");
  }
  return fmt::format(R"({{ type = "revolute", {} }})", ends);
}

std::string driver_text(const Sketch& sketch, std::size_t index) {
  const Sketch::Driver& driver = sketch.drivers[index];
  std::string text = sketch.drivers.size() == 1 ? "[driver]\n" : fmt::format("[drivers.d{}]\n", index);
  if (!driver.law.empty()) {
    return text + fmt::format("joint = \"j{}\"\nlaw = \"{}\"\nsamples = 61\n", driver.joint, driver.law);
  }
  text += fmt::format("joint = \"j{}\"\nstart = {}\nvelocity = {}\nacceleration = {}\n", driver.joint,
                      driver.start, driver.velocity, driver.acceleration);
  text += fmt::format("end = {}\nsamples = 61\n", driver.end);
  return sketch.duration > 0
             ? text + fmt::format("duration = {}\ntime_step = {}\n", sketch.duration, sketch.duration / 60)
             : text;
}

}  // namespace

std::vector<double*> numbers(Sketch& sketch) {
  std::vector<double*> all;
  for (Sketch::Driver& driver : sketch.drivers) {
    all.insert(all.end(), {&driver.end, &driver.velocity, &driver.acceleration});
  }
  for (Sketch::Body& body : sketch.bodies) {
    for (Sketch::Point& point : body.points) {
      all.insert(all.end(), {&point.x, &point.y});
    }
    for (Shape& shape : body.curves) {
      all.insert(all.end(), {&shape.x, &shape.y, &shape.a, &shape.b, &shape.angle});
    }
    for (Sketch::Outline& outline : body.outlines) {
      for (Sketch::Point& point : outline.points) {
        all.insert(all.end(), {&point.x, &point.y});
      }
    }
  }
  for (Sketch::Joint& joint : sketch.joints) {
    all.push_back(&joint.direction);
  }
  for (std::size_t i = 1; i < sketch.bodies.size(); ++i) {
    Sketch::Body& body = sketch.bodies[i];
    all.insert(all.end(), {&body.x, &body.y, &body.angle});
  }
  return all;
}

std::string profile_of(const Sketch& sketch, const std::string& title) {
  std::string text = fmt::format("title = \"{}\"\n[units]\nlength = \"m\"\nangle = \"rad\"\n\n", title);
  for (std::size_t i = 0; i < sketch.bodies.size(); ++i) {
    text += body_text(sketch.bodies[i], static_cast<int>(i));
  }
  text += "\n[joints]\n";
  for (std::size_t i = 0; i < sketch.joints.size(); ++i) {
    text += fmt::format("j{} = {}\n", i, joint_text(sketch.joints[i]));
  }
  text += sketch.contacts.empty() ? "" : "\n[contacts]\n";
  for (std::size_t i = 0; i < sketch.contacts.size(); ++i) {
    const Sketch::Contact& contact = sketch.contacts[i];
    text += fmt::format("k{} = {{ {}{} }}\n", i,
                        between(contact.outlined ? "K" : "C", contact.first,
                                contact.both_outlined ? "K" : "C", contact.second),
                        contact.rolling ? ", rolling = true" : "");
  }
  for (std::size_t i = 0; i < sketch.drivers.size(); ++i) {
    text += fmt::format("\n{}", driver_text(sketch, i));
  }
  return text + sketch.tables;
}

}  // namespace higherpair::fire
