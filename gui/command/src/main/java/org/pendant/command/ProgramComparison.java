package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.controller.Controller;
import org.pendant.controller.box.BoxCommand;
import org.pendant.language.source.Source;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.JointLimits;
import org.pendant.models.arm.Joints;
import org.pendant.recording.compare.ComparisonNotes;
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
    refuseOutside(options.controller().arm(), start);
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

  /** Joints that turn without an end on one arm are within a range on another. */
  private static void refuseOutside(ArmDescription arm, Joints start) throws UsageException {
    for (int i = 0; i < Joints.COUNT; i++) {
      JointLimits range = arm.joints().get(i);
      if (!range.contains(start.get(i))) {
        throw new UsageException(
            text(
                "recordingBeginsOutside",
                i,
                Decimal.text(Math.toDegrees(start.get(i)), 1),
                arm.displayName(),
                Decimal.text(Math.toDegrees(range.minRad()), 1),
                Decimal.text(Math.toDegrees(range.maxRad()), 1),
                RunOptions.ROBOT.name()));
      }
    }
  }

  private RunComparison noted(RunComparison comparison) {
    List<String> notes = new ArrayList<>(recorded.notes());
    notes.addAll(comparison.notes());
    if (!StartOfRun.atRest(recorded.samples())) {
      notes.add(ComparisonNotes.beginsInMotion());
    }
    if (payload.lacksCentre()) {
      notes.add(ComparisonNotes.unknownCentreOfGravity());
    }
    return new RunComparison(
        comparison.recorded(),
        comparison.pendant(),
        comparison.shiftS(),
        comparison.differences(),
        notes);
  }
}
