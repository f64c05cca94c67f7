#include "inference/glpk_program.hpp"

#include <glpk.h>

#include <cmath>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace rme::testing {

namespace {

int kind(double lower, double upper) {
  if (lower == upper) return GLP_FX;
  if (std::isfinite(lower)) return std::isfinite(upper) ? GLP_DB : GLP_LO;
  return std::isfinite(upper) ? GLP_UP : GLP_FR;
}

}  // namespace

void GlpkProgram::Delete::operator()(glp_prob* problem) const {
  glp_delete_prob(problem);
}

GlpkProgram::GlpkProgram(int unknowns) : problem_(glp_create_prob()) {
  glp_term_out(GLP_OFF);
  glp_set_obj_dir(problem_.get(), GLP_MAX);
  glp_add_cols(problem_.get(), unknowns);
  for (int k = 1; k <= unknowns; ++k) glp_set_col_bnds(problem_.get(), k, GLP_FR, 0, 0);
}

void GlpkProgram::add_row(const Eigen::VectorXd& a, double lower, double upper) {
  const int row = glp_add_rows(problem_.get(), 1);
  std::vector<int> columns(1);
  std::vector<double> values(1);
  for (Eigen::Index k = 0; k < a.size(); ++k) {
    if (a[k] == 0) continue;
    columns.push_back(static_cast<int>(k) + 1);
    values.push_back(a[k]);
  }
  glp_set_mat_row(problem_.get(), row, static_cast<int>(columns.size()) - 1, columns.data(), values.data());
  glp_set_row_bnds(problem_.get(), row, kind(lower, upper), lower, upper);
}

void GlpkProgram::bound(int unknown, double lower, double upper) {
  glp_set_col_bnds(problem_.get(), unknown + 1, kind(lower, upper), lower, upper);
}

GlpkAnswer GlpkProgram::maximise(const Eigen::VectorXd& c, double& value) {
  for (Eigen::Index k = 0; k < c.size(); ++k) glp_set_obj_coef(problem_.get(), static_cast<int>(k) + 1, c[k]);
  glp_smcp settings;
  glp_init_smcp(&settings);
  settings.msg_lev = GLP_MSG_OFF;
  settings.tol_bnd = settings.tol_dj = 1e-10;
  const int failed = glp_simplex(problem_.get(), &settings);
  const int status = glp_get_status(problem_.get());
  if (failed) throw std::runtime_error("GLPK failed with code " + std::to_string(failed));
  if (status == GLP_NOFEAS || status == GLP_INFEAS) return GlpkAnswer::Infeasible;
  if (status == GLP_UNBND) return GlpkAnswer::Unbounded;
  if (status != GLP_OPT) throw std::runtime_error("GLPK has status " + std::to_string(status));
  value = glp_get_obj_val(problem_.get());
  return GlpkAnswer::Optimal;
}

}  // namespace rme::testing
