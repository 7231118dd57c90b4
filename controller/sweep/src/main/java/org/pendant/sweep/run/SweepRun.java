package org.pendant.sweep.run;

import static org.pendant.sweep.run.SweepRunTexts.text;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import org.pendant.controller.Controller;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.box.BoxCommand;
import org.pendant.controller.box.WorldCommand;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;
import org.pendant.controller.io.InputWaveforms;
import org.pendant.controller.io.IoCommand;
import org.pendant.controller.safety.SafetyStop;
import org.pendant.controller.state.ControllerState;
import org.pendant.language.source.ByteText;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.source.Source;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.time.FrameTime;
import org.pendant.motion.MotionFailure;
import org.pendant.script.value.Value;
import org.pendant.script.vm.Ending;
import org.pendant.script.vm.LoadResult;
import org.pendant.script.vm.Program;
import org.pendant.script.vm.ProgramState;
import org.pendant.sweep.plan.SweepVariant;

/**
 * Run of one variant, from the switch-on of a controller of its own to the end of its program and
 * until the arm is at rest, as {@code pendant run} does it.
 */
final class SweepRun {
  /** An arm that is not at rest by then never will be. */
  private static final int MAX_FRAMES_TO_REST = 5_000;

  private static final int MAX_TEXT = 300;
  private static final Joints UNKNOWN =
      Joints.of(Double.NaN, Double.NaN, Double.NaN, Double.NaN, Double.NaN, Double.NaN);
  private static final JointLoads NO_LOADS = new JointLoads(UNKNOWN, UNKNOWN, UNKNOWN);

  private final SweepJob job;
  private final SweepVariant variant;
  private final RunWatcher watcher;

  SweepRun(SweepJob job, SweepVariant variant, RunWatcher watcher) {
    this.job = job;
    this.variant = variant;
    this.watcher = watcher;
  }

  /** The result of a run that never began. */
  static SweepResult failed(SweepVariant variant, RunOutcome outcome, String reason) {
    double unknown = Double.NaN;
    return new SweepResult(
        variant,
        outcome,
        reason,
        0,
        0,
        NO_LOADS,
        NO_LOADS,
        NO_LOADS,
        unknown,
        unknown,
        unknown,
        unknown,
        unknown,
        unknown,
        unknown,
        unknown,
        List.of(unknown, unknown, unknown),
        List.of(),
        List.of(),
        List.of(),
        0);
  }

  SweepResult result() {
    VariantSetup setup;
    Controller controller;
    try {
      setup = job.setup(variant);
      controller = new Controller(setup.options(), job.builtins());
    } catch (IllegalArgumentException e) {
      return failed(variant, RunOutcome.REFUSED, e.getMessage());
    }
    LoadResult loaded = job.load(setup.program());
    if (loaded.program().isEmpty()) {
      return failed(
          variant, RunOutcome.DOES_NOT_COMPILE, firstError(setup.program(), loaded.diagnostics()));
    }
    watcher.begin(controller);
    prepare(controller, setup);
    return run(controller, loaded.program().get());
  }

  private static String firstError(Source program, List<Diagnostic> diagnostics) {
    Diagnostic first = diagnostics.stream().filter(Diagnostic::isError).findFirst().orElseThrow();
    int at = Math.min(first.range().start(), program.text().length());
    return text("line", program.line(at), ByteText.decoded(first.message()));
  }

  private static void prepare(Controller controller, VariantSetup setup) {
    setup
        .slider()
        .ifPresent(
            share -> {
              var _ = controller.submit(new BoxCommand.SetSpeedFraction(share));
            });
    setup
        .load()
        .ifPresent(
            load -> {
              var _ = controller.submit(new WorldCommand.AttachLoad(Optional.of(load)));
            });
    if (!setup.inputs().equals(InputWaveforms.NONE)) {
      var _ = controller.submit(new IoCommand.PlayInputs(setup.inputs()));
    }
  }

  private SweepResult run(Controller controller, Program program) {
    RunMeasure measure = new RunMeasure(controller.state(), controller.safety());
    Optional<String> refusal =
        ask(controller, measure, new ProgramCommand.StartProgram(program)).complaint();
    if (refusal.isPresent()) {
      return failed(variant, RunOutcome.REFUSED, refusal.get());
    }
    double limitS = job.plan().settings().timeLimitS();
    Optional<SafetyStop> heldBy = Optional.empty();
    boolean timedOut = false;
    while (controller.state().program().state() != ProgramState.STOPPED) {
      timedOut = measure.timeS() >= limitS;
      boolean paused = controller.state().program().state() == ProgramState.PAUSED;
      if (paused && heldBy.isEmpty()) {
        heldBy = controller.state().safety().stop();
      }
      if (timedOut || heldBy.isPresent()) {
        ask(controller, measure, new ProgramCommand.StopProgram());
      } else if (paused) {
        ask(controller, measure, new ProgramCommand.ResumeProgram());
      } else {
        advance(controller, measure);
      }
    }
    double durationS = measure.timeS();
    for (int i = 0; i < MAX_FRAMES_TO_REST && controller.state().arm().moving(); i++) {
      advance(controller, measure);
    }
    return ended(controller, measure, durationS, timedOut, heldBy);
  }

  private Reply ask(Controller controller, RunMeasure measure, Command command) {
    CompletableFuture<Reply> reply = controller.submit(command);
    advance(controller, measure);
    return reply.join();
  }

  private void advance(Controller controller, RunMeasure measure) {
    controller.advance();
    ControllerState state = controller.state();
    measure.see(state);
    watcher.see(state);
  }

  private SweepResult ended(
      Controller controller,
      RunMeasure measure,
      double durationS,
      boolean timedOut,
      Optional<SafetyStop> heldBy) {
    ControllerState state = controller.state();
    if (timedOut) {
      return result(
          controller,
          measure,
          durationS,
          RunOutcome.NEVER_ENDED,
          text("stillRuns", job.plan().settings().timeLimitS()),
          measure.line());
    }
    return switch (state.program().ending().orElseThrow()) {
      case Ending.Finished _ ->
          result(controller, measure, durationS, RunOutcome.FINISHED, "", measure.line());
      case Ending.Halted _ ->
          result(controller, measure, durationS, RunOutcome.HALTED, "", measure.line());
      case Ending.Failed(var failure) ->
          result(
              controller,
              measure,
              durationS,
              failure.code().equals("internal-error")
                  ? RunOutcome.INTERNAL_ERROR
                  : RunOutcome.FAILED,
              ByteText.decoded(failure.message()),
              failure.line());
      case Ending.Stopped _ -> {
        Optional<String> why =
            heldBy
                .or(() -> state.safety().stop())
                .map(SafetyStop::message)
                .or(() -> state.arm().fault().map(MotionFailure::message));
        int line =
            state
                .safety()
                .stopPlace()
                .map(each -> each.line())
                .filter(each -> each > 0)
                .orElse(measure.line());
        yield result(
            controller, measure, durationS, RunOutcome.STOPPED, why.orElse("stopped"), line);
      }
    };
  }

  private SweepResult result(
      Controller controller,
      RunMeasure measure,
      double durationS,
      RunOutcome outcome,
      String reason,
      int line) {
    Pose end = controller.state().arm().actualTcpInBase();
    return new SweepResult(
        variant,
        outcome,
        bounded(reason),
        line,
        Math.round(durationS / FrameTime.FRAME_S) * 2 / 1000.0,
        measure.torque(),
        measure.speed(),
        measure.current(),
        measure.toolSpeedMPerS(),
        measure.toolSpeedShare(),
        measure.jointLimitRad(),
        measure.planeM(),
        measure.singularity(),
        measure.forceN(),
        measure.torqueNm(),
        measure.energyJ(),
        List.of(end.x(), end.y(), end.z()),
        measure.lines(),
        measure.outputs(),
        variables(controller),
        measure.digest());
  }

  private List<String> variables(Controller controller) {
    List<String> wanted = job.plan().settings().variables();
    if (wanted.isEmpty()) {
      return List.of();
    }
    Map<String, Value> globals = controller.globals();
    return wanted.stream()
        .map(
            each ->
                globals.containsKey(each)
                    ? bounded(ByteText.decoded(globals.get(each).text()))
                    : "")
        .toList();
  }

  private static String bounded(String text) {
    return text.length() <= MAX_TEXT ? text : text.substring(0, MAX_TEXT) + "...";
  }
}
