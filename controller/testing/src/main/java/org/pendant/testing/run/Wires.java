package org.pendant.testing.run;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.function.Consumer;
import org.pendant.controller.bench.OutputFollower;
import org.pendant.controller.command.Command;
import org.pendant.controller.io.DigitalLevels;
import org.pendant.controller.io.InputOwners;
import org.pendant.controller.io.IoCommand;
import org.pendant.controller.io.SignalWrite;
import org.pendant.controller.state.ControllerState;

/** Wires of a test: inputs that follow outputs a while later. */
final class Wires {

  /** One change of an input that is still to come. */
  private record Due(long frame, SignalWrite write) {}

  /** One wire, and what its output was. */
  private static final class Wire {
    private final OutputFollower follower;
    private final Deque<Due> due = new ArrayDeque<>();
    private boolean known;
    private boolean last;

    Wire(OutputFollower follower) {
      this.follower = follower;
    }

    private void step(long frame, DigitalLevels levels, List<SignalWrite> writes) {
      boolean level = (levels.bits(follower.output().bank()) >> follower.output().index() & 1) != 0;
      if (!known || level != last) {
        known = true;
        last = level;
        due.add(
            new Due(
                frame + follower.delayFrames(),
                new SignalWrite.Digital(follower.input(), level != follower.inverted())));
      }
      while (!due.isEmpty() && due.peek().frame() <= frame) {
        writes.add(due.poll().write());
      }
    }
  }

  private final List<OutputFollower> followers;
  private final List<Wire> wires = new ArrayList<>();

  /**
   * The wires of a test.
   *
   * @param followers may become more while it runs
   */
  Wires(List<OutputFollower> followers) {
    this.followers = followers;
  }

  /** Has inputs follow after a frame. */
  void step(ControllerState state, Consumer<Command> post) {
    if (followers.isEmpty()) {
      return;
    }
    while (wires.size() < followers.size()) {
      wires.add(new Wire(followers.get(wires.size())));
    }
    List<SignalWrite> writes = new ArrayList<>();
    for (Wire each : wires) {
      each.step(state.frame(), state.io(), writes);
    }
    if (!writes.isEmpty()) {
      post.accept(new IoCommand.WriteSignals(InputOwners.BY_HAND, writes));
    }
  }
}
