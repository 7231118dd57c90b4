package org.pendant.editors.dap.run;

import java.util.Optional;
import java.util.concurrent.Semaphore;
import java.util.function.Supplier;
import org.pendant.controller.Robot;
import org.pendant.language.source.Source;

/**
 * Attachable robot: one that others drive and start programs on, and that an editor may look into.
 * One editor at a time, as a robot has one debugger.
 */
public final class AttachableRobot {
  private final Robot robot;
  private final Supplier<Optional<Source>> program;
  private final Semaphore place = new Semaphore(1);

  /**
   * A robot.
   *
   * @param program the text of the running or last program; asked in the frame loop only
   */
  public AttachableRobot(Robot robot, Supplier<Optional<Source>> program) {
    this.robot = robot;
    this.program = program;
  }

  Robot robot() {
    return robot;
  }

  Supplier<Optional<Source>> program() {
    return program;
  }

  /** Takes the only place; whether it was free. */
  boolean take() {
    return place.tryAcquire();
  }

  void giveBack() {
    place.release();
  }
}
