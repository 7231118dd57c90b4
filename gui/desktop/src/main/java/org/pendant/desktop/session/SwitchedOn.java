package org.pendant.desktop.session;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import org.pendant.controller.Cell;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.builtin.StandardBuiltins;
import org.pendant.models.json.JsonException;
import org.pendant.protocols.ScriptConnectors;
import org.pendant.protocols.egress.AllowedHosts;
import org.pendant.protocols.toolserial.ToolSerialLine;
import org.pendant.recording.NumberStore;
import org.pendant.recording.Recording;
import org.pendant.recording.RecordingRing;
import org.pendant.recording.replay.Journal;
import org.pendant.recording.replay.ParkedRuns;
import org.pendant.recording.replay.Repetition;
import org.pendant.recording.replay.Rerun;
import org.pendant.recording.replay.RerunRefused;

/**
 * Controller that is switched on and that no thread drives yet.
 *
 * @param options it was made with
 * @param scriptConnectors by which its programs reach other computers
 * @param tool the serial line of its tool connector
 * @param journal the commands that it got so far
 * @param ring what it did so far
 * @param parked repetitions of its run
 * @param guest sees its frames before all others, in the thread that drives it
 */
record SwitchedOn(
    ControllerOptions options,
    ScriptConnectors scriptConnectors,
    ToolSerialLine tool,
    Journal journal,
    RecordingRing ring,
    ParkedRuns parked,
    FrameListener guest)
    implements AutoCloseable {
  /**
   * Switches one on.
   *
   * @param store for what it does
   * @throws IllegalArgumentException if the robot or an input is not known
   */
  static SwitchedOn with(ControllerOptions options, NumberStore store) {
    ScriptConnectors scriptConnectors = new ScriptConnectors(AllowedHosts.ANY);
    ToolSerialLine tool = new ToolSerialLine();
    boolean made = false;
    try {
      Controller controller =
          new Controller(
              options.withOutside(scriptConnectors.connectors().withToolSerial(tool)),
              StandardBuiltins.create());
      SwitchedOn on =
          of(
              options,
              scriptConnectors,
              tool,
              Journal.of(controller),
              new RecordingRing(controller.state(), controller::programSource, store),
              state -> {});
      made = true;
      return on;
    } finally {
      if (!made) {
        scriptConnectors.close();
        tool.close();
      }
    }
  }

  /** Controllers that share a cell, and what lets time pass for all of them. */
  record OfCell(Cell cell, List<SessionMember> members) {}

  /**
   * Switches the controllers of a cell on.
   *
   * @param store for what they do
   * @throws JsonException if the cell cannot be as its file says
   */
  static OfCell with(CellSetup setup, NumberStore store) throws JsonException {
    List<ScriptConnectors> scriptConnectors = new ArrayList<>();
    List<ToolSerialLine> tools = new ArrayList<>();
    List<ControllerOptions> options = new ArrayList<>();
    for (ControllerOptions each : setup.options()) {
      ScriptConnectors own = new ScriptConnectors(AllowedHosts.ANY);
      ToolSerialLine tool = new ToolSerialLine();
      scriptConnectors.add(own);
      tools.add(tool);
      options.add(each.withOutside(own.connectors().withToolSerial(tool)));
    }
    boolean made = false;
    try {
      Cell cell = new Cell(setup.plan(), options, StandardBuiltins.create());
      List<SessionMember> members = new ArrayList<>();
      for (Cell.Member each : cell.members()) {
        Controller controller = each.controller();
        SwitchedOn on =
            of(
                each.options(),
                scriptConnectors.get(members.size()),
                tools.get(members.size()),
                Journal.of(controller),
                new RecordingRing(controller.state(), controller::programSource, store),
                state -> {});
        Optional<String> address =
            each.armless() ? Optional.empty() : setup.plan().arms().get(members.size()).address();
        members.add(SessionMember.of(each, address, on));
      }
      made = true;
      return new OfCell(cell, List.copyOf(members));
    } finally {
      if (!made) {
        scriptConnectors.forEach(ScriptConnectors::close);
        tools.forEach(ToolSerialLine::close);
      }
    }
  }

  /**
   * Leads a repetition of a run on to where {@code rerun} leads, as a controller of its own.
   *
   * @param from whose run is repeated
   * @param before what that did
   * @throws RerunRefused if the run came out otherwise
   * @throws CancellationException if the rerun was cancelled
   */
  static SwitchedOn again(SwitchedOn from, Rerun rerun, Recording before, NumberStore store)
      throws RerunRefused {
    Repetition repetition = from.parked().before(rerun.frame());
    Journal journal = rerun.run(repetition);
    Controller controller = repetition.controller();
    ScriptConnectors scriptConnectors = new ScriptConnectors(AllowedHosts.ANY);
    ToolSerialLine tool = new ToolSerialLine();
    repetition.connect(scriptConnectors.connectors().withToolSerial(tool));
    return of(
        from.options(),
        scriptConnectors,
        tool,
        journal,
        RecordingRing.continuing(before, controller.state(), controller::programSource, store),
        state -> {});
  }

  /**
   * One that others have made and that reaches nothing outside.
   *
   * @param controller has run no frame
   */
  static SwitchedOn of(
      ControllerOptions options, Controller controller, FrameListener guest, NumberStore store) {
    return of(
        options,
        new ScriptConnectors(AllowedHosts.ANY),
        new ToolSerialLine(),
        Journal.of(controller),
        new RecordingRing(controller.state(), controller::programSource, store),
        guest);
  }

  private static SwitchedOn of(
      ControllerOptions options,
      ScriptConnectors scriptConnectors,
      ToolSerialLine tool,
      Journal journal,
      RecordingRing ring,
      FrameListener guest) {
    ParkedRuns parked =
        new ParkedRuns(
            journal, options, work -> Thread.ofPlatform().daemon().name("parked runs").start(work));
    return new SwitchedOn(options, scriptConnectors, tool, journal, ring, parked, guest);
  }

  Controller controller() {
    return journal.controller();
  }

  /** Closes the ways to the outside, and gives up what is parked. */
  @Override
  public void close() {
    parked.close();
    scriptConnectors.close();
    tool.close();
  }
}
