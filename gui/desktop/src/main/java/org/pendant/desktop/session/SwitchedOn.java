package org.pendant.desktop.session;

import java.util.concurrent.CancellationException;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.builtin.StandardBuiltins;
import org.pendant.protocols.ScriptConnectors;
import org.pendant.protocols.egress.AllowedHosts;
import org.pendant.protocols.toolserial.ToolSerialLine;
import org.pendant.recording.RecordingRing;
import org.pendant.recording.replay.Journal;
import org.pendant.recording.replay.Rerun;
import org.pendant.recording.replay.RerunRefused;
import org.pendant.script.function.Builtins;

/**
 * Controller that is switched on and that no thread drives yet.
 *
 * @param options it was made with
 * @param scriptConnectors by which its programs reach other computers
 * @param tool the serial line of its tool connector
 * @param journal the commands that it got so far
 * @param ring what it did so far
 * @param guest sees its frames before all others, in the thread that drives it
 */
record SwitchedOn(
    ControllerOptions options,
    ScriptConnectors scriptConnectors,
    ToolSerialLine tool,
    Journal journal,
    RecordingRing ring,
    FrameListener guest)
    implements AutoCloseable {
  /** Makes the journal of a controller that was just switched on. */
  private interface Begin {
    Journal of(Controller controller, RecordingRing ring) throws RerunRefused;
  }

  /**
   * Switches one on.
   *
   * @throws IllegalArgumentException if the robot or an input is not known
   */
  static SwitchedOn with(ControllerOptions options) {
    try {
      return with(options, StandardBuiltins.create(), (controller, ring) -> Journal.of(controller));
    } catch (RerunRefused e) {
      throw new IllegalStateException("nothing is run again", e);
    }
  }

  /**
   * Switches one on and brings it to where {@code rerun} leads.
   *
   * @param options those of the controller whose run is repeated
   * @param builtins those of that controller
   * @throws RerunRefused if the run came out otherwise
   * @throws CancellationException if the rerun was cancelled
   */
  static SwitchedOn again(ControllerOptions options, Builtins<ControlBox> builtins, Rerun rerun)
      throws RerunRefused {
    return with(options, builtins, (controller, ring) -> rerun.run(controller, ring::take));
  }

  private static SwitchedOn with(
      ControllerOptions options, Builtins<ControlBox> builtins, Begin begin) throws RerunRefused {
    ScriptConnectors scriptConnectors = new ScriptConnectors(AllowedHosts.ANY);
    ToolSerialLine tool = new ToolSerialLine();
    boolean made = false;
    try {
      Controller controller =
          new Controller(
              options.withOutside(scriptConnectors.connectors().withToolSerial(tool)), builtins);
      RecordingRing ring = new RecordingRing(controller.state(), controller::programSource);
      SwitchedOn on =
          new SwitchedOn(
              options, scriptConnectors, tool, begin.of(controller, ring), ring, state -> {});
      made = true;
      return on;
    } finally {
      if (!made) {
        scriptConnectors.close();
        tool.close();
      }
    }
  }

  /**
   * One that others have made and that reaches nothing outside.
   *
   * @param controller has run no frame
   */
  static SwitchedOn of(ControllerOptions options, Controller controller, FrameListener guest) {
    return new SwitchedOn(
        options,
        new ScriptConnectors(AllowedHosts.ANY),
        new ToolSerialLine(),
        Journal.of(controller),
        new RecordingRing(controller.state(), controller::programSource),
        guest);
  }

  Controller controller() {
    return journal.controller();
  }

  /** Closes the ways to the outside. */
  @Override
  public void close() {
    scriptConnectors.close();
    tool.close();
  }
}
