// Sources of the numbers, each named where it is used:
// [ftmax]     jhu-dvrk/sawIntuitiveResearchKit, share/kinematic/psm.json and mtmr.json,
//             share/tool/LARGE_NEEDLE_DRIVER_400006.json: ftmax.
// [ratios]    the same, core/share/kinematic/compute-ftmax.py: gear ratios, and the motors'
//             torques and most currents.
// [io]        the same, core/share/bgu-dvrk/sawRobotIO1394-PSM1-31817.xml and
//             core/share/cuhk-daVinci/sawRobotIO1394-MTML-41878.xml: BitsToPosSI.
// [Wang]      Y. Wang, R. Gondokaryono, A. Munawar, G. S. Fischer, "A Convex Optimization-based
//             Dynamic Model Identification Package for the da Vinci Research Kit", IEEE RA-L 4(4),
//             2019: the package's data/psm/dynamic_params/params.json and the same of mtm
//             (WPI-AIM/dvrk_dynamics_identification), rounded.
// [dvrk_env]  WPI-AIM/dvrk_env, PSM/urdf/PSM.urdf and dvrk_description/mtm/mtm.urdf.xacro: masses.
// [estimate]  our own.

#include "dynamics/davinci_inertia.h"

#include <numbers>

namespace robots::dynamics {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kRotor = 1e-6;       // kg.m^2 of a motor 25 mm thick [estimate]
constexpr double kSmallRotor = 5e-8;  // kg.m^2 of one of 13 mm [estimate]

Matrix3d diagonal(double x, double y, double z) { return Vector3d(x, y, z).asDiagonal(); }

constexpr double reflected(double rotor, double ratio) { return rotor * ratio * ratio; }

// Motors turn the joints of the needle driver through its coupling
// (LARGE_NEEDLE_DRIVER_400006.json: ActuatorToJointPosition), of which only the diagonal is
// simulated.
constexpr double kRollCoupling = 1.5632, kPitchCoupling = 1.0186, kYawCoupling = 0.6089;

}  // namespace

ArmMechanics<6> psmMechanics() {
  constexpr double kCarriage = 0.363, kCounterweight = 0.350;  // kg [Wang: links 8 and 9]
  constexpr double kYaw = 1.4705;                              // kg [dvrk_env]
  constexpr double kParallelogram = 0.99511 + 0.44569 + 2.091 + 0.17841 + 0.074425;  // [dvrk_env]
  constexpr double kToolRatio = 11.71;                                               // [ratios]
  const double toolCount = 0.00768574 * kDegree;                                     // [io]
  ArmMechanics<6> psm;
  // Centres of mass and inertia, and the instrument's masses [estimate].
  psm.links = {{
      {kYaw, {0.01, 0, -0.30}, diagonal(0.015, 0.015, 0.008), reflected(kRotor, 56.5)},
      {kParallelogram + 2 * kCounterweight,
       {0.01, 0.03, 0},
       diagonal(0.12, 0.03, 0.135),
       reflected(kRotor, 56.5)},
      {kCarriage - kCounterweight,
       {0, 0, 0},
       diagonal(4e-4, 4e-4, 4e-4),
       reflected(kRotor, 336.6) + 2 * kCounterweight},
      {0.050,
       {0, 0, -0.21},
       diagonal(6.7e-4, 6.7e-4, 5e-7),
       reflected(kRotor, kToolRatio / kRollCoupling)},
      {0.003,
       {0.0045, 0, 0},
       diagonal(5e-8, 5e-8, 5e-8),
       reflected(kRotor, kToolRatio / kPitchCoupling)},
      {0.004,
       {0, 0, 0.004},
       diagonal(8e-8, 8e-8, 3e-8),
       2 * reflected(kRotor, kToolRatio / (2 * kYawCoupling))},
  }};
  // [Wang: links 1, 2 and 8, and motors 11, 14 and 15]
  psm.viscous << 0.0905, 0.218, 1.204, 0.0122, 0.0062, 0.0074;
  psm.coulomb << 0.0500, 0.0668, 0.448, 0.0070, 0.0063, 0.0062;
  psm.effort_limit << 3.316101, 3.316101, 9.877926, 0.33, 0.25, 0.20;  // [ftmax]
  psm.motor_limit = psm.effort_limit;
  psm.encoder_step << 0.00044248 * kDegree, 0.00044248 * kDegree, 1.29629e-6,
      toolCount * kRollCoupling, toolCount * kPitchCoupling, toolCount * kYawCoupling;  // [io]
  return psm;
}

ArmMechanics<7> mtmMechanics() {
  constexpr double kTopBar = 0.996;       // kg [Wang: link 5]
  constexpr double kCounterweight = 2.0;  // kg [estimate]
  ArmMechanics<7> mtm;
  // Masses of yaw link and upper arm [dvrk_env], of the others [Wang: links 3 and 6 to 9]; centres
  // of mass and inertia [estimate].
  mtm.links = {{
      {1.0 + kTopBar, {0, 0.05, 0}, diagonal(0.01, 0.01, 0.01), reflected(kRotor, 63.41)},
      {0.9 + kCounterweight,
       {-0.3735, 0, 0},
       diagonal(0.005, 0.078, 0.078),
       reflected(kRotor, 49.88)},
      {0.812, {-0.4574, 0, 0}, diagonal(0.002, 0.075, 0.075), reflected(kRotor, 59.73)},
      {0.208, {0.01, -0.06, 0.04}, diagonal(8e-4, 4e-4, 8e-4), reflected(kRotor, 10.53)},
      {0.066, {0, 0.01, 0.03}, diagonal(1.5e-4, 1.5e-4, 1.5e-4), reflected(kSmallRotor, 33.16)},
      {0.050, {0, 0, 0.04}, diagonal(8e-5, 8e-5, 8e-5), reflected(kSmallRotor, 33.16)},
      {0.020, {0.005, 0, 0.05}, diagonal(2e-5, 2e-5, 2e-5), reflected(kSmallRotor, 16.58)},
  }};
  // [Wang: links 1, 2, 4, 6, 7, 8 and 9]
  mtm.viscous << 0.0491, 0.0925, 0.0619, 0.0048, 0.0007, 0.0023, 0.0001;
  mtm.coulomb << 0.0489, 0.0317, 0.0432, 0.0288, 0.0070, 0.0019, 0.0012;
  mtm.effort_limit << 1.86082986, 3.21661506, 1.95978284, 0.30901338, 0.09684378, 0.09684378,
      0.02287592;  // [ftmax]
  mtm.motor_limit << 0.67 * 0.0438 * 63.41, 0.67 * 0.0438 * 49.88, 0.67 * 0.0438 * 59.73,
      0.67 * 0.0438 * 10.53, 0.59 * 0.00495 * 33.16, 0.59 * 0.00495 * 33.16,
      0.407 * 0.00339 * 16.58;  // A, N.m/A, and the gear [ratios]
  mtm.encoder_step << 0.00141933, 0.00180433, 0.00150678, 0.00854701, 0.16963209, 0.16963209,
      0.33926417;  // degrees [io]
  mtm.encoder_step *= kDegree;
  return mtm;
}

}  // namespace robots::dynamics
