#ifndef WALKGRAPH_DATA_SIMULATOR_SETTINGS_H_
#define WALKGRAPH_DATA_SIMULATOR_SETTINGS_H_

#include <cstdint>

#include "data/angle.h"

namespace walkgraph {

// Everything that the simulator can be told, one struct per cause. The defaults are the scenario
// `office`: all that recorded walks show. Values marked "measured" come from the public recordings
// of the Indoor Location Competition 2.0 (ilc20) and of IPIN 2023 Track 3 (ipin2023). Each struct
// has a Visit() that names every key once, in settings_visit.h. A sigma of zero switches its
// disturbance off and leaves every other random number as it was.

enum class BuildingKind : std::uint8_t { kOffice, kHall, kGiven };

struct BuildingSettings {
  BuildingKind kind = BuildingKind::kOffice;
  int floors = 3;
  int lowest_floor = 0;
  double floor_height_m = 3.5;  // usual office storey, 3.3-4.0 m
  // Where the frame lies: the museum of ipin2023, so that GetSensorData logs have a place on Earth.
  double latitude_deg = 49.4613;
  double longitude_deg = 11.1110;
  double rotation_deg = 0;      // from east to the frame's +x, counter-clockwise
  double grid_spacing_m = 2.5;  // of the ways through a hall or a given plan
};

struct WalkSettings {
  int survey = 40;
  int test = 20;
  double duration_s = 180;
  double rate_hz = 100;          // of accelerometer and gyroscope; ipin2023 50 and 100, ilc20 50
  bool change_floors = true;     // take stairs, lifts and escalators
  double connector_share = 0.3;  // of the occasions to change floors that are taken
  double straight_share = 0.6;   // of the crossings that are passed straight on
  double waypoint_every_s = 10;  // and at every turn; measured on ilc20: median 5.6 s
  double stop_every_s = 90;      // mean time between stops on the way; 0: none
  double stop_s = 6;             // mean length of a stop
  double handling_s = 20;        // the phone is waved before the walk; ipin2023: 40 s
  double stand_after_handling_s = 5;  // ipin2023: 20 s
};

struct GaitSettings {
  // Preferred walking of healthy adults: 1.3 m/s, step length varying by 3-4 % from step to step
  // (Oberg, Karsznia and Oberg, J. Rehabil. Res. Dev. 30, 1993; Hausdorff, J. NeuroEng. Rehabil. 2,
  // 2005). A person who watches a phone is a little slower; measured on ilc20: 1.83 +- 0.14 Hz.
  double step_rate_hz = 1.8;
  double step_rate_sigma_hz = 0.07;
  double step_length_m = 0.68;
  double step_length_sigma_m = 0.03;
  double step_variation = 0.035;
  // Weinberg (AN-602, 2002): step length = K * swing^(1/4), read backwards to get the vertical
  // swing of a step. K differs by a few percent between persons, which is what a step-scale state
  // is for.
  double weinberg_k = 0.42;
  double weinberg_k_sigma = 0.02;
  // Stairs of 17 cm by 29 cm (Riener, Rabuffetti and Frigo, Gait and Posture 15, 2002). Steps and
  // swings measured on ipin2023 where the pressure changes by more than 0.02 hPa/s: up 1.72 Hz and
  // 5.7 m/s2, down 1.81 Hz and 6.4 m/s2.
  double riser_m = 0.17;
  double tread_m = 0.29;
  double stairs_up_rate_hz = 1.7;
  double stairs_down_rate_hz = 1.8;
  double stairs_up_swing_mps2 = 5.7;
  double stairs_down_swing_mps2 = 6.4;
};

struct RideSettings {
  // Usual passenger lifts of low buildings; escalators (EN 115-1 allows 0.75 m/s at 30 degrees).
  double lift_speed_mps = 1.0;
  double lift_acceleration_mps2 = 0.8;
  double door_s = 3.0;               // open to closed, and closed to open
  double escalator_speed_mps = 0.5;  // along the incline
  double escalator_slope_deg = 30.0;
};

struct HoldSettings {
  // A hand that follows the body: nods with the steps, sways with the strides.
  double pitch_rad = DegreesToRadians(25.0);
  double pitch_sigma_rad = DegreesToRadians(6.0);
  double roll_sigma_rad = DegreesToRadians(4.0);
  double sway_rad = DegreesToRadians(2.0);
  // How far the phone points past the direction of walking, and the hand's slow wandering around
  // it. ilc20: walking direction minus yaw spreads by 11 deg over walks, all causes together.
  double offset_sigma_rad = DegreesToRadians(6.0);
  double wander_rad = DegreesToRadians(2.0);
  double wander_s = 5.0;
};

struct InertialSettings {
  // Bosch BMI160 data sheet: noise 180 ug/rtHz and 0.007 deg/s/rtHz over 20 Hz; what zero-rate
  // offset is left after the phone's own calibration (some 0.3 deg/s is usual) and its random walk.
  double acceleration_noise_mps2 = 0.008;
  // Measured on ipin2023: standing, the norms of the two phones are off by +0.06 and -0.10 m/s2.
  double acceleration_bias_sigma_mps2 = 0.08;
  double gyro_noise_radps = DegreesToRadians(0.03);
  double gyro_bias_sigma_radps = DegreesToRadians(0.3);
  double gyro_bias_walk_radps_per_sqrt_s = DegreesToRadians(0.01);
};

struct MagneticSettings {
  double rate_hz = 50;  // of magnetometer and rotation vector; measured: 50 in both collections
  // Earth's field in central Europe (World Magnetic Model 2020); noise of the AK09911.
  double horizontal_ut = 20.0;
  double vertical_ut = 45.0;
  double noise_ut = 0.5;
  // Steel in the building. Measured: the norm varies by 4.2 uT (ilc20) and 4.3 uT (ipin2023) within
  // a walk; one component of three makes the norm, so that this is each component's sigma. Length:
  // Afzal, Renaudin and Lachapelle (Int. J. Navigation Observation, 2011), metres to tens of
  // metres.
  double disturbance_ut = 4.0;
  double disturbance_length_m = 3.0;
  // The magnetic error of a rotation vector that a walk keeps, and one that changes with time.
  double yaw_offset_sigma_rad = DegreesToRadians(7.0);
  double yaw_wander_rad = DegreesToRadians(6.0);
  double yaw_wander_s = 8.0;
  double fusion_s = 4.0;  // the phone's filter follows the field that slowly: gyroscope in between
};

enum class BarometerState : std::uint8_t { kWorks, kMissing, kStops, kConstant };
enum class PressureUnit : std::uint8_t { kHpa, kPa, kKpa };

struct BarometerSettings {
  BarometerState state = BarometerState::kWorks;  // `stops` falls silent half way
  PressureUnit unit = PressureUnit::kHpa;         // of what is written; hPa is Android's
  double rate_hz = 8.0;                           // measured on ipin2023: 6.1 and 10.0
  double weather_hpa = 1005.0;                    // at the frame's zero, mean over days
  double weather_sigma_hpa = 3.0;                 // ipin2023: 4 hPa between two days
  // Bosch BMP280: absolute accuracy 1 hPa; ipin2023: 0.4-0.5 hPa between two phones.
  double offset_sigma_hpa = 0.35;
  // Weather: three hours' tendencies of 1-2 hPa are ordinary (WMO No. 8). Faster than that,
  // measured on ipin2023 on one floor: 1 s means differ by 0.022 hPa after 10 s, by 0.033 hPa after
  // 60 s.
  double trend_sigma_hpa_per_h = 0.5;
  double drift_hpa_per_sqrt_h = 0.2;
  double steps_per_hour = 6.0;   // doors and ventilation: pressure steps that stay a while
  double step_sigma_hpa = 0.08;  // stack and fan pressures are 5-20 Pa
  double step_length_s = 20.0;   // mean time for which one stays
  // Standing, measured on ipin2023: 0.0167 hPa in all (5 to 95 %: 0.012-0.026), of which 0.0046 hPa
  // differ from sample to sample at 8 Hz: the sensor's own low-pass filter leaves the rest slow.
  double noise_hpa = 0.004;
  double wander_hpa = 0.016;
  double wander_s = 2.0;
  double air_temperature_k =
      295.0;  // indoors; 288.15 makes heights those of the standard atmosphere
};

struct PropagationSettings {
  // Multi-wall model (COST 231 final report, section 4.7.2): free space plus 3.4 dB per light wall
  // and 6.9 dB per heavy one, and 18.3 dB * n^((n + 2)/(n + 1) - 0.46) for n floors.
  double exponent = 2.0;
  double wall_loss_db = 3.4;
  double outer_wall_loss_db = 6.9;
  double most_walls = 6.0;  // beyond them waves find ways around
  double floor_loss_db = 18.3;
  double floor_exponent = 0.46;
  double height_over_floor_m = 2.5;  // of access points; phones are held at 1.2 m
  // 3GPP TR 38.901, indoor office: sigma 3 dB in sight to 8 dB out of sight (table 7.4.1-1),
  // correlation length 6 m out of sight (table 7.5-6).
  double shadow_sigma_db = 4.5;
  double shadow_length_m = 6.0;
  // A person between phone and access point: up to 9 dB, and a spread of 2-4 dB from reading to
  // reading (Kaemarungsi and Krishnamurthy, MobiQuitous 2004).
  double body_loss_db = 6.0;
  double reading_sigma_db = 3.0;
};

struct WifiSettings {
  bool enabled = true;
  int per_floor = 40;
  // The access point radiates 17 dBm (ETSI EN 300 328 allows 20), free space takes 40 dB to 1 m at
  // 2.4 GHz, hand and phone another 8 dB.
  double power_at_1m_dbm = -34.0;
  double power_sigma_db = 3.0;    // models and mountings differ
  double neighbourhood_m = 20.0;  // phones hear the neighbours: so far outside the floor
  double threshold_dbm = -92.0;   // measured on ilc20: 5 % of the rows are under -90 dBm
  // Share of sweeps in which a strong enough access point is heard again, in percent: TCPF's
  // refresh rate of a moving phone, base + gain/(1 + exp(-(rssi - middle)/width)).
  double refresh_base = 2.1630;
  double refresh_gain = 82.4917;
  double refresh_middle_dbm = -75.0075;
  double refresh_width_db = 1.8464;
  // Measured sweep intervals: ilc20 1.97 s (5 to 95 %: 1.9-3.0), ipin2023 2.0 and 4.0 s. What has
  // not been heard again is printed for some time more; measured on ilc20: 43 % of the rows are
  // repeats, and with TCPF's refresh rate 9 s make that many.
  double shortest_sweep_s = 1.9;
  double longest_sweep_s = 3.0;
  double keep_s = 9.0;
  double run_up_s = 8.0;   // sweeps run before the recording does
  double latency_s = 0.8;  // readings are stamped so long before they were heard, as on ilc20
  // Over phones. Measured on ipin2023: the two phones differ by 5.9 dB (Wi-Fi) and 7.6 dB
  // (beacons).
  double device_offset_sigma_db = 4.0;
};

struct BeaconSettings {
  bool enabled = true;
  int per_floor = 8;
  double power_at_1m_dbm = -59.0;  // what iBeacons are calibrated to
  double power_sigma_db = 2.0;
  double interval_s = 0.25;      // measured on ipin2023: median 0.25 s
  double loss = 0.2;             // of advertisements while the phone's radio does other things
  double threshold_dbm = -98.0;  // measured on ipin2023: 5 % of the rows are under -98 dBm
  double device_offset_sigma_db = 5.0;
};

// What changes between the survey and the test walks, for both radios.
struct ChangeSettings {
  double vanished_share = 0.05;  // of the transmitters
  double altered_share = 0.1;    // get another power
  double altered_sigma_db = 6.0;
};

struct SimulationSettings {
  BuildingSettings building;
  WalkSettings walks;
  GaitSettings gait;
  RideSettings ride;
  HoldSettings hold;
  InertialSettings inertial;
  MagneticSettings magnetic;
  BarometerSettings barometer;
  PropagationSettings propagation;
  WifiSettings wifi;
  BeaconSettings beacon;
  ChangeSettings change;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_DATA_SIMULATOR_SETTINGS_H_
