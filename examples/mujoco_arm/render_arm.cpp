// render_arm: where does the arm end up with a payload in its hand, without the estimator and with it?
//
// Reads the joint angles that an experiment has written, draws the last pose with the payload as a box, and around it
// the outline of the pose that the arm began in; or with --film all poses, with the outline of where the arm would be
// without a payload. Offscreen: MuJoCo draws, EGL needs no display.
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

constexpr double kRod = 0.1;                // how far the payload's box hangs below the flange in a film [m]
constexpr double kBox = 0.13, kLid = 0.02;  // height of the heaviest payload's box, and of one that weighs nothing [m]

constexpr const char* kUsage = R"(usage: rme_render_arm DIR [options]

Draws DIR/equilibrium.png from DIR/equilibrium_without.csv and DIR/equilibrium_with.csv, which rme_figure9_equilibrium
--output DIR has written: the arm at the end, without the estimator and with it, and the outline of where it began.

  --mass KG         which payload (default: the heaviest)
  --com X,Y,Z       where its box is drawn, flange axes [m] (default 0.05,0.02,0.13)
  --film RATE       instead, RATE pictures for each second of DIR/without.csv and DIR/with.csv, DIR/frames/0000.png and so
                    on, which rme_animation --output DIR has written. The box is as high as the payload is heavy; the
                    outline is DIR/nominal.csv's
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
      : model_(compile_mjcf(to_mjcf(arm, {}, true))),
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

  /// From now on the payload is a box at the end of its rod.
  /// @param height  of the box [m]; 0 for an empty hand
  void hold(double height) {
    held_ = height > 0;
    falling_.reset();
    model_->geom_size[3 * payload_ + 2] = height / 2;
    model_->geom_pos[3 * payload_ + 2] = kRod + height / 2;
  }
  /// From now on the hand is empty, and what it held with the arm at `q` [rad] is drawn on its way to the floor.
  /// @param way  how far it has fallen [m]
  void drop(const Vector& q, double way) {
    show(q, false);
    Falling box;
    std::copy_n(model_->geom_size + 3 * payload_, 3, box.size.begin());
    std::copy_n(data_->geom_xpos + 3 * payload_, 3, box.position.begin());
    std::copy_n(data_->geom_xmat + 9 * payload_, 9, box.rotation.begin());
    std::copy_n(model_->geom_rgba + 4 * payload_, 3, box.colour.begin());
    box.position[2] = std::max(box.size[2], box.position[2] - way);
    falling_ = box;
    held_ = false;
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
    for (const std::ptrdiff_t shape : {payload_, rod_})
      model_->geom_rgba[4 * shape + 3] = surroundings && held_ ? 1 : 0;
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
    if (surroundings && falling_) {
      mjvGeom& box = scene_.geoms[scene_.ngeom++];
      mjv_initGeom(&box, mjGEOM_BOX, falling_->size.data(), falling_->position.data(), falling_->rotation.data(),
                   falling_->colour.data());
      box.category = mjCAT_DYNAMIC;
    }
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

  struct Falling {
    std::array<mjtNum, 3> size, position;  // half of each edge, centre [m]
    std::array<mjtNum, 9> rotation;
    std::array<float, 4> colour = {0, 0, 0, 1};
  };

  MujocoModel model_;
  MujocoData data_;
  std::ptrdiff_t payload_, rod_;  // numbers of these shapes
  bool held_ = true;
  std::optional<Falling> falling_;
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

struct Instant {
  double t, mass;  // [s], [kg]
  Vector q;        // [rad]
};

std::vector<Instant> read_run(const std::filesystem::path& path) {
  const std::string text = read_file(path.string());
  CsvReader csv(text, path.string());
  const std::size_t t = csv.at("t"), m = csv.at("m"), q1 = csv.at("q1");
  std::vector<Instant> run;
  while (csv.next()) {
    run.push_back({csv.number(t), csv.number(m), Vector::Zero()});
    for (std::size_t j = 0; j < 7; ++j) run.back().q[static_cast<int>(j)] = csv.number(q1 + j);
  }
  if (run.empty()) throw std::runtime_error(path.string() + ": no rows");
  return run;
}

/// One run as pictures: what is in the hand, what falls out of it, and around the arm where it would be.
class Film {
 public:
  Film(Renderer& renderer, std::vector<Instant> run, std::vector<Instant> nominal)
      : renderer_(renderer), run_(std::move(run)), nominal_(std::move(nominal)) {
    if (run_.size() != nominal_.size()) throw std::runtime_error("the runs of a film must have the same rows");
    for (const Instant& instant : run_) heaviest_ = std::max(heaviest_, instant.mass);
  }

  double end() const { return run_.back().t; }  // [s]
  /// The picture at `t` [s].
  Picture at(double t) {
    const auto later = [](double time, const Instant& instant) { return time < instant.t; };
    const auto next = std::upper_bound(run_.begin(), run_.end(), t + 1e-9, later);
    const auto now = next == run_.begin() ? next : next - 1;
    // The last instant at which something was held, if that was before.
    auto held = now;
    while (held != run_.begin() && !(held->mass > 0)) --held;
    renderer_.hold(held->mass > 0 ? kLid + (kBox - kLid) * held->mass / heaviest_ : 0);
    const double fallen = now->t - held->t;
    if (fallen > 0 && held->mass > 0)
      renderer_.drop(held->q, fallen * fallen * rme::standard_gravity<double>().norm() / 2);
    return renderer_.draw(nominal_[static_cast<std::size_t>(now - run_.begin())].q, now->q);
  }

 private:
  Renderer& renderer_;
  std::vector<Instant> run_, nominal_;
  double heaviest_ = 0;  // [kg]
};

void draw_film(Renderer& renderer, const std::filesystem::path& folder, double rate) {
  const std::vector<Instant> nominal = read_run(folder / "nominal.csv");
  Film without(renderer, read_run(folder / "without.csv"), nominal);
  Film with(renderer, read_run(folder / "with.csv"), nominal);
  std::filesystem::create_directories(folder / "frames");
  for (int frame = 0; frame / rate <= without.end(); ++frame) {
    std::array<char, 16> name{};
    std::snprintf(name.data(), name.size(), "%04d.png", frame);
    without.at(frame / rate).beside(with.at(frame / rate)).write_png((folder / "frames" / name.data()).string());
  }
}

void draw_equilibrium(Renderer& renderer, const std::filesystem::path& folder, std::optional<double> mass) {
  const auto draw = [&](const char* name) {
    const Course course = read_course((folder / name).string(), mass);
    return renderer.draw(course.start, course.end);
  };
  const Picture without = draw("equilibrium_without.csv");
  without.beside(draw("equilibrium_with.csv")).write_png((folder / "equilibrium.png").string());
}

int run(Arguments& arguments) {
  const std::optional<double> mass = arguments.number("--mass"), film = arguments.number("--film");
  const std::vector<double> com = arguments.numbers("--com", 3).value_or(std::vector<double>{0.05, 0.02, 0.13});
  const std::filesystem::path folder = arguments.positional("DIR");
  arguments.finish();
  if (film && !(*film > 0 && *film <= 100))
    throw ArgumentError("--film: must be above 0 and at most 100 pictures a second");
  const OffscreenContext context;
  Renderer renderer(panda(), {com[0], com[1], com[2]});
  if (film)
    draw_film(renderer, folder, *film);
  else
    draw_equilibrium(renderer, folder, mass);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("rme_render_arm", kUsage, argc, argv, run);
}
