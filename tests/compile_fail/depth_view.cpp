// SPDX-License-Identifier: MIT
// MISFIT 1: topobag: DepthView reads 16-bit or floating-point depth images.
// MISFIT 2: topobag: a depth image must be stored row by row (Eigen::RowMajor).
// MISFIT 3: topobag: a depth image must be stored row by row (Eigen::RowMajor).
// MISFIT 4: deleted function
#include <topobag/sensing/depth_view.hpp>

#if MISFIT == 1
using Pixel = int;
#else
using Pixel = std::uint16_t;
#endif
#if MISFIT == 2 || MISFIT == 3
using Image = Eigen::Matrix<Pixel, Eigen::Dynamic, Eigen::Dynamic>;
#else
using Image = Eigen::Matrix<Pixel, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
#endif

int main() {
  const Image image = Image::Zero(480, 640);
#if MISFIT != 3
  const auto whole = topobag::depth_view(image, 5000.0);
#endif
#if MISFIT != 2
  const auto mapped = topobag::depth_view(Eigen::Map<const Image>(image.data(), 480, 640), 5000.0);
#endif
#if MISFIT == 4
  const auto dangling = topobag::depth_view(Image(image), 5000.0);
#endif
}
