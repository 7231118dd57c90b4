package org.pendant.project.program.script;

import java.util.List;
import java.util.Optional;
import org.pendant.controller.installation.ConveyorSetup;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.TemplateStep;
import org.pendant.project.program.TemplateStep.ForceKind;
import org.pendant.project.program.WaypointPosition;

/**
 * Process writer: writes templates in which the arm gives way to something while their children
 * run.
 */
final class ProcessWriter {
  private static final List<Boolean> ALONG_Z = List.of(false, false, true, false, false, false);
  private static final double STOP_M_PER_S2 = 5;

  /** With what the driver presses where people have chosen its speed. */
  private static final double SCREW_FORCE_N = 30;

  /** How fast it follows at most where people have chosen its force. */
  private static final double SCREW_SPEED_M_PER_S = 0.1;

  private final ScriptContext context;
  private final ScriptStepWriter steps;
  private final ScriptLines lines;
  private final SignalCode signals;

  ProcessWriter(ScriptContext context, ScriptStepWriter steps) {
    this.context = context;
    this.steps = steps;
    lines = context.lines();
    signals = new SignalCode(context.installation());
  }

  void write(ProgramNode node, TemplateStep.Force force) {
    Optional<String> frame =
        force.feature().equals(WaypointPosition.TOOL)
            ? Optional.of("tool_pose()")
            : steps.motion().frame(force.feature());
    if (frame.isEmpty()) {
      incomplete(node, "this force needs a feature");
      return;
    }
    lines.begin(node);
    lines.line("sleep(0.02)");
    lines.line("zero_ftsensor()");
    lines.line(
        "force_mode("
            + frame.get()
            + ", "
            + flags(force.kind() == ForceKind.SIMPLE ? ALONG_Z : force.compliant())
            + ", "
            + ScriptText.list(force.wrench())
            + ", "
            + type(force.kind())
            + ", "
            + ScriptText.list(force.limits())
            + ")");
    steps.writeAll(node.children());
    lines.line("end_force_mode()");
    lines.line(stop(STOP_M_PER_S2));
    lines.end();
  }

  private static String flags(List<Boolean> compliant) {
    return compliant.stream().map(each -> each ? 1 : 0).toList().toString();
  }

  private static int type(ForceKind kind) {
    return switch (kind) {
      case POINT -> 1;
      case SIMPLE, FRAME -> 2;
      case MOTION -> 3;
    };
  }

  private static String stop(double decelerationMPerS2) {
    return "stopl(" + ScriptText.number(decelerationMPerS2) + ")";
  }

  void write(ProgramNode node, TemplateStep.Screwdriving screw) {
    lines.begin(node);
    steps.motion().tool().use(screw.tool());
    lines.line("zero_ftsensor()");
    lines.line("sleep(0.02)");
    driver(screw, true);
    double force = screw.byForce() ? screw.value() : SCREW_FORCE_N;
    lines.line(
        "screw_driving("
            + ScriptText.number(screw.loosen() ? -force : force)
            + ", "
            + ScriptText.number(screw.byForce() ? SCREW_SPEED_M_PER_S : screw.value())
            + ")");
    boolean watched = !screw.until().isBlank() || screw.timeoutS() > 0;
    if (watched) {
      watch(node, screw);
    } else {
      steps.writeAll(node.children());
      ended(screw);
    }
    lines.end();
  }

  private void driver(TemplateStep.Screwdriving screw, boolean on) {
    signals.write(screw.start(), ScriptText.bool(on)).ifPresent(lines::line);
  }

  private void ended(TemplateStep.Screwdriving screw) {
    lines.line("end_screw_driving()");
    driver(screw, false);
    lines.line(stop(STOP_M_PER_S2));
  }

  /** The children run in a thread, while the program waits for the end or for too long a time. */
  private void watch(ProgramNode node, TemplateStep.Screwdriving screw) {
    String time = context.names().numbered("screw_time");
    String late = context.names().numbered("screw_late");
    WatchedMove watched = new WatchedMove(context, node);
    watched.startNodes(
        () -> {
          steps.writeAll(node.children());
        });
    lines.line("global " + time + " = 0.0");
    lines.line("global " + late + " = False");
    watched.watch();
    watched.when(screw.until().isBlank() ? watched.done() : ScriptText.condition(screw.until()));
    watched.leave();
    if (screw.timeoutS() > 0) {
      watched.when("(" + time + " >= " + ScriptText.number(screw.timeoutS()) + ")");
      lines.line(late + " = True");
      watched.leave();
    }
    lines.line(time + " = " + time + " + get_steptime()");
    watched.close();
    watched.kill();
    ended(screw);
    lines.open("if (" + late + "):");
    lines.line(
        "popup(\"The screw was not done within "
            + ScriptText.number(screw.timeoutS())
            + " s\", \"Screwdriving\", False, True, blocking=False)");
    lines.line("halt");
    lines.close();
  }

  void write(ProgramNode node, TemplateStep.ConveyorTracking tracking) {
    Optional<ConveyorSetup> setup =
        context.installation().conveyors().stream()
            .filter(each -> each.number() == tracking.conveyor())
            .findFirst();
    Optional<String> start = setup.flatMap(this::start);
    if (start.isEmpty()) {
      incomplete(node, "the installation has no such conveyor");
      return;
    }
    lines.begin(node);
    lines.line(start.get());
    steps.writeAll(node.children());
    lines.line("stop_conveyor_tracking()");
    lines.end();
  }

  private Optional<String> start(ConveyorSetup conveyor) {
    String ticks = ScriptText.number(conveyor.ticksPerUnit());
    if (conveyor.circular()) {
      return steps
          .motion()
          .frame(conveyor.feature())
          .map(
              center ->
                  "track_conveyor_circular("
                      + center
                      + ", "
                      + ticks
                      + ", "
                      + ScriptText.bool(conveyor.rotateTool())
                      + ", "
                      + conveyor.encoder()
                      + ")");
    }
    return steps
        .motion()
        .directions()
        .vector(conveyor.feature(), 0, 1, 0)
        .map(
            along ->
                "track_conveyor_linear(" + along + ", " + ticks + ", " + conveyor.encoder() + ")");
  }

  private void incomplete(ProgramNode node, String text) {
    lines.begin(node, ScriptLines.NO_BREAK);
    lines.line("# " + text);
    lines.end();
  }
}
