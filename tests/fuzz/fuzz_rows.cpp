// Any bytes as what a controller is asked for: rows of any size and order, hard and soft, poses, limits that other torques
// use up, and any numbers in between. Whatever comes, the torque keeps its limits, and a refused tick changes nothing.
#include <cstdint>
#include <rme/control/cpic.hpp>

#include "fuzz/bytes.hpp"
#include "fuzz/check.hpp"

namespace {

using fuzzing::Bytes;
using fuzzing::check;

constexpr int kJoints = 6;
using Cpic = rme::Cpic<double, kJoints>;
using Vector = Cpic::Vector;

class Host {
 public:
  Host() : cpic_(config()) {
    input_.jacobian.setIdentity();
    input_.mass_matrix.setIdentity();
    input_.bias.setZero();
    input_.wrench = {};
  }
  void run(Bytes& bytes) {
    while (!bytes.empty()) {
      switch (bytes.byte() % 8) {
        case 0:
          tick(input_);
          break;
        case 1: {  // a row; what add() refuses is not there
          const double bound = bytes.in(-5, 5);
          (void)rows_.add(direction(bytes), bound, bytes.byte() % 2 == 0 ? Cpic::Rows::kFree : bound + bytes.in(0, 2),
                          bytes.byte() % 2 == 0 ? Cpic::Rows::kHard : bytes.in(0, 100));
          break;
        }
        case 2: {  // of any numbers
          Vector a = direction(bytes);
          a[bytes.byte() % kJoints] = bytes.number<double>();
          const auto lower = bytes.number<double>(), upper = bytes.number<double>();
          (void)rows_.add(a, lower, upper, bytes.number<double>());
          break;
        }
        case 3:
          (void)rows_.add_axis(bytes.byte() % kJoints, bytes.in(-5, 0), bytes.in(0, 5));
          break;
        case 4:
          rows_.clear();
          break;
        case 5: {  // another pose, another wrench
          input_.jacobian(bytes.byte() % 6, bytes.byte() % kJoints) = bytes.in(-1, 1);
          const int j = bytes.byte() % kJoints;
          input_.mass_matrix(j, j) = bytes.in(0, 3);
          rme::Vector6<double> wrench;
          for (int i = 0; i < 6; ++i) wrench[i] = bytes.in(-50, 50);
          input_.wrench = rme::Wrench<double>::from_vector(wrench);
          break;
        }
        case 6:
          input_.other_torque[bytes.byte() % kJoints] = bytes.in(-20, 20);
          break;
        default: {  // one number replaced
          rme::CpicInput<double, kJoints> input = input_;
          const int i = bytes.byte() % (10 * kJoints);
          const auto number = bytes.number<double>();
          if (i < 6 * kJoints)
            input.jacobian.data()[i] = number;
          else if (i < 7 * kJoints)
            input.bias[i - 6 * kJoints] = number;
          else if (i < 8 * kJoints)
            input.null_torque[i - 7 * kJoints] = number;
          else if (i < 9 * kJoints)
            input.other_torque[i - 8 * kJoints] = number;
          else
            input.mass_matrix(i - 9 * kJoints, i - 9 * kJoints) = number;
          tick(input);
        }
      }
    }
  }

 private:
  static rme::CpicConfig<double, kJoints> config() {
    rme::CpicConfig<double, kJoints> config;
    config.torque_limit.setConstant(10);
    return config;
  }
  static Vector direction(Bytes& bytes) {
    Vector a;
    for (int j = 0; j < kJoints; ++j) a[j] = bytes.in(-1, 1);
    return a;
  }
  void tick(const rme::CpicInput<double, kJoints>& input) {
    const Vector before = cpic_.torque();
    const rme::Status status = cpic_.update(input, rows_);
    check(cpic_.torque().allFinite());
    if (status == rme::Status::NonFiniteInput || status == rme::Status::NotPositiveDefinite)
      check(cpic_.torque() == before);
    else if ((input.other_torque.cwiseAbs().array() <= 10).all())
      check(((cpic_.torque() + input.other_torque).cwiseAbs().array() <= 10 + 1e-9).all());
  }

  Cpic cpic_;
  Cpic::Rows rows_;
  rme::CpicInput<double, kJoints> input_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes bytes(data, size);
  Host host;
  host.run(bytes);
  return 0;
}
