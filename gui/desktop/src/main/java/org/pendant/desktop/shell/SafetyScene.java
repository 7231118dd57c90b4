package org.pendant.desktop.shell;

import static org.pendant.desktop.shell.ShellTexts.text;

import java.util.Optional;
import java.util.function.Supplier;
import org.pendant.controller.safety.SafetyChecksum;
import org.pendant.controller.safety.SafetyConfiguration;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.state.SafetyStatus;
import org.pendant.desktop.scene.SafetySight;
import org.pendant.desktop.session.RobotSession;
import org.pendant.models.arm.Joints;

/** Safety scene: what the picture of the arm has of the safety functions. */
final class SafetyScene {
  private final RobotSession session;
  private final SceneShows shows;
  private Supplier<Optional<SafetyConfiguration>> proposed = Optional::empty;
  private Optional<Known> known = Optional.empty();

  private record Known(SafetyConfiguration holds, SafetyChecksum checksum) {}

  SafetyScene(RobotSession session, SceneShows shows) {
    this.session = session;
    this.shows = shows;
  }

  /** Where to ask for what people type and have not applied yet. */
  void setProposed(Supplier<Optional<SafetyConfiguration>> draft) {
    proposed = draft;
  }

  /** The entries of the menu. */
  void addTo(SceneBar bar) {
    bar.check("scene.safety-planes", text("showSafetyPlanes"), shows::planes, shows::setPlanes);
    bar.check(
        "scene.safety-direction",
        text("showWhereTheToolMayPoint"),
        shows::direction,
        shows::setDirection);
    bar.check(
        "scene.safety-joints",
        text("showTheRangeOfTheJoint"),
        shows::jointRange,
        shows::setJointRange);
    bar.check("scene.safety-reach", text("showHowFarTheArmReaches"), shows::reach, shows::setReach);
  }

  /** What is to be seen at a moment; of limits that did not hold then only what is proposed. */
  SafetySight sight(ControllerState state, Joints positionRad) {
    SafetyStatus status = state.safety();
    SafetyConfiguration holds = session.robot().safety();
    boolean held = checksum(holds).equals(status.checksum());
    return SafetySight.of(
        holds,
        proposed.get(),
        status.stop().filter(each -> held),
        status.reduced(),
        positionRad,
        new SafetySight.Wanted(
            held && shows.planes(),
            held && shows.direction(),
            held && shows.jointRange(),
            shows.reach()));
  }

  private SafetyChecksum checksum(SafetyConfiguration holds) {
    if (known.isEmpty() || !known.get().holds.equals(holds)) {
      known = Optional.of(new Known(holds, SafetyChecksum.of(holds)));
    }
    return known.get().checksum;
  }
}
