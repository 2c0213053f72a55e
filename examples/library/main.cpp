// SPDX-License-Identifier: GPL-3.0-or-later
// Computes the medial axis of the samples in a file, says how long it is, and writes its edges as CSV.
#include <mesecina/mesecina.h>

#include <cstdio>
#include <cstdlib>

int main(int count, char** arguments) {
  using namespace mesecina;
  if (count != 2) {
    std::fprintf(stderr, "usage: %s FILE > EDGES.csv\n", arguments[0]);
    return EXIT_FAILURE;
  }
  try {
    Workbench bench;
    const OpenedFile file = bench.open(arguments[1]);
    for (const std::string& warning : file.warnings) std::fprintf(stderr, "%s\n", warning.c_str());

    bench.show({"medial-axis"});
    bench.want_statistics();
    bench.run();
    std::fprintf(stderr, "length %.17g\n", bench.number("medial-axis", "length"));

    const Instances edges = bench.instances("medial-axis", PrimitiveKind::segment);
    std::puts("x1,y1,x2,y2");
    for (std::size_t i = 0; i < edges.size(); ++i)
      std::printf("%.17g,%.17g,%.17g,%.17g\n", edges[i][0], edges[i][1], edges[i][2], edges[i][3]);
    return EXIT_SUCCESS;
  } catch (const Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return EXIT_FAILURE;
  }
}
