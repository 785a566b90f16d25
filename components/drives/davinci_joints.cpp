// The gains are those of the da Vinci Research Kit: jhu-dvrk/sawIntuitiveResearchKit,
// core/share/pid/sawControllersPID-PSM.json and sawControllersPID-MTM.json (p_gain and d_gain),
// whose integral gains are 0. Its disturbance observer and dead band are left out. The time
// constants of the filters are our own: a few times the period of the drives for the PSM, and more
// for the MTM, whose wrist has encoders of 0.003 rad.

#include "drives/davinci_joints.h"

#include "kinematics/davinci.h"

namespace robots {
namespace {

template <int N>
void apply(const RigidBodyOptions& options, RigidBodyModel<N>& model) {
  model.gravity_compensation = options.gravity_compensation;
  model.quantisation = options.quantisation;
  model.noise = options.noise;
  model.seed = options.seed;
  model.brakes = options.brakes;
  model.current_gain = options.current_gain;
}

}  // namespace

RigidBodyModel<6> psmRigidBody(const RigidBodyModel<6>::Joints& parked,
                               const RigidBodyModel<6>::Joints& rateLimit,
                               const RigidBodyOptions& options) {
  RigidBodyModel<6> model{.chain = kinematics::psm(),
                          .mechanics = dynamics::psmMechanics(),
                          .parked = parked,
                          .rate_limit = rateLimit,
                          .stiffness = {},
                          .damping = {},
                          .velocity_filter = 0.002};
  model.stiffness << 120, 120, 6000, 6, 6, 6;
  model.damping << 6, 5, 200, 0.09, 0.09, 0.09;
  apply(options, model);
  return model;
}

RigidBodyModel<7> mtmRigidBody(const kinematics::Chain<7>& chain,
                               const RigidBodyModel<7>::Joints& parked,
                               const RigidBodyModel<7>::Joints& rateLimit,
                               const RigidBodyOptions& options) {
  RigidBodyModel<7> model{.chain = chain,
                          .mechanics = dynamics::mtmMechanics(),
                          .parked = parked,
                          .rate_limit = rateLimit,
                          .stiffness = {},
                          .damping = {},
                          .velocity_filter = 0.005};
  model.stiffness << 100, 80, 80, 3, 2, 0.4, 0.15;
  model.damping << 10, 5, 5, 0.35, 0.07, 0.015, 0.005;
  model.coupling = mtmCoupling();
  apply(options, model);
  return model;
}

}  // namespace robots
