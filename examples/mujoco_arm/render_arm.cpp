// render_arm: where does the arm end up with a payload in its hand, without the estimator and with it?
//
// Reads the joint angles that an experiment has written, draws the last pose with the payload as a box, and around it
// the outline of the pose that the arm began in. Offscreen: MuJoCo draws, EGL needs no display.
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <mujoco_arm/mjcf.hpp>
#include <mujoco_arm/picture.hpp>
#include <optional>
#include <stdexcept>
#include <synthetic_arm/panda.hpp>
#include <vector>

#include "io/csv.hpp"
#include "io/program.hpp"

namespace {

using namespace rme::examples;
using Vector = rme::JointVector<double, 7>;

constexpr std::size_t kWidth = 1280, kHeight = 1120;  // of one arm's view, before it is halved [pixels]
constexpr Rgb kOutline = {0, 114, 178};
constexpr std::size_t kStroke = 3;  // of the outline, half of it [pixels]

constexpr const char* kUsage = R"(usage: rme_render_arm DIR [options]

Draws DIR/equilibrium.png from DIR/equilibrium_without.csv and DIR/equilibrium_with.csv, which rme_figure9_equilibrium
--output DIR has written: the arm at the end, without the estimator and with it, and the outline of where it began.

  --mass KG         which payload (default: the heaviest)
  --com X,Y,Z       where its box is drawn, flange axes [m] (default 0.05,0.02,0.13)
  --help            this text
)";

/// OpenGL without a window.
class OffscreenContext {
 public:
  /// @throws std::runtime_error if there is no OpenGL here
  OffscreenContext() : display_(eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr)) {
    require(display_ != EGL_NO_DISPLAY && eglInitialize(display_, nullptr, nullptr), "no display without a surface");
    const EGLint wanted[] = {EGL_SURFACE_TYPE,
                             EGL_PBUFFER_BIT,
                             EGL_RENDERABLE_TYPE,
                             EGL_OPENGL_BIT,
                             EGL_RED_SIZE,
                             8,
                             EGL_GREEN_SIZE,
                             8,
                             EGL_BLUE_SIZE,
                             8,
                             EGL_DEPTH_SIZE,
                             24,
                             EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    require(eglChooseConfig(display_, wanted, &config, 1, &count) && count == 1, "no suitable configuration");
    require(eglBindAPI(EGL_OPENGL_API), "no OpenGL");
    context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, nullptr);
    require(context_ != EGL_NO_CONTEXT, "no context");
    require(eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_), "no context without a surface");
  }
  OffscreenContext(const OffscreenContext&) = delete;
  OffscreenContext& operator=(const OffscreenContext&) = delete;
  ~OffscreenContext() {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
    eglTerminate(display_);
  }

 private:
  static void require(bool good, const char* what) {
    if (!good) throw std::runtime_error(std::string("EGL: ") + what);
  }
  EGLDisplay display_;
  EGLContext context_ = EGL_NO_CONTEXT;
};

class Renderer {
 public:
  /// @param com  centre of the payload's box, flange axes [m]
  Renderer(const ArmModel<7>& arm, const Eigen::Vector3d& com)
      : model_(compile_mjcf(to_mjcf(arm, {}))),
        data_(mj_makeData(model_.get())),
        payload_(mj_name2id(model_.get(), mjOBJ_GEOM, "payload")),
        rod_(mj_name2id(model_.get(), mjOBJ_GEOM, "rod")) {
    const std::array<double, 4> upright = {1, 0, 0, 0};
    std::copy(com.begin(), com.end(), model_->geom_pos + 3 * payload_);
    std::copy(upright.begin(), upright.end(), model_->geom_quat + 4 * payload_);
    mjv_defaultScene(&scene_);
    mjv_makeScene(model_.get(), &scene_, 1000);
    mjr_defaultContext(&context_);
    mjr_makeContext(model_.get(), &context_, mjFONTSCALE_100);
    mjr_setBuffer(mjFB_OFFSCREEN, &context_);
  }
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;
  ~Renderer() {
    mjr_freeContext(&context_);
    mjv_freeScene(&scene_);
  }

  /// The arm with its payload at `end`, and its outline at `start` [rad].
  Picture draw(const Vector& start, const Vector& end) {
    Picture picture = render(end);
    const std::vector<bool> shape = silhouette(start);
    const auto is_edge = [&](std::size_t x, std::size_t y) {
      const auto apart = [](std::size_t a, std::size_t b) { return static_cast<double>(a) - static_cast<double>(b); };
      for (std::size_t v = y - kStroke; v <= y + kStroke; ++v)
        for (std::size_t u = x - kStroke; u <= x + kStroke; ++u)
          if (shape[v * kWidth + u] != shape[y * kWidth + x] && std::hypot(apart(u, x), apart(v, y)) <= kStroke)
            return true;
      return false;
    };
    for (std::size_t y = kStroke; y < kHeight - kStroke; ++y)
      for (std::size_t x = kStroke; x < kWidth - kStroke; ++x)
        if (is_edge(x, y)) picture.at(x, y) = kOutline;
    return picture.halved();
  }

 private:
  static constexpr mjrRect kView = {0, 0, static_cast<int>(kWidth), static_cast<int>(kHeight)};

  /// @param surroundings  with floor, sky and payload; else the arm alone, before nothing
  void show(const Vector& q, bool surroundings) {
    std::copy(q.begin(), q.end(), data_->qpos);
    mj_forward(model_.get(), data_.get());
    for (const std::ptrdiff_t shape : {payload_, rod_}) model_->geom_rgba[4 * shape + 3] = surroundings ? 1 : 0;
    mjvOption option;
    mjv_defaultOption(&option);
    option.geomgroup[1] = surroundings;
    mjvCamera camera;
    mjv_defaultCamera(&camera);
    camera.distance = 1.4;
    camera.azimuth = 110;
    camera.elevation = -10;
    camera.lookat[0] = 0.25;
    camera.lookat[2] = 0.36;
    mjv_updateScene(model_.get(), data_.get(), &option, nullptr, &camera, mjCAT_ALL, &scene_);
    scene_.flags[mjRND_SKYBOX] = surroundings;
    mjr_render(kView, &scene_, &context_);
  }

  // OpenGL's pictures begin with the bottom row.
  Picture render(const Vector& q) {
    show(q, true);
    std::vector<unsigned char> colours(3 * kWidth * kHeight);
    mjr_readPixels(colours.data(), nullptr, kView, &context_);
    Picture picture(kWidth, kHeight);
    for (std::size_t y = 0; y < kHeight; ++y) {
      for (std::size_t x = 0; x < kWidth; ++x) {
        const unsigned char* pixel = &colours[3 * ((kHeight - 1 - y) * kWidth + x)];
        picture.at(x, y) = {pixel[0], pixel[1], pixel[2]};
      }
    }
    return picture;
  }
  std::vector<bool> silhouette(const Vector& q) {
    show(q, false);
    std::vector<float> depth(kWidth * kHeight);
    mjr_readPixels(nullptr, depth.data(), kView, &context_);
    std::vector<bool> shape(depth.size());
    for (std::size_t y = 0; y < kHeight; ++y)
      for (std::size_t x = 0; x < kWidth; ++x) shape[y * kWidth + x] = depth[(kHeight - 1 - y) * kWidth + x] < 1;
    return shape;
  }

  MujocoModel model_;
  MujocoData data_;
  std::ptrdiff_t payload_, rod_;  // numbers of these shapes
  mjvScene scene_;
  mjrContext context_;
};

struct Course {
  double mass;        // [kg]
  Vector start, end;  // [rad]
};

/// The first and the last pose of a payload.
/// @param mass  which; the heaviest if there is none
Course read_course(const std::string& path, std::optional<double> mass) {
  const std::string text = read_file(path);
  CsvReader csv(text, path);
  const std::size_t m = csv.at("m"), q1 = csv.at("q1");
  std::optional<Course> course;
  while (csv.next()) {
    const double here = csv.number(m);
    if (mass ? std::abs(here - *mass) > 1e-6 : course && here < course->mass) continue;
    Vector q;
    for (std::size_t j = 0; j < 7; ++j) q[static_cast<int>(j)] = csv.number(q1 + j);
    if (!course || here > course->mass) course = Course{here, q, q};
    course->end = q;
  }
  if (!course) throw std::runtime_error(path + ": nothing of this mass");
  return *course;
}

int run(Arguments& arguments) {
  const std::optional<double> mass = arguments.number("--mass");
  const std::vector<double> com = arguments.numbers("--com", 3).value_or(std::vector<double>{0.05, 0.02, 0.13});
  const std::filesystem::path folder = arguments.positional("DIR");
  arguments.finish();
  const OffscreenContext context;
  Renderer renderer(panda(), {com[0], com[1], com[2]});
  const auto draw = [&](const char* name) {
    const Course course = read_course((folder / name).string(), mass);
    return renderer.draw(course.start, course.end);
  };
  const Picture without = draw("equilibrium_without.csv");
  without.beside(draw("equilibrium_with.csv")).write_png((folder / "equilibrium.png").string());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("rme_render_arm", kUsage, argc, argv, run);
}
