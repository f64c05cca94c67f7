#include <console_bridge/console.h>
#include <urdf_parser/urdf_parser.h>

#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "io/number.hpp"

namespace urdf {

namespace {

/// An element of an XML document, without its text.
struct Element {
  std::string name;
  std::map<std::string, std::string> attributes;
  std::vector<Element> children;

  const Element* child(const std::string& wanted) const {
    for (const Element& c : children)
      if (c.name == wanted) return &c;
    return nullptr;
  }
};

[[noreturn]] void fail(const std::string& what) {
  throw std::runtime_error(what);
}

/// Reads elements and attributes; comments, declarations and text are skipped, entities left as they are.
class Xml {
 public:
  explicit Xml(std::string_view text) : rest_(text) {}

  /// The next element, or one with an empty name at the end of its parent or of the text.
  Element element() {
    for (;;) {
      rest_.remove_prefix(std::min(rest_.find('<'), rest_.size()));
      if (rest_.substr(0, 4) == "<!--")
        (void)before("-->");
      else if (rest_.substr(0, 9) == "<![CDATA[")
        (void)before("]]>");
      else if (rest_.substr(0, 2) == "<?" || rest_.substr(0, 2) == "<!")
        (void)before(">");
      else
        break;
    }
    Element out;
    if (rest_.empty() || rest_.substr(0, 2) == "</") return out;
    rest_.remove_prefix(1);
    out.name = word();
    for (skip_space(); !rest_.empty() && rest_[0] != '>' && rest_[0] != '/'; skip_space()) {
      const std::string key = word();
      skip_space();
      if (key.empty() || rest_.empty() || rest_[0] != '=') fail("no value of an attribute of <" + out.name + ">");
      rest_.remove_prefix(1);
      skip_space();
      const std::string quote(rest_.substr(0, 1));
      if (quote != "\"" && quote != "'") fail("no quotes around attribute " + key + " of <" + out.name + ">");
      rest_.remove_prefix(1);
      out.attributes[key] = before(quote);
    }
    if (before(">") == "/") return out;
    for (Element next = element(); !next.name.empty(); next = element()) out.children.push_back(next);
    if (before(">") != "</" + out.name) fail("<" + out.name + "> is not closed");
    return out;
  }

 private:
  /// Removes all up to and including `end`, and returns what was before it.
  std::string before(const std::string& end) {
    const std::size_t at = rest_.find(end);
    if (at == std::string_view::npos) fail("no " + end + " before the end");
    std::string out(rest_.substr(0, at));
    rest_.remove_prefix(at + end.size());
    while (!out.empty() && std::isspace(static_cast<unsigned char>(out.back()))) out.pop_back();
    return out;
  }
  std::string word() {
    const std::size_t size = std::min(rest_.find_first_of(" \t\r\n=>/"), rest_.size());
    std::string out(rest_.substr(0, size));
    rest_.remove_prefix(size);
    return out;
  }
  void skip_space() { rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t\r\n"), rest_.size())); }

  std::string_view rest_;
};

const std::string& text(const Element& element, const std::string& key) {
  const auto found = element.attributes.find(key);
  if (found == element.attributes.end()) fail("<" + element.name + "> has no " + key);
  return found->second;
}

double number(const Element& element, const std::string& key) {
  const auto value = rme::examples::parse_number(text(element, key));
  if (!value) fail(key + " of <" + element.name + ">: \"" + text(element, key) + "\" is not a number");
  return *value;
}
double number_or_zero(const Element& element, const std::string& key) {
  return element.attributes.count(key) > 0 ? number(element, key) : 0;
}

Vector3 vector(const Element& element, const std::string& key) {
  Vector3 out;
  out.init(text(element, key));
  return out;
}

Pose pose(const Element& parent) {
  Pose out;
  const Element* origin = parent.child("origin");
  if (!origin) return out;
  if (origin->attributes.count("xyz") > 0) out.position = vector(*origin, "xyz");
  if (origin->attributes.count("rpy") > 0) {
    const Vector3 rpy = vector(*origin, "rpy");
    out.rotation.setFromRPY(rpy.x, rpy.y, rpy.z);
  }
  return out;
}

const Element& required(const Element& parent, const std::string& name) {
  const Element* child = parent.child(name);
  if (!child) fail("<" + parent.name + " name=\"" + text(parent, "name") + "\"> has no <" + name + ">");
  return *child;
}

LinkSharedPtr link(const Element& element) {
  auto out = std::make_shared<Link>();
  out->name = text(element, "name");
  if (const Element* inertial = element.child("inertial")) {
    const Element *mass = inertial->child("mass"), *inertia = inertial->child("inertia");
    if (!mass || !inertia) fail("link " + out->name + ": <inertial> without mass or inertia");
    auto& body = *(out->inertial = std::make_shared<Inertial>());
    body.origin = pose(*inertial);
    body.mass = number(*mass, "value");
    body.ixx = number(*inertia, "ixx");
    body.ixy = number(*inertia, "ixy");
    body.ixz = number(*inertia, "ixz");
    body.iyy = number(*inertia, "iyy");
    body.iyz = number(*inertia, "iyz");
    body.izz = number(*inertia, "izz");
  }
  return out;
}

JointSharedPtr joint(const Element& element) {
  static const std::map<std::string, int> types = {{"revolute", Joint::REVOLUTE},   {"continuous", Joint::CONTINUOUS},
                                                   {"prismatic", Joint::PRISMATIC}, {"floating", Joint::FLOATING},
                                                   {"planar", Joint::PLANAR},       {"fixed", Joint::FIXED}};
  auto out = std::make_shared<Joint>();
  out->name = text(element, "name");
  const auto type = types.find(text(element, "type"));
  if (type == types.end()) fail("joint " + out->name + " has the unknown type " + text(element, "type"));
  out->type = static_cast<decltype(out->type)>(type->second);
  out->parent_to_joint_origin_transform = pose(element);
  out->parent_link_name = text(required(element, "parent"), "link");
  out->child_link_name = text(required(element, "child"), "link");
  const Element* axis = element.child("axis");
  out->axis = axis ? vector(*axis, "xyz") : Vector3(1, 0, 0);
  if (const Element* limit = element.child("limit")) {
    auto& limits = *(out->limits = std::make_shared<JointLimits>());
    limits.lower = number_or_zero(*limit, "lower");
    limits.upper = number_or_zero(*limit, "upper");
    limits.effort = number(*limit, "effort");
    limits.velocity = number(*limit, "velocity");
  } else if (out->type == Joint::REVOLUTE || out->type == Joint::PRISMATIC) {
    fail("joint " + out->name + " has no limits");
  }
  if (const Element* mimic = element.child("mimic")) {
    out->mimic = std::make_shared<JointMimic>();
    out->mimic->joint_name = text(*mimic, "joint");
  }
  return out;
}

}  // namespace

ModelInterfaceSharedPtr parseURDF(const std::string& xml) {
  try {
    const Element robot = Xml(xml).element();
    if (robot.name != "robot") fail("no <robot>");
    auto model = std::make_shared<ModelInterface>();
    model->name_ = text(robot, "name");
    for (const Element& element : robot.children) {
      if (element.name == "link") {
        const LinkSharedPtr made = link(element);
        if (!model->links_.emplace(made->name, made).second) fail("link " + made->name + " is there twice");
      } else if (element.name == "joint") {
        const JointSharedPtr made = joint(element);
        if (!model->joints_.emplace(made->name, made).second) fail("joint " + made->name + " is there twice");
      }
    }
    std::map<std::string, std::string> tree;
    model->initTree(tree);
    model->initRoot(tree);
    return model;
  } catch (const std::exception& error) {
    if (console_bridge::handler)
      console_bridge::handler->log(error.what(), console_bridge::CONSOLE_BRIDGE_LOG_ERROR, __FILE__, __LINE__);
    return nullptr;
  }
}

}  // namespace urdf
