package org.pendant.desktop.move;

import java.util.Collections;
import java.util.function.Consumer;
import java.util.function.IntFunction;
import org.pendant.controller.box.BoxSetup;
import org.pendant.desktop.unit.DisplayUnit;
import org.pendant.kit.settings.Settings;
import org.pendant.models.arm.Joints;

/** Home presenter: where home is, one for each kind of robot. */
final class HomePresenter {
  private final Settings settings;
  private final Draft draft;
  private String robotId;
  private Joints homeRad;
  private Consumer<Joints> listener = home -> {};

  /**
   * As it was left.
   *
   * @param check whether a joint may be somewhere
   */
  HomePresenter(Settings settings, String robotId, DisplayUnit angle, Draft.Check check) {
    this.settings = settings;
    draft = new Draft(Collections.nCopies(Joints.COUNT, angle), check);
    setRobot(robotId);
  }

  /** Another robot has been switched on. */
  void setRobot(String id) {
    robotId = id;
    homeRad =
        settings
            .get(key())
            .flatMap(text -> SavedNumbers.read(text, Joints.COUNT))
            .map(Joints::of)
            .orElse(BoxSetup.START_RAD);
    draft.reset();
    draft.follow(homeRad.toArray());
  }

  private String key() {
    return "move.home." + robotId;
  }

  /** Joint positions, rad. */
  Joints homeRad() {
    return homeRad;
  }

  /** Whether it is where a robot is when it is switched on. */
  boolean standard() {
    return homeRad.equals(BoxSetup.START_RAD);
  }

  /** Home is somewhere else from now on, also after the next start. */
  void set(Joints positionRad) {
    homeRad = positionRad;
    settings.put(key(), SavedNumbers.text(positionRad.toArray()));
    draft.reset();
    draft.follow(positionRad.toArray());
    listener.accept(positionRad);
  }

  /** Home is what the installation says, until it is set here. */
  void follow(Joints installedRad) {
    if (!installedRad.equals(homeRad)) {
      homeRad = installedRad;
      draft.reset();
      draft.follow(installedRad.toArray());
    }
  }

  /** Tells {@code next} of each home that is set here. */
  void whenSet(Consumer<Joints> next) {
    listener = next;
  }

  /** Home is what the user has typed. */
  void setTyped() {
    if (draft.edited() && draft.valid()) {
      set(Joints.of(draft.values()));
    }
  }

  /** Whether home is within the ranges of the joints. */
  boolean within(IntFunction<JointRange> ranges) {
    for (int i = 0; i < Joints.COUNT; i++) {
      if (!ranges.apply(i).contains(homeRad.get(i))) {
        return false;
      }
    }
    return true;
  }

  void setAngle(DisplayUnit angle) {
    draft.convert(Collections.nCopies(Joints.COUNT, angle), draft.values());
  }

  /** The positions as they are shown and typed. */
  Draft draft() {
    return draft;
  }
}
