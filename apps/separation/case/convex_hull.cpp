#include <libqhull_r/qhull_ra.h>

#include <Eigen/Geometry>
#include <cstdio>
#include <memory>

#include "libcontact/base/error.hpp"
#include "separation/case/shape.hpp"

namespace separation {
namespace {

using Eigen::Vector3d;

// One run of qhull; its own messages go nowhere.
class Qhull {
 public:
  Qhull() : silent_(std::fopen("/dev/null", "w"), &std::fclose) {
    if (!silent_) throw contact::Error("/dev/null cannot be opened");
    qh_zero(&qh_, silent_.get());
  }
  ~Qhull() {
    qh_freeqhull(&qh_, !qh_ALL);
    int left = 0;
    int total = 0;
    qh_memfreeshort(&qh_, &left, &total);
  }
  Qhull(const Qhull&) = delete;
  Qhull& operator=(const Qhull&) = delete;

  /// False if the points have no volume. Faces as triangles ("Qt").
  bool run(std::vector<double>& coordinates) {
    char command[] = "qhull Qt";
    return qh_new_qhull(&qh_, 3, static_cast<int>(coordinates.size() / 3),
                        coordinates.data(), false, command, nullptr,
                        silent_.get()) == 0;
  }
  qhT& get() { return qh_; }

 private:
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> silent_;
  qhT qh_;
};

// Only the points that faces use, and faces that look outwards.
Shape tidied(const std::vector<Vector3d>& points,
             const std::vector<std::array<int, 3>>& faces) {
  Shape shape{ShapeKind::hull};
  std::vector<int> corner(points.size(), -1);
  Vector3d inside = Vector3d::Zero();
  for (const auto& face : faces) {
    for (const int i : face) {
      if (corner[i] >= 0) continue;
      corner[i] = static_cast<int>(shape.points.size());
      shape.points.push_back(points[i]);
      inside += points[i];
    }
  }
  inside /= static_cast<double>(shape.points.size());
  for (const auto& [i, j, k] : faces) {
    const bool outwards = (points[j] - points[i])
                              .cross(points[k] - points[i])
                              .dot(points[i] - inside) > 0;
    shape.faces.push_back(
        {corner[i], corner[outwards ? j : k], corner[outwards ? k : j]});
  }
  return shape;
}

Shape hull_of(const std::vector<Vector3d>& points) {
  if (points.size() < 4) throw contact::Error("a hull needs 4 or more points");
  std::vector<double> coordinates;
  for (const Vector3d& point : points) {
    coordinates.insert(coordinates.end(), point.begin(), point.end());
  }
  Qhull qhull;
  if (!qhull.run(coordinates)) {
    throw contact::Error("the points of a hull are (nearly) in one plane");
  }
  qhT* const qh = &qhull.get();
  std::vector<std::array<int, 3>> faces;
  facetT* facet = nullptr;
  FORALLfacets {
    std::array<int, 3> face{};
    vertexT *vertex, **vertexp;
    int count = 0;
    FOREACHvertex_(facet->vertices) {
      if (count < 3) face[count++] = qh_pointid(qh, vertex->point);
    }
    faces.push_back(face);
  }
  return tidied(points, faces);
}

}  // namespace

// Studies read the same points again and again.
Shape convex_hull(const std::vector<Vector3d>& points) {
  thread_local std::vector<Vector3d> last;
  thread_local Shape hull{ShapeKind::hull};
  if (points != last || points.empty()) {
    hull = hull_of(points);
    last = points;
  }
  return hull;
}

}  // namespace separation
