#ifndef WALKGRAPH_DATA_READER_SETTINGS_H_
#define WALKGRAPH_DATA_READER_SETTINGS_H_

namespace walkgraph {

// Choices of how recordings are read, for sets whose files leave room for doubt.
struct ReaderSettings {
  // Gives the rows of WIFI/Test.csv to the positions in reverse order: as given, RSSI grows with the
  // distance to its own anchor.
  bool swiblux_reverse_wifi_test = false;
  // Reads -92, which stands for an anchor that was not heard, as a reading of -92 dBm.
  bool swiblux_keep_unheard = false;
};

template <typename Visitor>
void Visit(Visitor& v, ReaderSettings& s) {
  v.Field("swiblux_reverse_wifi_test", s.swiblux_reverse_wifi_test,
          "whether the rows of swiblux's WIFI/Test.csv belong to its positions in reverse");
  v.Field("swiblux_keep_unheard", s.swiblux_keep_unheard,
          "whether swiblux's -92 (not heard, or a lost packet) is a reading of -92 dBm");
}

}  // namespace walkgraph

#endif  // WALKGRAPH_DATA_READER_SETTINGS_H_
