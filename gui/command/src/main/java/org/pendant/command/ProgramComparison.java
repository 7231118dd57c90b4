package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.controller.Controller;
import org.pendant.controller.box.BoxCommand;
import org.pendant.language.source.Source;
import org.pendant.models.arm.Joints;
import org.pendant.recording.compare.RunComparison;
import org.pendant.recording.compare.StartOfRun;
import org.pendant.script.vm.LoadResult;

/**
 * Comparison of a program with a recording of it: brings the arm to where the recording begins,
 * runs the program in virtual time, and compares.
 */
final class ProgramComparison {
  /** How long the arm is watched at rest after the program, frames. */
  private static final int FRAMES_AFTER = 500;

  private final RecordedFile recorded;
  private final RunnableFile program;
  private final RunOptions options;
  private final PayloadOptions payload;

  /**
   * What came out.
   *
   * @param code of the run
   * @param comparison empty when the program did not move the arm, or not at all run
   */
  record Outcome(ExitCode code, Optional<RunComparison> comparison) {}

  /**
   * @param payload with what the recording says of it
   */
  ProgramComparison(
      RecordedFile recorded, RunnableFile program, RunOptions options, PayloadOptions payload) {
    this.recorded = recorded;
    this.program = program;
    this.options = options;
    this.payload = payload;
  }

  /**
   * Runs the program and compares.
   *
   * @param console takes what the program writes
   */
  Outcome run(Interruption interruption, WallLimit wall, Console console) throws UsageException {
    if (program.source().isEmpty()) {
      return new Outcome(ExitCode.DOES_NOT_COMPILE, Optional.empty());
    }
    Source source = program.source().get();
    Joints start = StartOfRun.positionRad(recorded.samples());
    Controller controller = new Controller(options.controller().withStart(start));
    LoadResult loaded = controller.load(source);
    Report.diagnostics(source, loaded.diagnostics()).forEach(console::complainInLines);
    program.wrongInReceived(loaded.diagnostics()).forEach(console::complainFromEnglish);
    if (loaded.program().isEmpty()) {
      return new Outcome(ExitCode.DOES_NOT_COMPILE, Optional.empty());
    }
    payload.declareTo(controller);
    double slider = StartOfRun.speedFraction(recorded.samples()).orElse(1);
    if (slider > 0 && slider < 1) {
      var _ = controller.submit(new BoxCommand.SetSpeedFraction(slider));
      controller.advance();
    }
    SampleCollector collector = new SampleCollector(recorded.samples(), controller.state());
    ExitCode code =
        new HeadlessRun(program, controller, options, interruption, wall, console, collector)
            .run(loaded.program().get());
    for (int i = 0; i < FRAMES_AFTER; i++) {
      controller.advance();
      collector.see(controller.state());
    }
    if (!collector.moved()) {
      console.complain(
          Report.error(
              source,
              code == ExitCode.DONE
                  ? text("armNotMovedWithin", SampleCollector.MAX_WAIT_S)
                  : text("armNotMoved")));
      return new Outcome(code.or(ExitCode.PROGRAM_FAILED), Optional.empty());
    }
    RunComparison comparison =
        RunComparison.of(
            recorded.samples(), collector.samples(), controller.state().arm().kinematics());
    return new Outcome(code, Optional.of(noted(comparison)));
  }

  private RunComparison noted(RunComparison comparison) {
    List<String> notes = new ArrayList<>(recorded.notes());
    notes.addAll(comparison.notes());
    if (!StartOfRun.atRest(recorded.samples())) {
      notes.add(
          "the recording begins in motion: the arm starts 1 s before it, on the straight line of"
              + " its joints");
    }
    if (payload.lacksCentre()) {
      notes.add(
          "the centre of gravity of the payload was not recorded and is taken to be in the flange;"
              + " --cog says where it is");
    }
    return new RunComparison(
        comparison.recorded(),
        comparison.pendant(),
        comparison.shiftS(),
        comparison.differences(),
        notes);
  }
}
