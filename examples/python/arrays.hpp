#pragma once
/// NumPy arrays in and out: arguments are read with their shapes checked, results are views without copies.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <Eigen/Core>
#include <array>
#include <cstring>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace rme::python {

namespace py = pybind11;

/// "(6, 7)", as NumPy writes a shape.
inline std::string shape_text(const std::vector<py::ssize_t>& shape) {
  std::string out = "(";
  for (std::size_t i = 0; i < shape.size(); ++i) out += (i > 0 ? ", " : "") + std::to_string(shape[i]);
  return out + (shape.size() == 1 ? ",)" : ")");
}

/// The Python type of an object, for messages.
inline std::string type_text(py::handle object) {
  return object.is_none() ? "None" : py::str(py::type::handle_of(object).attr("__name__"));
}

/// An array of float64 with the object's numbers: the object itself if it is one.
/// @param field  what the object is, e.g. "Estimator.update: dq"
/// @throws TypeError if these are no real numbers
inline py::array float_array(py::handle object, const char* field) {
  if (py::array_t<double>::check_(object)) return py::reinterpret_borrow<py::array>(object);
  const auto refuse = [&](const std::string& found) {
    throw py::type_error(std::string(field) + ": expected real numbers, got " + found);
  };
  if (object.is_none()) refuse("None");
  py::array any;
  try {
    any = py::array(py::reinterpret_borrow<py::object>(object));
  } catch (py::error_already_set&) {
    refuse(type_text(object));  // such as a list of lists of different lengths
  }
  const char kind = any.dtype().kind();
  if (kind != 'f' && kind != 'i' && kind != 'u')
    refuse(py::isinstance<py::array>(object) ? "dtype " + std::string(py::str(any.dtype())) : type_text(object));
  return py::array_t<double, py::array::forcecast>(any);
}

/// Reads numbers into `out`, whose size says how many there have to be: a vector of size n needs the shape (n,), a
/// matrix (rows, columns). Any strides and storage orders will do, and so will lists and other types of numbers.
/// @param field  what the object is, e.g. "Estimator.update: dq"
/// @throws TypeError if these are no real numbers; ValueError if the shape is another one
template <typename Derived>
void read(py::handle object, const char* field, Eigen::MatrixBase<Derived>& out) {
  constexpr bool vector = Derived::IsVectorAtCompileTime;
  const py::array numbers = float_array(object, field);
  const bool fits = vector ? numbers.ndim() == 1 && numbers.shape(0) == out.size()
                           : numbers.ndim() == 2 && numbers.shape(0) == out.rows() && numbers.shape(1) == out.cols();
  if (!fits) {
    const auto expected =
        vector ? std::vector<py::ssize_t>{out.size()} : std::vector<py::ssize_t>{out.rows(), out.cols()};
    throw py::value_error(std::string(field) + ": expected shape " + shape_text(expected) + ", got " +
                          shape_text({numbers.shape(), numbers.shape() + numbers.ndim()}));
  }
  const char* data = static_cast<const char*>(numbers.data());
  const py::ssize_t down = numbers.strides(0), across = vector ? 0 : numbers.strides(1);
  for (Eigen::Index j = 0; j < out.cols(); ++j)
    for (Eigen::Index i = 0; i < out.rows(); ++i)  // memcpy: an array's numbers need not be aligned
      std::memcpy(&out.coeffRef(i, j), data + i * down + j * across, sizeof(double));
}

/// One number.
/// @throws TypeError if it is none
inline double number(py::handle object, const char* field) {
  const double value = PyFloat_AsDouble(object.ptr());
  if (value == -1 && PyErr_Occurred() != nullptr) {
    PyErr_Clear();
    throw py::type_error(std::string(field) + ": expected a number, got " + type_text(object));
  }
  return value;
}

/// A whole number.
/// @throws TypeError if it is none; ValueError if it is beyond the range of int
inline int integer(py::handle object, const char* field) {
  if (PyIndex_Check(object.ptr()) == 0)
    throw py::type_error(std::string(field) + ": expected a whole number, got " + type_text(object));
  const py::ssize_t value = PyNumber_AsSsize_t(object.ptr(), nullptr);  // beyond its range: its largest or its least
  if (value < std::numeric_limits<int>::min() || value > std::numeric_limits<int>::max())
    throw py::value_error(std::string(field) + ": expected a whole number, got " + std::string(py::repr(object)));
  return static_cast<int>(value);
}

/// A NumPy array that shows `matrix` itself: of one dimension for a vector, of two for a matrix. No copy is made.
/// @param owner     keeps the matrix alive for as long as the array lives
/// @param writable  whether Python may change the numbers
template <typename Derived, typename Owner>
py::array view(const Eigen::MatrixBase<Derived>& matrix, const std::shared_ptr<Owner>& owner, bool writable) {
  static_assert(!Derived::IsRowMajor || Derived::IsVectorAtCompileTime, "view: Eigen's usual storage order");
  using Kept = std::shared_ptr<Owner>;
  const py::capsule keeper(new Kept(owner), [](void* kept) { delete static_cast<Kept*>(kept); });
  constexpr auto size = static_cast<py::ssize_t>(sizeof(double));
  const bool vector = Derived::IsVectorAtCompileTime;
  const auto shape =
      vector ? std::vector<py::ssize_t>{matrix.size()} : std::vector<py::ssize_t>{matrix.rows(), matrix.cols()};
  const auto strides = vector ? std::vector<py::ssize_t>{size} : std::vector<py::ssize_t>{size, size * matrix.rows()};
  py::array out(py::dtype::of<double>(), shape, strides, matrix.derived().data(), keeper);
  if (!writable) out.attr("setflags")(py::arg("write") = false);
  return out;
}

/// A view of what an array holds, which Python may not change.
template <std::size_t Size, typename Owner>
py::array view(const std::array<double, Size>& numbers, const std::shared_ptr<Owner>& owner) {
  using Kept = std::shared_ptr<Owner>;
  const py::capsule keeper(new Kept(owner), [](void* kept) { delete static_cast<Kept*>(kept); });
  py::array out(py::dtype::of<double>(), {static_cast<py::ssize_t>(Size)}, {}, numbers.data(), keeper);
  out.attr("setflags")(py::arg("write") = false);
  return out;
}

}  // namespace rme::python
