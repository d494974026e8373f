#include "modules/infrastructure/DrawingFrames.h"

#include "framework/DrawingSite.h"

namespace plumbline {

using inspect::DrawingOwner;

MAKE_MODULE(DrawingFrames)
MAKE_MODULE_OBJECT(DrawingOwner, DrawingOwner)

void DrawingFrames::drawBody(Drawing& drawing) const {
  drawing.in(DrawingFrame::torso);
  const auto& links = theRobotDescription->model.links;
  const auto& places = theFKModel->T_torso_link;
  for (std::size_t i = 0; i < links.size() && i < places.size(); ++i) {
    if (links[i].parent < 0) continue;
    drawing.line(places[static_cast<std::size_t>(links[i].parent)].translation(), places[i].translation(),
                 colours::white, 4);
  }
  for (const Pose3* sole : {&theFKModel->T_torso_leftSole, &theFKModel->T_torso_rightSole})
    drawing.arrow(sole->translation(), Vec3(*sole * Vec3(0.1, 0, 0)), colours::white);
  drawing.sphere(theFKModel->T_torso_head.translation(), 0.06, colours::white);
  drawing.sphere(theFKModel->com, 0.03, colours::red);
}

void DrawingFrames::execute() {
  setDrawingFrames(theRobotPose->pose, theTorsoPose->T_ground_torso);
  if (owner_) {
    owner_->number.store(thePlayerInfo->number, std::memory_order_relaxed);
    owner_->right.store(!thePlayerInfo->leftSide, std::memory_order_relaxed);
  }
  DEBUG_DRAWING("draw:RobotPose", {
    const Pose2& pose = theRobotPose->pose;
    const shapes::Colour colour = theRobotPose->valid ? colours::cyan : colours::red;
    drawing.circle(pose.position, theRobotPose->positionDeviation, colour);
    drawing.pose(pose, 0.5, colour, 3);
    drawing.text(pose.position, std::to_string(thePlayerInfo->number), colour);
  });
  DEBUG_DRAWING("draw:FKModel:body", drawBody(drawing));
}

}  // namespace plumbline
