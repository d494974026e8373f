#include "servo/mujoco/MujocoWorld.h"

#include <cstring>
#include <stdexcept>

namespace plumbline::servo::mujoco {
namespace {

mjModel* load(const std::string& text) {
  // MuJoCo would write warnings to a file in the current folder; those that matter are asked for after each
  // step.
  mju_user_warning = [](const char*) {};
  auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  const int index = mj_makeEmptyFileVFS(files.get(), "robot.xml", static_cast<int>(text.size()));
  if (index < 0)
    throw std::runtime_error("MuJoCo takes no model of " + std::to_string(text.size()) + " bytes");
  std::memcpy(files->filedata[index], text.data(), text.size());
  char error[1000] = "";
  mjModel* model = mj_loadXML("robot.xml", files.get(), error, sizeof error);
  mj_deleteVFS(files.get());
  if (!model) throw std::runtime_error(std::string("MuJoCo refuses the robot: ") + error);
  return model;
}

}  // namespace

World::World(const Mechanism& robot, const std::string& text)
    : m_(load(text), mj_deleteModel), d_(mj_makeData(m_.get()), mj_deleteData) {
  for (const Mechanism::Link& link : robot.links)
    bodies_.push_back(mj_name2id(m_.get(), mjOBJ_BODY, link.name.c_str()));
  for (const Mechanism::Joint& joint : robot.joints) {
    const int id = mj_name2id(m_.get(), mjOBJ_JOINT, joint.name.c_str());
    const int rotor = mj_name2id(m_.get(), mjOBJ_JOINT, (joint.name + ".rotor").c_str());
    const int motor = rotor >= 0 ? rotor : id;
    joints_.push_back(
        {m_->jnt_qposadr[id], m_->jnt_dofadr[id], m_->jnt_qposadr[motor], m_->jnt_dofadr[motor]});
  }
}

Pose3 World::pose(std::size_t link) const {
  const int b = bodies_[link];
  Pose3 T;
  T.linear() = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(d_->xmat + 9 * b);
  T.translation() = Eigen::Map<const Vec3>(d_->xpos + 3 * b);
  T.matrix().row(3) << 0, 0, 0, 1;
  return T;
}

Vec3 World::velocity(std::size_t link, const Vec3& place) const {
  // cvel: rotation and motion of the point that is at the subtree's centre of mass.
  const int b = bodies_[link];
  const Eigen::Map<const Vec3> turning(d_->cvel + 6 * b), moving(d_->cvel + 6 * b + 3);
  const Eigen::Map<const Vec3> centre(d_->subtree_com + 3 * m_->body_rootid[b]);
  return moving + turning.cross(place - centre);
}

World::FootForce World::footForce(const std::string& foot, std::size_t link) const {
  FootForce result;
  const int geom = mj_name2id(m_.get(), mjOBJ_GEOM, ("sole." + foot).c_str());
  const Pose3 T_link_world = pose(link).inverse();
  for (int i = 0; i < d_->ncon; ++i) {
    const mjContact& contact = d_->contact[i];
    if (contact.geom1 != geom && contact.geom2 != geom) continue;
    mjtNum force[6];
    mj_contactForce(m_.get(), d_.get(), i, force);
    const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> frame(contact.frame);
    Vec3 world = frame.transpose() * Vec3(force[0], force[1], force[2]);
    if (contact.geom1 == geom) world = -world;
    const double normal = (T_link_world.linear() * world).z();
    const Vec3 place = T_link_world * Vec3(contact.pos[0], contact.pos[1], contact.pos[2]);
    result.normal += normal;
    result.moment += normal * place.head<2>();
  }
  return result;
}

}  // namespace plumbline::servo::mujoco
