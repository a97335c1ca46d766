// SPDX-License-Identifier: MIT
#pragma once

/// The evaluation kit: trajectories, protocols, precision and recall, their files. Needs Eigen alone:
/// target `topobag::evaluation`.
#include <topobag/evaluation/alignment.hpp>
#include <topobag/evaluation/association.hpp>
#include <topobag/evaluation/bootstrap.hpp>
#include <topobag/evaluation/frustum_overlap.hpp>
#include <topobag/evaluation/kitti_trajectory.hpp>
#include <topobag/evaluation/labelled_scores.hpp>
#include <topobag/evaluation/lifelong_score.hpp>
#include <topobag/evaluation/loop_verdicts.hpp>
#include <topobag/evaluation/npy_matrix.hpp>
#include <topobag/evaluation/number_text.hpp>
#include <topobag/evaluation/openloris_trajectory.hpp>
#include <topobag/evaluation/place_protocol.hpp>
#include <topobag/evaluation/place_truth.hpp>
#include <topobag/evaluation/pose_error.hpp>
#include <topobag/evaluation/precision_recall.hpp>
#include <topobag/evaluation/protocol_text.hpp>
#include <topobag/evaluation/recall_at_k.hpp>
#include <topobag/evaluation/relative_pose_error.hpp>
#include <topobag/evaluation/score_csv.hpp>
#include <topobag/evaluation/text_lines.hpp>
#include <topobag/evaluation/trajectory.hpp>
#include <topobag/evaluation/trajectory_error.hpp>
#include <topobag/evaluation/tum_trajectory.hpp>
