#pragma once
/// The enums of rme as members of Python's enum.IntEnum, which compare with `is` and index arrays.
#include <pybind11/eval.h>
#include <pybind11/pybind11.h>

#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

namespace rme::python {

namespace py = pybind11;

/// The Python members of one enum.
template <typename Enum>
class PythonEnum {
 public:
  /// Adds the class to the module. Called once, when the module is imported.
  static void define(py::module_& module, const char* name, const char* doc,
                     std::initializer_list<std::pair<const char*, Enum>> members) {
    py::dict values;
    for (const auto& [member, value] : members) values[member] = static_cast<int>(value);
    const py::module_ python = py::module_::import("enum");
    py::object made = python.attr("IntEnum")(name, values, py::arg("module") = module.attr("__name__"));
    made.attr("__doc__") = doc;
    // "Status.Ok", not "0", in every version of Python.
    made.attr("__str__") = python.attr("Enum").attr("__str__");
    made.attr("__format__") = py::eval("lambda self, spec: format(str(self), spec)");
    for (const auto& [member, value] : members)  // never given back: they live as long as the interpreter
      known().emplace_back(value, py::object(made.attr(member)).release());
    module.attr(name) = made;
    type() = made.release();
  }
  /// The Python member.
  static py::object of(Enum value) {
    for (const auto& [known_value, member] : known())
      if (known_value == value) return py::reinterpret_borrow<py::object>(member);
    return py::none();
  }
  /// The value of a Python member.
  /// @throws TypeError if the object is none of this enum
  static Enum value_of(py::handle object, const char* field) {
    if (!py::isinstance(object, type()))
      throw py::type_error(std::string(field) + ": expected a member of " +
                           std::string(py::str(type().attr("__name__"))) + ", got " + std::string(py::repr(object)));
    return static_cast<Enum>(object.cast<int>());
  }

 private:
  static py::handle& type() {
    static py::handle handle;
    return handle;
  }
  static std::vector<std::pair<Enum, py::handle>>& known() {
    static std::vector<std::pair<Enum, py::handle>> members;
    return members;
  }
};

}  // namespace rme::python
