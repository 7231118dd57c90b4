package org.pendant.recording.whatif;

import static org.pendant.recording.whatif.VariantTexts.text;

import java.util.Optional;
import org.pendant.controller.safety.SafetyStop;
import org.pendant.controller.state.ControllerState;
import org.pendant.recording.replay.Controllers;
import org.pendant.script.vm.Ending;
import org.pendant.script.vm.ProgramEvent;

/** Neighbour watch: what went wrong first with any of the other controllers of a cell. */
final class NeighbourWatch {
  private final Controllers all;
  private final int member;
  private Optional<String> trouble = Optional.empty();

  /**
   * Nothing yet.
   *
   * @param member number of the controller that is not looked at
   */
  NeighbourWatch(Controllers all, int member) {
    this.all = all;
    this.member = member;
  }

  /** Looks at a frame that has gone by. */
  void see() {
    for (int i = 0; i < all.all().size() && trouble.isEmpty(); i++) {
      String name = all.names().get(i);
      trouble =
          i == member
              ? Optional.empty()
              : trouble(all.all().get(i).state()).map(why -> name + ": " + why);
    }
  }

  private static Optional<String> trouble(ControllerState state) {
    Optional<SafetyStop> stop = state.safety().stop();
    if (stop.isPresent()) {
      return Optional.of(stop.get().message());
    }
    for (ProgramEvent each : state.newProgramEvents()) {
      if (each instanceof ProgramEvent.Ended(_, Ending.Failed(var failure))) {
        return Optional.of(text("failedInLine", failure.line(), failure.message()));
      }
    }
    return Optional.empty();
  }

  /** What it was, with the name of the controller; empty while all is well. */
  Optional<String> trouble() {
    return trouble;
  }
}
