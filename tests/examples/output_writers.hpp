// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "run_program.hpp"
#include "sample.hpp"

/// What a file holds when it is whole: a text that says nothing of how long things took is compared
/// with the one of a run that was not disturbed.
struct WrittenFile {
  std::string name;
  std::function<bool(const std::string&)> is_whole{};  ///< unset: it is the text of the other run
};

/// A command that writes files into a folder, which FOLDER stands for in `arguments`.
struct OutputWriter {
  std::string arguments;
  std::vector<WrittenFile> files;

  std::string arguments_in(const std::string& folder) const {
    std::string text = arguments;
    for (std::size_t at; (at = text.find("FOLDER")) != std::string::npos;) {
      text.replace(at, 6, folder);
    }
    return text;
  }
};

inline bool text_ends_with(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}
inline bool is_whole_page(const std::string& text) {
  return text.find("<!DOCTYPE html>") == 0 && text_ends_with(text, "</html>\n");
}
inline bool is_whole_json(const std::string& text) { return nlohmann::json::accept(text); }
inline bool is_whole_drawing(const std::string& text) {
  return text.find("<svg ") == 0 && text_ends_with(text, "</svg>\n");
}

/// Three images of 64 x 48 px, all of them 2 m away, each with three boxes.
inline void write_images(const ScratchFolder& folder) {
  const std::string size = "64 48\n";
  std::string depth = "P5\n" + size + "65535\n", list, boxes = "[";
  for (int i = 0; i < 64 * 48; ++i) depth += std::string("\x27\x10");
  for (int image = 0; image < 3; ++image) {
    const std::string name = std::to_string(image);
    folder.write(name + ".ppm", "P6\n" + size + "255\n" + std::string(3 * 64 * 48, '\0'));
    folder.write(name + ".pgm", depth);
    list += name + ".0 " + name + ".ppm " + name + ".0 " + name + ".pgm\n";
    for (int box = 0; box < 3; ++box) {
      boxes += std::string(boxes.size() > 1 ? "," : "") + R"({"image_id": ")" + name +
               R"(", "category_id": 72, "score": 0.9, "bbox": [)" + std::to_string(18 * box) +
               ", 5, 15, 15]}";
    }
  }
  folder.write("associations.txt", list);
  folder.write("boxes.json", boxes + "]");
}

/// Every file that the program writes but maps.
/// @param inputs  where what they read is put
inline std::vector<OutputWriter> output_writers(const ScratchFolder& inputs) {
  write_images(inputs);
  const std::string tables = " --map " + sample_map + " --query " + sample_query + sample_options;
  const std::string poses = inputs.write(
      "poses.txt", "0 0 0 0 0 0 0 1\n10 0.1 0 0 0 0 0 1\n20 9 0 0 0 0 0 1\n30 9.1 0 0 0 0 0 1\n");
  const std::string scores =
      inputs.write("scores.csv", "nan,.9,.8,.1\n.9,nan,.2,.1\n.8,.2,nan,.7\n.1,.1,.6,nan\n");
  return {{"localize" + tables +
               "--svg FOLDER/m.svg --pairs FOLDER/p.csv --report FOLDER/r.html --report-data "
               "FOLDER/r.json",
           {{"m.svg", is_whole_drawing},
            {"p.csv"},
            {"r.html", is_whole_page},
            {"r.json", is_whole_json}}},
          {"localize" + tables +
               "--min-confidence 0.5 --window 0 --calibrate --save-calibration FOLDER/c.txt",
           {{"c.txt"}}},
          {"explain --frame 30" + tables + "--svg FOLDER/e.svg", {{"e.svg"}}},
          {"evaluate --scores " + scores + " --poses " + poses +
               " --protocol distance=1 --curve FOLDER/c.csv --ranks FOLDER/k.csv --report "
               "FOLDER/r.html --report-data FOLDER/r.json",
           {{"c.csv"}, {"k.csv"}, {"r.html"}, {"r.json"}}},
          {"trajectory --groundtruth " + poses + " --estimate " + poses + " --errors FOLDER/e.csv",
           {{"e.csv"}}},
          {"nodes --images " + inputs.path() + " --boxes " + inputs.path("boxes.json") +
               " --camera 50,50,31.5,23.5 --out FOLDER/set",
           {{"set.frames.csv"}, {"set.nodes.csv"}}}};
}
