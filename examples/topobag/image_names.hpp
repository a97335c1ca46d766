// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace program {

/// Which image of a sequence a file of boxes means by a name.
///
/// Names are compared without suffix, as other tools give images another one. Where several have
/// one name, their folders tell them apart, from the last one on; what is not told apart is
/// refused.
class ImageNames {
 public:
  /// @param images  paths of the sequence's images
  explicit ImageNames(const std::vector<std::string>& images);

  /// For each image the position in `names` of what means it; `none` where nothing does.
  /// @param names  paths, with slashes either way, or bare names
  /// @param file   where the names come from, for the complaint
  /// Throws InputError for two names of one image, and for one name of two images.
  std::vector<std::size_t> find(const std::vector<std::string>& names,
                                const std::string& file) const;

  static constexpr std::size_t none = static_cast<std::size_t>(-1);

 private:
  std::vector<std::vector<std::string>> images_;  ///< parts of the paths, the last first
};

}  // namespace program
