// Reading speed of every format, in bytes per second. The goal is 250 MB/s on one core.
//
// The texts are generated with the mixture of records that the recordings have; with
// WALKGRAPH_REAL_DATA set, the recorded walks themselves are read too, from the file cache on.

#include <benchmark/benchmark.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "data/dataset.h"
#include "data/formats/getsensordata.h"
#include "data/formats/ilc20.h"
#include "data/simulator/random.h"

namespace walkgraph {
namespace {

constexpr int kSamples = 3000;  // a minute at 50 Hz
constexpr int kSamplesPerScan = 100;
constexpr int kRowsPerScan = 60;

template <typename... Values>
void Append(std::string* text, const char* format, Values... values) {
  char line[256];
  const int length = std::snprintf(line, sizeof(line), format, values...);
  text->append(line, static_cast<std::size_t>(length));
}

std::string Ilc20Text() {
  Random random(1);
  std::string text = "#\tstartTime:1574559495255\n";
  for (int i = 0; i < kSamples; ++i) {
    const long long ms = 1574559495260LL + 20LL * i;
    for (const char* type :
         {"ACCELEROMETER", "GYROSCOPE", "MAGNETIC_FIELD", "ACCELEROMETER_UNCALIBRATED",
          "GYROSCOPE_UNCALIBRATED", "MAGNETIC_FIELD_UNCALIBRATED"}) {
      Append(&text, "%lld\tTYPE_%s\t%.7g\t%.7g\t%.8g\t3\n", ms, type, random.Normal(),
             random.Normal(), random.Normal(9.8, 1.0));
    }
    Append(&text, "%lld\tTYPE_ROTATION_VECTOR\t%.8f\t%.8f\t%.8f\t3\n", ms,
           random.Uniform(-0.5, 0.5), random.Uniform(-0.5, 0.5), random.Uniform(-0.5, 0.5));
    if (i % kSamplesPerScan != 0) continue;
    for (int row = 0; row < kRowsPerScan; ++row) {
      Append(&text, "%lld\tTYPE_WIFI\tguests\ta8:0c:ca:03:9d:%02x\t%d\t2422\t%lld\n", ms,
             random.Index(256), -40 - random.Index(50), ms - random.Index(5000));
    }
  }
  return text;
}

std::string GetSensorDataText() {
  Random random(1);
  std::string text = "% LogFile created by the 'GetSensorData' App for Android.\n";
  for (int i = 0; i < kSamples; ++i) {
    const double t = 0.02 * i;
    for (const char* type : {"ACCE", "GYRO", "MAGN"}) {
      Append(&text, "%s;%.4f;%.4f;%.5f;%.5f;%.5f;3\n", type, t, 9609.0652 + t, random.Normal(),
             random.Normal(), random.Normal(9.8, 1.0));
    }
    Append(&text, "AHRS;%.4f;%.4f;47.979519;8.738847;-142.990005;%.8f;%.8f;%.8f;3\n", t,
           9609.0652 + t, random.Uniform(-0.5, 0.5), random.Uniform(-0.5, 0.5),
           random.Uniform(-0.5, 0.5));
    if (i % 5 == 0) Append(&text, "PRES;%.4f;%.4f;976.8699;3\n", t, 9609.0652 + t);
  }
  return text;
}

template <typename ReadText>
void MeasureText(benchmark::State& state, const std::string& text, const ReadText& read) {
  for (auto _ : state) benchmark::DoNotOptimize(read(text));
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(text.size()));
}

void BM_ReadIlc20(benchmark::State& state) {
  MeasureText(state, Ilc20Text(), [](const std::string& text) { return ReadIlc20(text, 0); });
}
BENCHMARK(BM_ReadIlc20)->Unit(benchmark::kMillisecond);

void BM_ReadGetSensorData(benchmark::State& state) {
  MeasureText(state, GetSensorDataText(),
              [](const std::string& text) { return ReadGetSensorData(text); });
}
BENCHMARK(BM_ReadGetSensorData)->Unit(benchmark::kMillisecond);

// Reads a dataset from files that are in the operating system's cache.
void MeasureDataset(benchmark::State& state, const std::string& path) {
  const Dataset dataset = OpenDataset(path);
  std::int64_t bytes = 0;
  for (auto _ : state) {
    for (const WalkFile& file : dataset.walks) bytes += ReadWalk(file).report.bytes;
  }
  state.SetBytesProcessed(bytes);
}

void BM_ReadSample(benchmark::State& state) {
  MeasureDataset(state, std::string(WALKGRAPH_SOURCE_DIR) + "/data/samples");
}
BENCHMARK(BM_ReadSample)->Unit(benchmark::kMillisecond);

void MeasureRecorded(benchmark::State& state, const std::string& folder) {
  const char* root = std::getenv("WALKGRAPH_REAL_DATA");
  const std::string path = root == nullptr ? "" : root + folder;
  if (!std::filesystem::is_directory(path)) {
    state.SkipWithError("WALKGRAPH_REAL_DATA is not set, or has no such folder");
    return;
  }
  MeasureDataset(state, path);
}

void BM_ReadRecordedIlc20(benchmark::State& state) {
  MeasureRecorded(state, "/ilc20/data/site1/F1");
}
BENCHMARK(BM_ReadRecordedIlc20)->Unit(benchmark::kMillisecond);

void BM_ReadRecordedIpin2023(benchmark::State& state) { MeasureRecorded(state, "/ipin2023_t3"); }
BENCHMARK(BM_ReadRecordedIpin2023)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace walkgraph

BENCHMARK_MAIN();
