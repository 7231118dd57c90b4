package org.pendant.command.service;

import java.util.Optional;
import java.util.function.Supplier;
import org.pendant.controller.Robot;
import org.pendant.language.source.Source;

/** Robot access: leads others to the robot of a window, such as editors that debug its programs. */
public interface RobotAccess {
  /**
   * A robot is switched on, in place of the one before.
   *
   * @param program the text of its running or last program; asked in its frame loop only
   */
  void show(Robot robot, Supplier<Optional<Source>> program);

  /** The robot is about to be switched off: who is with it leaves. */
  void hide();
}
