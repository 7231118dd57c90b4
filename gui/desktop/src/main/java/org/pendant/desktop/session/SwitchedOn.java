package org.pendant.desktop.session;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import org.pendant.controller.Cell;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.Frames;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.builtin.StandardBuiltins;
import org.pendant.models.json.JsonException;
import org.pendant.protocols.ScriptConnectors;
import org.pendant.protocols.egress.AllowedHosts;
import org.pendant.protocols.toolserial.ToolSerialLine;
import org.pendant.recording.NumberStore;
import org.pendant.recording.Recording;
import org.pendant.recording.RecordingRing;
import org.pendant.recording.replay.Controllers;
import org.pendant.recording.replay.Journal;
import org.pendant.recording.replay.ParkedRuns;
import org.pendant.recording.replay.Repetition;
import org.pendant.recording.replay.Rerun;
import org.pendant.recording.replay.RerunRefused;
import org.pendant.recording.replay.RunJournal;
import org.pendant.recording.replay.SwitchOn;
import org.pendant.script.function.Builtins;

/**
 * Controller that is switched on and that no thread drives yet.
 *
 * @param options it was made with
 * @param scriptConnectors by which its programs reach other computers
 * @param tool the serial line of its tool connector
 * @param journal the commands that it got so far
 * @param ring what it did so far
 * @param parked repetitions of its run; those that share a cell have the same
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
      Builtins<ControlBox> builtins = StandardBuiltins.create();
      Controller controller =
          new Controller(
              options.withOutside(scriptConnectors.connectors().withToolSerial(tool)), builtins);
      Journal journal = Journal.of(controller);
      SwitchedOn on =
          new SwitchedOn(
              options,
              scriptConnectors,
              tool,
              journal,
              new RecordingRing(controller.state(), controller::programSource, store),
              parked(journal.run(), SwitchOn.of(options, builtins)),
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

  /**
   * Switches the controllers of a cell on.
   *
   * @param store for what they do
   * @throws JsonException if the cell cannot be as its file says
   */
  static List<SessionMember> with(CellSetup setup, NumberStore store) throws JsonException {
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
      Builtins<ControlBox> builtins = StandardBuiltins.create();
      Cell cell = new Cell(setup.plan(), options, builtins);
      List<SessionMember> members = new ArrayList<>();
      RunJournal run = RunJournal.of(Controllers.of(cell));
      ParkedRuns parked = parked(run, SwitchOn.of(setup.plan(), setup.options(), builtins));
      for (int i = 0; i < options.size(); i++) {
        members.add(
            member(
                setup,
                cell.members().get(i),
                scriptConnectors.get(i),
                tools.get(i),
                run.of(i),
                parked,
                state -> {},
                store));
      }
      made = true;
      return List.copyOf(members);
    } finally {
      if (!made) {
        scriptConnectors.forEach(ScriptConnectors::close);
        tools.forEach(ToolSerialLine::close);
      }
    }
  }

  /**
   * Those of a cell that others have made and that reach nothing outside.
   *
   * @param cell has run no frame
   * @param guest sees the frames of the first one before all others
   */
  static List<SessionMember> of(
      CellSetup setup, Cell cell, FrameListener guest, NumberStore store) {
    RunJournal run = RunJournal.of(Controllers.of(cell));
    ParkedRuns parked =
        parked(
            run,
            SwitchOn.of(
                setup.plan(), setup.options(), cell.members().getFirst().controller().builtins()));
    List<SessionMember> members = new ArrayList<>();
    for (Cell.Member each : cell.members()) {
      members.add(
          member(
              setup,
              each,
              new ScriptConnectors(AllowedHosts.ANY),
              new ToolSerialLine(),
              run.of(members.size()),
              parked,
              members.isEmpty() ? guest : state -> {},
              store));
    }
    return List.copyOf(members);
  }

  private static SessionMember member(
      CellSetup setup,
      Cell.Member of,
      ScriptConnectors scriptConnectors,
      ToolSerialLine tool,
      Journal journal,
      ParkedRuns parked,
      FrameListener guest,
      NumberStore store) {
    Controller controller = of.controller();
    SwitchedOn on =
        new SwitchedOn(
            of.options(),
            scriptConnectors,
            tool,
            journal,
            new RecordingRing(controller.state(), controller::programSource, store),
            parked,
            guest);
    Optional<String> address =
        of.armless() ? Optional.empty() : setup.plan().arms().get(journal.member()).address();
    return SessionMember.of(of, address, on);
  }

  /**
   * Leads a repetition of a run on to where {@code rerun} leads, as controllers of their own.
   *
   * @param from whose run is repeated, in their order
   * @return those that take their places
   * @throws RerunRefused if the run came out otherwise
   * @throws CancellationException if the rerun was cancelled
   */
  static List<SwitchedOn> again(List<SwitchedOn> from, Rerun rerun, NumberStore store)
      throws RerunRefused {
    List<Recording> before = from.stream().map(each -> each.ring().recording()).toList();
    ParkedRuns parked = from.getFirst().parked();
    Repetition repetition = parked.before(rerun.frame());
    RunJournal run = rerun.run(repetition);
    ParkedRuns next = parked.branch(run);
    List<SwitchedOn> again = new ArrayList<>();
    for (int i = 0; i < from.size(); i++) {
      ScriptConnectors scriptConnectors = new ScriptConnectors(AllowedHosts.ANY);
      ToolSerialLine tool = new ToolSerialLine();
      repetition.connect(i, scriptConnectors.connectors().withToolSerial(tool));
      Controller controller = run.controllers().all().get(i);
      again.add(
          new SwitchedOn(
              from.get(i).options(),
              scriptConnectors,
              tool,
              run.of(i),
              RecordingRing.continuing(
                  before.get(i), controller.state(), controller::programSource, store),
              next,
              state -> {}));
    }
    return List.copyOf(again);
  }

  /**
   * One that others have made and that reaches nothing outside.
   *
   * @param controller has run no frame
   */
  static SwitchedOn of(
      ControllerOptions options, Controller controller, FrameListener guest, NumberStore store) {
    Journal journal = Journal.of(controller);
    return new SwitchedOn(
        options,
        new ScriptConnectors(AllowedHosts.ANY),
        new ToolSerialLine(),
        journal,
        new RecordingRing(controller.state(), controller::programSource, store),
        parked(journal.run(), SwitchOn.of(options, controller.builtins())),
        guest);
  }

  private static ParkedRuns parked(RunJournal run, SwitchOn switchOn) {
    return new ParkedRuns(
        run, switchOn, work -> Thread.ofPlatform().daemon().name("parked runs").start(work));
  }

  /** What lets time pass for it, and for those that share a cell with it. */
  Frames frames() {
    return journal.run().controllers().frames();
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
