// SPDX-License-Identifier: MIT
#include "recorded.hpp"

#include <cstdio>
#include <string>
#include <vector>

#include "catch.hpp"
#include "csv_reader.hpp"
#include "keyframe.hpp"
#include "run_program.hpp"
#include "sample.hpp"

namespace {

/// The sample's map with stamps that count from 0 in units of `unit` s, or are all 0 but for `step`
/// of these from row to row. Its name.
std::string restamped_sample(const ScratchFolder& folder, const std::string& name, double unit) {
  program::CsvReader csv(sample_map + ".frames.csv");
  std::string text = "idx,frame,timestamp,tx,ty,tz,qx,qy,qz,qw\n";
  double first = -1.0;
  while (csv.next()) {
    const double stamp = csv.number(2);
    if (first < 0.0) first = stamp;
    char since[40];
    std::snprintf(since, sizeof since, "%.6f", (stamp - first) / unit);
    text += std::string(csv.text(0)) + ',' + std::string(csv.text(1)) + ',' + since;
    for (std::size_t i = 3; i < 10; ++i) text += ',' + std::string(csv.text(i));
    text += '\n';
  }
  folder.write(name + ".frames.csv", text);
  folder.write(name + ".nodes.csv", program::read_file(sample_map + ".nodes.csv"));
  return folder.path(name);
}

std::string window_text(double step, double window) {
  std::vector<program::Keyframe> keyframes(10);
  for (std::size_t i = 0; i < keyframes.size(); ++i) {
    keyframes[i].timestamp = step * static_cast<double>(i);
  }
  return program::odd_window_text(keyframes, window);
}

}  // namespace

TEST_CASE("a table whose stamps from 0 are no seconds is refused", "[examples][regression]") {
  const ScratchFolder folder;
  const auto told = [&](const std::string& set, const std::string& command) {
    return refusal(command + set + sample_options);
  };
  const std::string us = restamped_sample(folder, "us", 1e-6);
  const std::string ns = restamped_sample(folder, "ns", 1e-9);
  CHECK(told(us, "loops --nodes ").find(us + ".frames.csv: the time stamps are ") == 0);
  CHECK(told(us, "loops --nodes ").find("in microseconds? divide by 1e6") != std::string::npos);
  CHECK(told(ns, "loops --nodes ").find("in nanoseconds? divide by 1e9") != std::string::npos);
  CHECK(told(ns, "map --out " + folder.path("m.bag") + " --nodes ").find(ns) == 0);
  CHECK(told(ns, "localize --query " + sample_query + " --map ").find(ns) == 0);
  const std::string frames = ns + ".frames.csv";
  CHECK(refusal("trajectory --groundtruth " + frames + " --estimate " + frames).find(frames) == 0);
}

TEST_CASE("a window that fuses nothing is told, in milliseconds with what may be wrong",
          "[examples][regression]") {
  const ScratchFolder folder;
  const std::string ms = restamped_sample(folder, "ms", 1e-3);
  const ProgramRun run = run_program("loops --min-gap 5 --nodes " + ms + sample_options);
  CAPTURE(run.err);
  CHECK(run.err.find(ms + ": frames are ") != std::string::npos);
  CHECK(run.err.find(" s apart in the median, a window of 3 s fuses nothing: are the stamps in "
                     "milliseconds?\n") != std::string::npos);
  const std::string frames = ms + ".frames.csv";
  const ProgramRun scored =
      run_program("trajectory --groundtruth " + frames + " --estimate " + frames);
  CHECK(scored.exit_code == 0);
  CHECK(scored.err.find("and one counts for --max-pose-interval 1 s: are the stamps in "
                        "milliseconds?\n") != std::string::npos);
  CHECK(window_text(0.4, 3.0).empty());
  CHECK(window_text(33.3, 0.0).empty());
  CHECK(window_text(4.0, 3.0) ==
        "frames are 4 s apart in the median, a window of 3 s fuses nothing");
}

TEST_CASE("a window that fuses all of a recording is told, where it is minutes long",
          "[examples][regression]") {
  CHECK(window_text(0.4, 3000.0) ==
        "a window of 3000 s fuses all 3.6 s of the recording in one graph: is it in "
        "milliseconds?");
  CHECK(window_text(0.4, 5.0).empty());  // a short recording, fused whole on purpose
  CHECK(window_text(20.0, 90.0).empty());
  CHECK(window_text(10.0, 90.0) ==
        "a window of 90 s fuses all 90 s of the recording in one graph: is it in milliseconds?");
}
