package org.pendant.controller;

import java.util.Optional;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.safety.SafetyStop;
import org.pendant.controller.state.StopPlace;
import org.pendant.models.arm.Joints;

/** Stop snapshot: where program and arm were when the present stop began. */
final class StopSnapshot {
  private Optional<SafetyStop> stop = Optional.empty();
  private Optional<StopPlace> place = Optional.empty();

  /**
   * Looks at the stop of this frame.
   *
   * @param line that the program had reached before the safety functions could end it
   */
  void look(ControlBox box, int line) {
    Optional<SafetyStop> now = box.safety().stop();
    if (now.equals(stop)) {
      return;
    }
    // one stop may turn into a worse one, which finds the program ended
    int reached = line == 0 ? place.map(StopPlace::line).orElse(0) : line;
    stop = now;
    place = now.map(each -> place(box, reached, each.aboutTarget()));
  }

  /** What the safety functions have looked at: the target lies ahead of the arm. */
  private static StopPlace place(ControlBox box, int line, boolean target) {
    Joints q = target ? box.drive().drivenPositionRad() : box.drive().actualPositionRad();
    return new StopPlace(
        line, box.kinematics().forward().tcpPose(q, box.flange().tool().inFlange()), q);
  }

  /** Where the present stop began. */
  Optional<StopPlace> place() {
    return place;
  }
}
