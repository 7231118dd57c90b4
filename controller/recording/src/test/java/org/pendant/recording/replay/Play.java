package org.pendant.recording.replay;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.command.Command;
import org.pendant.controller.state.ArmState;
import org.pendant.controller.state.ControllerState;
import org.pendant.language.source.Source;
import org.pendant.script.variables.VariableSample;
import org.pendant.script.vm.LoadResult;
import org.pendant.script.vm.Program;

/** A controller, the commands that it gets in which frame, and what comes of them in each. */
final class Play {
  final ControllerOptions options;
  final Journal journal;
  private final Map<Long, List<Command>> scheduled = new TreeMap<>();

  /** What each frame brought, that of frame 1 first. */
  final List<List<Object>> frames = new ArrayList<>();

  Play(ControllerOptions options) {
    this(options, JournalLimits.STANDARD);
  }

  Play(ControllerOptions options, JournalLimits limits) {
    this.options = options;
    journal = Journal.of(new Controller(options), limits);
  }

  Controller controller() {
    return journal.controller();
  }

  SwitchOn switchOn() {
    return SwitchOn.of(options, controller().builtins());
  }

  /** Repeats the run up to the end of a frame, all the way from the switch-on. */
  Journal again(long frame) throws RerunRefused {
    return again(Rerun.to(frame, journal.run()), options);
  }

  /** As {@link #again(long)}, to where the run was as in a snapshot. */
  Journal again(ControllerState recorded) throws RerunRefused {
    return again(to(recorded), options);
  }

  /** A rerun to where the run was as in a snapshot. */
  Rerun to(ControllerState recorded) throws RerunRefused {
    return Rerun.to(recorded.frame(), journal.run(), List.of(Optional.of(recorded)));
  }

  /** Carries out a rerun with a controller that has other options. */
  static Journal again(Rerun rerun, ControllerOptions options) throws RerunRefused {
    return rerun.run(Controllers.of(new Controller(options)), () -> {}).of(0);
  }

  Program program(String text) {
    LoadResult loadResult =
        controller().load(Source.of("play.script", text.getBytes(StandardCharsets.ISO_8859_1)));
    assertTrue(loadResult.program().isPresent(), () -> loadResult.diagnostics().toString());
    return loadResult.program().get();
  }

  /** Has a command left right before a frame. */
  Play at(long frame, Command command) {
    scheduled.computeIfAbsent(frame, each -> new ArrayList<>()).add(command);
    return this;
  }

  Play start(String text) {
    return at(1, new ProgramCommand.StartProgram(program(text)));
  }

  /** Runs up to the end of a frame. */
  Play until(long frame) {
    follow(controller(), frame).forEach(frames::add);
    return this;
  }

  /** Does the same to another controller from where it stands; answers what each frame brought. */
  List<List<Object>> follow(Controller other, long last) {
    List<List<Object>> brought = new ArrayList<>();
    while (other.state().frame() < last) {
      for (Command each : scheduled.getOrDefault(other.state().frame() + 1, List.of())) {
        var _ = other.submit(each);
      }
      other.advance();
      brought.add(facts(other.state()));
    }
    return brought;
  }

  /** Everything in a snapshot that is a number, a text or made of such. */
  static List<Object> facts(ControllerState state) {
    ArmState arm = state.arm();
    List<Object> facts = new ArrayList<>();
    facts.addAll(
        List.of(
            state.frame(),
            state.timeS(),
            arm.targetPositionRad(),
            arm.targetSpeedRadPerS(),
            arm.targetAccelerationRadPerS2(),
            arm.actualPositionRad(),
            arm.actualSpeedRadPerS(),
            arm.tool(),
            arm.controlMode(),
            arm.moving(),
            arm.steady(),
            arm.speedFraction(),
            arm.speedScaling(),
            state.readings()));
    facts.addAll(
        List.of(
            state.safety(),
            state.program(),
            state.debug().held(),
            state.io(),
            state.signals(),
            state.encoders(),
            state.freedrive(),
            state.openPopups(),
            state.openQuestions(),
            state.newEntries(),
            state.newPopups(),
            state.newQuestions()));
    facts.add(state.newProgramEvents());
    facts.add(state.newestEntry());
    facts.add(state.moved());
    facts.add(state.devices());
    for (VariableSample each : state.variables().globals()) {
      facts.add(each.name() + each.length());
      facts.add(each.value());
    }
    return facts;
  }
}
