// Damaged recordings: whatever happens to the bytes, a reader returns with its promises kept, or
// throws InputError. Seeded, so that every run sees the same damage.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

#include "data/formats/csv.h"
#include "data/formats/getsensordata.h"
#include "data/formats/ilc20.h"
#include "data/formats/text_input.h"
#include "data/input_error.h"
#include "data/simulator/random.h"
#include "data/temporary_folder.h"

namespace walkgraph {
namespace {

constexpr int kMutations = 4000;

std::string Ilc20Text() {
  std::string text = "#\tstartTime:1574559495255\n#\tBrand:OPPO\tModel:PBCM10\n";
  for (int i = 0; i < 4; ++i) {
    const std::string ms = std::to_string(1574559495401 + 20 * i) + "\tTYPE_";
    text += ms + "ACCELEROMETER\t-0.85562134\t1.8243561\t9.826508\t2\n";
    text += ms + "MAGNETIC_FIELD\t29.78363\t6.427002\t-30.062866\t3\n";
    text += ms + "GYROSCOPE\t-0.3919525\t-6.2561035E-4\t0.09211731\t3\n";
    text += ms + "ROTATION_VECTOR\t0.062149726\t0.0793645\t0.57060283\t3\n";
    text += ms + "WIFI\tFMI \xc3\x28\ta8:0c:ca:03:9d:d7\t-49\t2422\t1574559495399\n";
    text += ms + "BEACON\t9195B3AD-A9D0\t0\t0\t-56\t-93\t45.03\tE0:78:A3:3D:B5:D6\t1574559495399\n";
    text += ms + "WAYPOINT\t81.317215\t93.31349\n";
  }
  return text + "#\tendTime:1574559526762\n";
}

std::string GetSensorDataText() {
  std::string text =
      "% LogFile created by the 'GetSensorData' App for Android.\n% Model:  \tSM-G930F\n";
  for (int i = 0; i < 4; ++i) {
    const std::string times = ";0.0" + std::to_string(6 + i) + ";9609.0" + std::to_string(6 + i);
    text += "ACCE" + times + ";-2.10936;7.62098;5.78457;3\n";
    text += "GYRO" + times + ";-0.21270;-0.60626;0.04498;3\n";
    text += "MAGN" + times + ";-10.70000;-26.50000;-4.80000;3\n";
    text += "AHRS" + times + ";47.9;8.7;-142.9;0.19467300;-0.36234000;-0.85403001;3\n";
    text += "PRES" + times + ";976.8699;3\n";
    text += "WIFI" + times + ";SSID;20:23:00:00:00:12;2417;-76\n";
    text += "BLE4;0.2382;iBeacon;BE:AC:20:23:00:02;-96;0;1;2;1111\n";
    text += "POSI;61.46" + std::to_string(i) + ";1;49.461221918752;11.111590101028;0;100\n";
  }
  return text;
}

template <typename T>
void ExpectOrdered(const Stream<T>& stream) {
  ASSERT_EQ(stream.time_ns.size(), stream.value.size());
  for (std::size_t i = 1; i < stream.size(); ++i) {
    ASSERT_LT(stream.time_ns[i - 1], stream.time_ns[i]);
  }
}

// What Recording and Truth promise to everyone who uses them.
void ExpectPromisesKept(const Walk& walk) {
  const Recording& recording = walk.recording;
  for (const auto* stream :
       {&recording.accelerometer_mps2, &recording.gyroscope_radps, &recording.magnetometer_ut}) {
    ExpectOrdered(*stream);
    for (const Eigen::Vector3d& value : stream->value) ASSERT_TRUE(value.allFinite());
  }
  ExpectOrdered(recording.rotation_vector);
  for (const auto& rotation : recording.rotation_vector.value) {
    ASSERT_NEAR(rotation.norm(), 1.0, 1e-9);
  }
  ExpectOrdered(recording.pressure_hpa);
  for (const double hpa : recording.pressure_hpa.value) ASSERT_TRUE(std::isfinite(hpa));
  TimeNs before = recording.begin_ns;
  for (const RadioRow& row : recording.radio_rows) {
    ASSERT_LT(row.transmitter, recording.transmitters.size());
    ASSERT_LE(row.heard_ns, row.printed_ns);
    ASSERT_LE(before, row.printed_ns);
    before = row.printed_ns;
  }
  ASSERT_LE(before, recording.end_ns);
  for (const Waypoint& waypoint : walk.truth.waypoints) {
    ASSERT_TRUE(waypoint.position.allFinite());
  }
}

using ReadText = std::function<Walk(const std::string&)>;

void CutEverywhere(const std::string& text, const ReadText& read) {
  for (std::size_t length = 0; length <= text.size(); ++length) {
    const std::string cut = text.substr(0, length);
    const Walk walk = read(cut);
    ExpectPromisesKept(walk);
    const bool whole = cut.empty() || cut.back() == '\n';
    const bool comment =
        !whole && (cut[cut.rfind('\n') + 1] == '#' || cut[cut.rfind('\n') + 1] == '%');
    ASSERT_EQ(walk.report.cut_last_line, !whole && !comment) << "at " << length;
    // A cut line is not broken: nothing else may be counted against it.
    ASSERT_EQ(walk.report.HazardCount("malformed"), 0) << "at " << length;
  }
}

// Flips, overwrites, doubles and removes bytes, mostly with characters that mean something.
std::string Damage(std::string text, Random* random) {
  constexpr std::string_view kMeaningful("\t;,\n\r.-+eE0919:#%\0\xff ", 21);
  const int times = 1 + random->Index(8);
  for (int i = 0; i < times && !text.empty(); ++i) {
    const auto at = static_cast<std::size_t>(random->Index(static_cast<int>(text.size())));
    const auto span = static_cast<std::size_t>(1 + random->Index(40));
    switch (random->Index(5)) {
      case 0:
        text[at] = static_cast<char>(text[at] ^ (1 << random->Index(8)));
        break;
      case 1:
        text[at] = kMeaningful[static_cast<std::size_t>(
            random->Index(static_cast<int>(kMeaningful.size())))];
        break;
      case 2:
        text.erase(at, span);
        break;
      case 3:
        text.insert(at, text.substr(at, span));
        break;
      default:
        text.insert(at, span, "0123456789"[random->Index(10)]);
        break;
    }
  }
  return text;
}

void DamageAtRandom(const std::string& text, const ReadText& read) {
  Random random(20);
  for (int i = 0; i < kMutations; ++i) {
    const std::string damaged = Damage(text, &random);
    ASSERT_NO_THROW(ExpectPromisesKept(read(damaged))) << damaged;
    if (testing::Test::HasFatalFailure()) FAIL() << damaged;
  }
}

Walk ReadAsIlc20(const std::string& text) { return ReadIlc20(text, 0); }
Walk ReadAsGetSensorData(const std::string& text) { return ReadGetSensorData(text); }

TEST(ReadersFuzz, Ilc20CutAtEveryByte) { CutEverywhere(Ilc20Text(), ReadAsIlc20); }
TEST(ReadersFuzz, GetSensorDataCutAtEveryByte) {
  CutEverywhere(GetSensorDataText(), ReadAsGetSensorData);
}
TEST(ReadersFuzz, Ilc20Damaged) { DamageAtRandom(Ilc20Text(), ReadAsIlc20); }
TEST(ReadersFuzz, GetSensorDataDamaged) {
  DamageAtRandom(GetSensorDataText(), ReadAsGetSensorData);
}

// Each reader also meets the other's files, and files of nothing at all.
TEST(ReadersFuzz, ForeignText) {
  for (const std::string& text :
       {Ilc20Text(), GetSensorDataText(), std::string(1000, '\0'), std::string(5000, '\t'),
        std::string(5000, ';'), std::string(5000, '\n'), std::string(5000, '-')}) {
    ExpectPromisesKept(ReadAsIlc20(text));
    ExpectPromisesKept(ReadAsGetSensorData(text));
    LooksLikeIlc20(text);
    LooksLikeGetSensorData(text);
  }
}

TEST(ReadersFuzz, CsvDamaged) {
  const std::string walk = std::string(WALKGRAPH_SOURCE_DIR) + "/data/samples/survey/walk_01/";
  const TemporaryFolder folder;
  Random random(21);
  for (const char* file : {"wifi.csv", "rotation_vector.csv", "waypoints.csv"}) {
    const std::string text = ReadFileBytes(walk + file).substr(0, 1500);
    for (int i = 0; i < kMutations / 20; ++i) {
      folder.Write(file, Damage(text, &random));
      try {
        ExpectPromisesKept(ReadCsvWalk(folder.Path()));
      } catch (const InputError&) {
        // The damage hit the header.
      }
      if (HasFatalFailure()) FAIL() << file << " mutation " << i;
    }
  }
}

TEST(ReadersFuzz, BuildingsDamaged) {
  const std::string json =
      R"({"name":"a","origin":{"latitude_deg":49.4,"longitude_deg":11.1,"rotation_deg":20},)"
      R"("floors":[{"number":0,"height_m":0,"outline":[[[0,0],[44,0],[44,24]]],)"
      R"("obstacles":[[[1,1],[2,1],[2,2]]]},)"
      R"({"number":1,"height_m":3,"min_corner":[0,0],"max_corner":[4,4],)"
      R"("image":{"path":"a.png","min_corner":[0,0],"max_corner":[4,4]}}]})";
  const std::string cal = "a.png b.png\n0 1\n1 1\n49.1 49.1\n11.2 11.2\n-20 -20\n0.1 0.1\n";
  const TemporaryFolder folder;
  Random random(22);
  const auto expect_error_or_result = [](const auto& read) {
    try {
      read();
    } catch (const InputError&) {
      // The usual end of a damaged building.
    }
  };
  for (int i = 0; i < kMutations / 20; ++i) {
    folder.Write("building.json", Damage(json, &random));
    folder.Write("floorplans.cal", Damage(cal, &random));
    ASSERT_NO_THROW(
        expect_error_or_result([&] { ReadBuildingJson(folder.Path("building.json")); }));
    ASSERT_NO_THROW(
        expect_error_or_result([&] { ReadFloorplansCal(folder.Path("floorplans.cal")); }));
  }
}

}  // namespace
}  // namespace walkgraph
