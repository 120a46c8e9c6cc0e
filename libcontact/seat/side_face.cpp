#include "libcontact/seat/side_face.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "libcontact/base/constants.hpp"
#include "libcontact/base/linear/solve.hpp"
#include "libcontact/seat/ring_element.hpp"
#include "libcontact/seat/side_face_mesh.hpp"

namespace contact::detail {
namespace {

using Eigen::MatrixXd;

// The two parts of the body: the remaining part, and the part cut off by the
// side faces.
enum Part { left, cut_off };

// Numbering of the displacements of one part, column by column, so that its
// stiffness has blocks on only three diagonals; displacements of the faces
// between the parts are numbered separately.
class Numbering {
 public:
  Numbering(const SideFaceMesh& mesh, int m)
      : mesh_(mesh), lines_(2 * mesh.rows() + 1) {
    const int count = 2 * mesh.columns() + 1;
    for (auto& used : used_) used = Eigen::ArrayXXi::Zero(count, lines_);
    for (int c = 0; c < mesh.columns(); ++c) {
      for (int r = 0; r < mesh.rows(); ++r) {
        used_[mesh.is_cut_off(c, r)].block<3, 3>(2 * c, 2 * r) = 1;
      }
    }
    face_ = Eigen::ArrayXXi::Constant(count, 3 * lines_, -1);
    for (const Part part : {left, cut_off}) {
      place_[part] = face_;
      size_[part].assign(mesh.columns(), 0);
    }
    for (int i = 0; i < count; ++i) {
      for (int j = 0; j < lines_; ++j) {
        if (i % 2 == 1 && j % 2 == 1) continue;
        for (int k = 0; k < 3; ++k) number(i, j, k, m);
      }
    }
  }

  static int block(int i) { return i == 0 ? 0 : (i - 1) / 2; }
  /// In its block; -1 if it is held, not there, or of a face.
  int place(Part part, int i, int j, int k) const {
    return place_[part](i, 3 * j + k);
  }
  int face(int i, int j, int k) const { return face_(i, 3 * j + k); }
  int faces() const { return faces_; }
  const std::vector<int>& sizes(Part part) const { return size_[part]; }

 private:
  // On the axis what is alike in all longitudes is W for m = 0, and for m = 1
  // what is across it.
  bool is_held(int i, int j, int k, int m) const {
    if (mesh_.is_held(j)) return true;
    const bool on_axis = i == 0 || i == 2 * mesh_.columns();
    if (!on_axis) return false;
    return m == 0 ? k != 1 : m == 1 ? k == 1 : true;
  }
  void number(int i, int j, int k, int m) {
    if (is_held(i, j, k, m)) return;
    const bool is_face = used_[left](i, j) && used_[cut_off](i, j);
    if (is_face) face_(i, 3 * j + k) = faces_++;
    for (const Part part : {left, cut_off}) {
      if (!used_[part](i, j) || (part == cut_off && is_face)) continue;
      place_[part](i, 3 * j + k) = size_[part][block(i)]++;
    }
  }

  const SideFaceMesh& mesh_;
  int lines_;
  Eigen::ArrayXXi used_[2], place_[2], face_;
  std::vector<int> size_[2];
  int faces_ = 0;
};

// Stiffness of a part in its blocks, with the loads of the solution; the loads
// of the faces come first.
struct Blocks {
  Blocks(const std::vector<int>& sizes, int loads) {
    for (std::size_t k = 0; k < sizes.size(); ++k) {
      diagonal.push_back(MatrixXd::Zero(sizes[k], sizes[k]));
      below.push_back(MatrixXd::Zero(sizes[k], k == 0 ? 0 : sizes[k - 1]));
      load.push_back(MatrixXd::Zero(sizes[k], loads));
    }
  }
  std::vector<MatrixXd> diagonal, below, load;

  // F^T K^-1 (F, P) of all loads (F, P), F the first ones. Loads come in the
  // order of their blocks: those that have not begun are 0.
  MatrixXd products(int faces) {
    const Eigen::Index all = load.front().cols();
    MatrixXd sum = MatrixXd::Zero(faces, all);
    Eigen::Index f = 0, p = 0;
    for (std::size_t k = 0; k < diagonal.size(); ++k) {
      if (diagonal[k].size() == 0) continue;
      f = begun(load[k].leftCols(faces), f);
      p = begun(load[k].rightCols(all - faces), p);
      auto of_faces = load[k].leftCols(f);
      auto others = load[k].middleCols(faces, p);
      factor_positive(diagonal[k]);
      solve_lower(diagonal[k], of_faces);
      solve_lower(diagonal[k], others);
      sum.topLeftCorner(f, f).noalias() += of_faces.transpose() * of_faces;
      sum.block(0, faces, f, p).noalias() += of_faces.transpose() * others;
      if (k + 1 == diagonal.size() || below[k + 1].size() == 0) continue;
      MatrixXd w = below[k + 1].transpose();
      solve_lower(diagonal[k], w);
      diagonal[k + 1].noalias() -= w.transpose() * w;
      load[k + 1].leftCols(f).noalias() -= w.transpose() * of_faces;
      load[k + 1].middleCols(faces, p).noalias() -= w.transpose() * others;
    }
    return sum;
  }

 private:
  // Columns up to the last one that is not 0.
  static Eigen::Index begun(const Eigen::Ref<const MatrixXd>& loads,
                            Eigen::Index before) {
    Eigen::Index count = loads.cols();
    while (count > before && loads.col(count - 1).isZero(0)) --count;
    return count;
  }
};

// One element after the other of a part.
template <typename Take>
void for_elements(const SideFaceMesh& mesh, int m, Part part, double unit,
                  const Take& take) {
  // Corners anticlockwise in (x, z), where columns run clockwise.
  constexpr int across[] = {0, 0, 2, 2, 0, 1, 2, 1};
  constexpr int out[] = {0, 2, 2, 0, 1, 2, 1, 0};
  for (int c = 0; c < mesh.columns(); ++c) {
    for (int r = 0; r < mesh.rows(); ++r) {
      if (mesh.is_cut_off(c, r) != (part == cut_off)) continue;
      RingElementNodes nodes;
      std::array<std::array<int, 2>, 8> at;
      for (int n = 0; n < 8; ++n) {
        at[n] = {2 * c + across[n], 2 * r + out[n]};
        nodes.row(n) = mesh.node(at[n][0], at[n][1]).transpose();
      }
      take(at, ring_stiffness(nodes, m, mesh.material(r), unit));
    }
  }
}

// The stiffness of a part: to its blocks, and between faces to face_stiffness.
void assemble(const SideFaceMesh& mesh, const Numbering& number, int m,
              Part part, double unit, Blocks& blocks,
              MatrixXd& face_stiffness) {
  struct Place {
    int block, place, face;
  };
  for_elements(mesh, m, part, unit, [&](const auto& at, const auto& stiff) {
    std::array<Place, 24> of;
    for (int n = 0; n < 24; ++n) {
      const auto [i, j] = at[n / 3];
      of[n] = {Numbering::block(i), number.place(part, i, j, n % 3),
               part == cut_off ? number.face(i, j, n % 3) : -1};
    }
    for (int a = 0; a < 24; ++a) {
      for (int b = 0; b < 24; ++b) {
        const Place &row = of[a], &column = of[b];
        const double k = stiff(a, b);
        if (row.place >= 0 && column.place >= 0) {
          if (row.block == column.block) {
            blocks.diagonal[row.block](row.place, column.place) += k;
          } else if (row.block > column.block) {
            blocks.below[row.block](row.place, column.place) += k;
          }
        } else if (row.place >= 0 && column.face >= 0) {
          blocks.load[row.block](row.place, column.face) += k;
        } else if (row.face >= 0 && column.face >= 0) {
          face_stiffness(row.face, column.face) += k;
        }
      }
    }
  });
}

// dA_m by nodes of the seat, in units of rho/E.
MatrixXd difference(const SideFaceMesh& mesh, int m, double unit) {
  const Numbering number(mesh, m);
  const int faces = number.faces();
  const int first = 2 * mesh.first(), nodes = 2 * mesh.last() + 3 - first;
  Blocks body(number.sizes(left), faces + nodes);
  MatrixXd unused, stiffness = MatrixXd::Zero(faces, faces);
  assemble(mesh, number, m, left, unit, body, unused);
  for (int i = 0; i <= 2 * mesh.columns(); ++i) {
    MatrixXd& load = body.load[Numbering::block(i)];
    for (int j = 0; j <= 2 * mesh.rows(); ++j) {
      for (int k = 0; k < 3; ++k) {
        const int face = number.face(i, j, k);
        if (face >= 0) load(number.place(left, i, j, k), face) = 1;
      }
    }
    if (i < first || i >= first + nodes) continue;
    const double v = mesh.seat_angle(i);
    const double outwards[] = {std::sin(v), std::cos(v)};
    for (int k = 0; k < 2; ++k) {
      const int place = number.place(left, i, 0, k);
      if (place >= 0) load(place, faces + i - first) = outwards[k];
    }
  }
  const MatrixXd solved = body.products(faces);
  const auto yielding = solved.leftCols(faces);    // H
  const MatrixXd shown = solved.rightCols(nodes);  // G
  Blocks rest(number.sizes(cut_off), faces);
  assemble(mesh, number, m, cut_off, unit, rest, stiffness);
  stiffness -= rest.products(faces);  // S
  MatrixXd both = stiffness * yielding;
  both.diagonal().array() += 1;
  const MatrixXd more =
      shown.transpose() * solve_square(both, stiffness * shown);
  return (more + more.transpose()) / 2;
}

}  // namespace

SideFaceCompliance::SideFaceCompliance(const LayeredPair& pair,
                                       const SeatZone& zone, int order,
                                       double coarser) {
  const SideFaceMesh mesh(pair, zone, coarser);
  const int first = 2 * mesh.first(), count = 2 * mesh.last() + 3 - first;
  nodes_.resize(count);
  for (int i = 0; i < count; ++i) nodes_(i) = mesh.seat_angle(first + i);
  // The last step may be a fifth longer.
  for (int m = 0; 6 * m < 5 * order; m = std::max(m + 1, m * 5 / 3)) {
    orders_.push_back(m);
  }
  orders_.push_back(order);
  for (const int m : orders_) {
    matrix_.push_back(difference(mesh, m, pair.surfaces().effective_modulus()) /
                      4);
  }
}

// Interpolates between solved orders by the cubic through four of them over the
// logarithm of m + 1. Within 6e-3 of the largest, compared with all orders of a
// cup, a ring and a liner.
void SideFaceCompliance::for_parts(
    int m, const std::function<void(double, std::size_t)>& take) const {
  const auto at = std::lower_bound(orders_.begin(), orders_.end(), m);
  const auto above = static_cast<std::size_t>(at - orders_.begin());
  if (*at == m) return take(1, above);
  const std::size_t first = above - std::min<std::size_t>(above, 2);
  const std::size_t end = std::min(above + 2, orders_.size());
  for (std::size_t k = first; k < end; ++k) {
    double part = 1;
    for (std::size_t l = first; l < end; ++l) {
      if (l == k) continue;
      part *= std::log((m + 1.0) / (orders_[l] + 1)) /
              std::log((orders_[k] + 1.0) / (orders_[l] + 1));
    }
    take(part, k);
  }
}

// The first of three nodes about a polar angle, and their functions N_b there.
SideFaceCompliance::Node SideFaceCompliance::node(double angle) const {
  const double* begin = nodes_.data();
  const auto above = std::upper_bound(begin, begin + nodes_.size(), angle);
  const Eigen::Index b = std::clamp<Eigen::Index>((above - begin - 1) / 2 * 2,
                                                  0, nodes_.size() - 3);
  const double x = (angle - nodes_(b + 1)) / (nodes_(b + 2) - nodes_(b + 1));
  return {b, {x * (x - 1) / 2, (1 - x) * (1 + x), x * (x + 1) / 2}};
}

// ∫ w_i N_b sin v dv of each cell i with the functions N_b of the nodes.
MatrixXd SideFaceCompliance::shares(const SeatCells& cells) const {
  const SeatCells::Rule rule = cells.rule(0);
  MatrixXd share = MatrixXd::Zero(nodes_.size(), cells.size());
  for (Eigen::Index k = 0; k < rule.cell.size(); ++k) {
    const auto [b, values] = node(rule.angle(k));
    share.col(rule.cell(k)).segment<3>(b) += rule.weight(k) * values.matrix();
  }
  return share;
}

Eigen::VectorXd SideFaceCompliance::under(
    const std::vector<Point>& points) const {
  const int order = orders_.back();
  // Cosines over a turn have the square pi; 2 pi for m = 0.
  const auto cosine = [](int m, const Point& point) {
    return m == 0 ? std::sqrt(0.5) : std::cos(m * point.longitude);
  };
  MatrixXd share = MatrixXd::Zero(nodes_.size(), order + 1), more = share;
  for (const Point& point : points) {
    const auto [b, values] = node(point.angle);
    for (int m = 0; m <= order; ++m) {
      share.col(m).segment<3>(b) +=
          point.force * cosine(m, point) / pi * values.matrix();
    }
  }
  for (int m = 0; m <= order; ++m) {
    for_parts(m, [&](double part, std::size_t k) {
      more.col(m) += part * (matrix_[k] * share.col(m));
    });
  }
  Eigen::VectorXd u = Eigen::VectorXd::Zero(points.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto [b, values] = node(points[k].angle);
    for (int m = 0; m <= order; ++m) {
      u(k) +=
          cosine(m, points[k]) * more.col(m).segment<3>(b).dot(values.matrix());
    }
  }
  return u;
}

std::vector<MatrixXd> SideFaceCompliance::on(const SeatCells& cells) const {
  const MatrixXd share = shares(cells);
  std::vector<MatrixXd> solved;
  for (const MatrixXd& by_nodes : matrix_) {
    solved.push_back(share.transpose() * by_nodes * share);
  }
  std::vector<MatrixXd> all(orders_.back() + 1,
                            MatrixXd::Zero(cells.size(), cells.size()));
  for (int m = 0; m <= orders_.back(); ++m) {
    for_parts(m,
              [&](double part, std::size_t k) { all[m] += part * solved[k]; });
  }
  return all;
}

}  // namespace contact::detail
