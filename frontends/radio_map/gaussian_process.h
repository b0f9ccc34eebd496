#ifndef WALKGRAPH_FRONTENDS_RADIO_MAP_GAUSSIAN_PROCESS_H_
#define WALKGRAPH_FRONTENDS_RADIO_MAP_GAUSSIAN_PROCESS_H_

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace walkgraph {

// What one transmitter's field is trained on: the mean of the readings of one walk near one place.
struct FieldSample {
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();
  double rssi_dbm = 0;
  std::uint32_t walk = 0;
  std::uint32_t trial = 0;
};

// Matern-3/2 process over the floor around an unknown constant, plus independent noise.
struct FieldPrior {
  double length_m = 10;
  double amplitude_db = 12;
  double noise_db = 4;
  double constant_mean_dbm = -80;
  double constant_sigma_db = 10;
};

// The posterior of one transmitter's field given its samples. n samples cost O(n^3) to build.
class FieldProcess {
 public:
  FieldProcess(const std::vector<FieldSample>& samples, const FieldPrior& prior);

  // Mean (dBm) and standard deviation of a new reading (dB; noise included) at each of m positions
  // (2 x m).
  void Predict(const Eigen::Matrix2Xd& positions_m, Eigen::VectorXd* mean_dbm,
               Eigen::VectorXd* sigma_db) const;

  // The same far from all samples.
  double far_mean_dbm() const { return far_mean_dbm_; }
  double far_sigma_db() const { return far_sigma_db_; }

  // Residuals of readings over their predicted standard deviation when all samples of the trial
  // that a reading belongs to are left out. In the order of the readings; exact (block inverse of
  // the covariance), not refitted. Readings of a trial without samples are held against all.
  Eigen::VectorXd LeaveOneTrialOut(const std::vector<FieldSample>& readings) const;

 private:
  // Of the samples (rows) and new positions.
  template <typename Scalar>
  Eigen::MatrixX<Scalar> Covariance(const Eigen::Matrix2Xd& positions_m) const;

  FieldPrior prior_;
  std::vector<std::uint32_t> trial_;
  Eigen::Matrix2Xd positions_m_;
  Eigen::MatrixXd lower_;  // Cholesky factor of the samples' covariance
  Eigen::VectorXd alpha_;  // covariance^-1 (rssi - constant mean)
  double far_mean_dbm_ = 0;
  double far_sigma_db_ = 0;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_FRONTENDS_RADIO_MAP_GAUSSIAN_PROCESS_H_
