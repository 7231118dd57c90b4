package org.pendant.controller.installation;

import java.util.Optional;
import org.pendant.controller.io.DigitalLevels;
import org.pendant.controller.io.Signal;

/** Start edge: notices the edge of the input that starts the loaded program. One thread uses it. */
public final class StartEdge {
  private StartUp known = StartUp.NOTHING;
  private Optional<Signal> input = Optional.empty();
  private boolean level;

  /**
   * Looks at a frame.
   *
   * @param startUp of the installation that holds in it
   * @return whether the edge is in this frame; never in the first one after a change of {@code
   *     startUp}
   */
  public boolean look(StartUp startUp, DigitalLevels levels) {
    if (!startUp.equals(known)) {
      known = startUp;
      input = SignalId.digitalInput(startUp.startInput());
      level = isHigh(levels);
      return false;
    }
    boolean before = level;
    level = isHigh(levels);
    return level != before && level == startUp.startOnHigh();
  }

  private boolean isHigh(DigitalLevels levels) {
    return input.isPresent() && levels.level(input.get());
  }
}
