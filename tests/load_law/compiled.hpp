#pragma once

#include <dlfcn.h>

#include <Eigen/Core>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>

// Load laws in C, compiled and loaded.
namespace contact::test {

/// Calls the C function `friction` of LoadLawText.
class CompiledLaw {
 public:
  struct Moment {
    double value, slope;
  };
  struct OfBall {
    Eigen::Vector3d moment;
    double normal_force;
    int flag;
  };

  /// @param wrappers  functions that are not static
  CompiledLaw(const std::string& text, const std::string& wrappers) {
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() /
        ("load_law_" + std::to_string(std::random_device{}()));
    std::filesystem::create_directory(folder);
    std::ofstream(folder / "law.c") << text << wrappers;
    const char* given = std::getenv("CC");
    const std::string command =
        std::string(given ? given : "cc") +
        " -std=c11 -O1 -Wall -Wextra -pedantic -Werror -shared -fPIC '" +
        (folder / "law.c").string() + "' -o '" + (folder / "law.so").string() +
        "' -lm";
    if (std::system(command.c_str()) == 0) {
      library_ = dlopen((folder / "law.so").c_str(), RTLD_NOW);
    }
    std::filesystem::remove_all(folder);
  }
  CompiledLaw(const CompiledLaw&) = delete;
  CompiledLaw& operator=(const CompiledLaw&) = delete;
  ~CompiledLaw() {
    if (library_) dlclose(library_);
  }

  /// False without a compiler for this machine.
  bool is_there() const { return library_ != nullptr; }

  Moment pin(double load, double f) const {
    Moment m{};
    m.value =
        function<double(double, double, double*)>("pin")(load, f, &m.slope);
    return m;
  }
  OfBall ball(const Eigen::Vector3d& R, const Eigen::Vector3d& w,
              double f) const {
    OfBall of{};
    of.flag =
        function<int(const double*, const double*, double, double*, double*)>(
            "ball")(R.data(), w.data(), f, of.moment.data(), &of.normal_force);
    return of;
  }
  double hold(const Eigen::Vector3d& R, const Eigen::Vector3d& m,
              double f) const {
    return function<double(const double*, const double*, double)>("hold")(
        R.data(), m.data(), f);
  }

 private:
  template <class F>
  F* function(const char* name) const {
    return reinterpret_cast<F*>(dlsym(library_, name));
  }

  void* library_ = nullptr;
};

inline constexpr const char* pin_wrapper =
    "\ndouble pin(double load, double f, double *dM) {\n"
    "  return friction(load, f, dM);\n}\n";
/// Wrapper for an adhesive pin, whose function has no f.
inline constexpr const char* adhesive_wrapper =
    "\ndouble pin(double load, double f, double *dM) {\n"
    "  (void)f;\n  return friction(load, dM);\n}\n";
inline constexpr const char* ball_wrapper =
    "\nint ball(const double *R, const double *w, double f, double *M,\n"
    "         double *normal) {\n"
    "  return friction(R, w, f, M, normal);\n}\n"
    "double hold(const double *R, const double *m, double f) {\n"
    "  return friction_hold(R, m, f);\n}\n";

}  // namespace contact::test
