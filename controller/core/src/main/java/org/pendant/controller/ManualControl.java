package org.pendant.controller;

import static org.pendant.controller.ControllerTexts.text;

import java.util.Optional;
import java.util.function.Supplier;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.box.Inertia;
import org.pendant.controller.box.ToolCentre;
import org.pendant.controller.command.CommandHandler;
import org.pendant.controller.command.Refusal;
import org.pendant.controller.command.Refusal.Code;
import org.pendant.controller.command.Reply;
import org.pendant.controller.freedrive.FreeAxes;
import org.pendant.controller.freedrive.FreedriveFrame;
import org.pendant.controller.jog.JogMove;
import org.pendant.controller.jog.Jogging;
import org.pendant.controller.world.Vector3;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.pose.Pose;
import org.pendant.script.value.Value;
import org.pendant.script.vm.Machine;

/**
 * Manual control: jogging, freedrive and other commands of an operator; refused while a program has
 * the arm.
 */
final class ManualControl implements CommandHandler<ManualCommand> {
  /** Farthest TCP and centre of gravity along each axis of the flange, m. */
  private static final double MAX_M = 4;

  /** How often the rated payload may be declared; beyond, it likely means grams. */
  private static final double MAX_RATED_PAYLOADS = 4;

  private final ControlBox box;
  private final Machine machine;
  private final Jogging jogging;
  private final FreedriveSession guiding;

  /** Made once, since every frame hands it on. */
  private final Supplier<Optional<Refusal>> unlessProgram = this::refusalOfInput;

  ManualControl(ControlBox box, Machine machine) {
    this.box = box;
    this.machine = machine;
    jogging = new Jogging(box);
    guiding = new FreedriveSession(box);
  }

  @Override
  public Class<ManualCommand> family() {
    return ManualCommand.class;
  }

  @Override
  public Reply carryOut(ManualCommand command) {
    return switch (command) {
      case ManualCommand.Jog(JogMove move, double speedFraction) ->
          Reply.unless(jog(move, speedFraction));
      case ManualCommand.StopJog _ -> {
        jogging.release();
        yield Reply.done();
      }
      case ManualCommand.StartFreedrive(FreeAxes axes, FreedriveFrame frame) ->
          Reply.unless(guide(axes, frame));
      case ManualCommand.EndFreedrive _ -> {
        guiding.release();
        yield Reply.done();
      }
      case ManualCommand.SetTool(ToolCentre tool) -> Reply.unless(setTool(tool));
      case ManualCommand.DeclarePayload declare ->
          Reply.unless(
              declarePayload(declare.massKg(), declare.cogInFlangeM(), declare.inertiaKgM2()));
    };
  }

  /** Looks at how a move by hand goes; after the step of the motion. */
  void step() {
    jogging.step();
    guiding.step();
    guiding.followInput(
        box.signals().freedriveDemanded() || box.links().modbus().freedriveDemanded(),
        unlessProgram);
  }

  private Optional<Refusal> refusalOfInput() {
    return programRefusal("inputAsksFreedrive");
  }

  private Optional<Refusal> guide(FreeAxes axes, FreedriveFrame frame) {
    Optional<Refusal> refusal = programRefusal("armIsGuided");
    if (refusal.isEmpty()) {
      jogging.giveUp();
      refusal = guiding.hold(axes, frame);
    }
    return refusal;
  }

  private Optional<Refusal> jog(JogMove move, double speedFraction) {
    Optional<Refusal> refusal = programRefusal("armIsJogged");
    return refusal.isPresent() ? refusal : jogging.hold(move, speedFraction);
  }

  /** A program takes the arm over. */
  void giveUp() {
    jogging.giveUp();
    guiding.release();
  }

  private Optional<Refusal> setTool(ToolCentre tool) {
    Optional<Refusal> refusal = settingRefusal("tcpIsChanged");
    if (refusal.isEmpty()) {
      Pose p = tool.inFlange();
      refusal = distanceRefusal("tcp", p.x(), p.y(), p.z());
    }
    if (refusal.isEmpty() && !Double.isFinite(angleRad(tool.inFlange()))) {
      refusal = invalid(text("tcpRotation", tool.inFlange()));
    }
    if (refusal.isEmpty()) {
      box.flange().setTool(tool);
    }
    return refusal;
  }

  private static double angleRad(Pose p) {
    return new Vector3(p.rx(), p.ry(), p.rz()).length();
  }

  private Optional<Refusal> declarePayload(double massKg, Vector3 cogM, Optional<Inertia> inertia) {
    Optional<Refusal> refusal = settingRefusal("payloadIsChanged");
    if (refusal.isEmpty()) {
      refusal = massRefusal(massKg);
    }
    if (refusal.isEmpty()) {
      refusal = distanceRefusal("centreOfGravity", cogM.x(), cogM.y(), cogM.z());
    }
    if (refusal.isEmpty()) {
      refusal =
          inertia.flatMap(Inertia::problem).flatMap(why -> invalid(text("inertiaRefused", why)));
    }
    if (refusal.isEmpty()) {
      Inertia i = inertia.orElse(Inertia.NONE);
      box.flange()
          .declarePayload(
              new Payload(
                  massKg, cogM.x(), cogM.y(), cogM.z(), i.ixx(), i.iyy(), i.izz(), i.ixy(), i.ixz(),
                  i.iyz()),
              0);
    }
    return refusal;
  }

  private Optional<Refusal> massRefusal(double massKg) {
    ArmDescription arm = box.arm().description();
    double most = MAX_RATED_PAYLOADS * arm.payloadKg();
    return massKg >= 0 && massKg <= most
        ? Optional.empty()
        : invalid(text("massRange", number(massKg), number(most), arm.displayName()));
  }

  private static Optional<Refusal> distanceRefusal(String what, double x, double y, double z) {
    boolean near = Math.abs(x) <= MAX_M && Math.abs(y) <= MAX_M && Math.abs(z) <= MAX_M;
    return near
        ? Optional.empty()
        : invalid(
            text(
                "placeRange",
                text(what),
                number(x),
                number(y),
                number(z),
                number(MAX_M),
                number(MAX_M)));
  }

  /**
   * Why nothing about the arm can be set up anew now; empty if it can.
   *
   * @param what key of the text that says what is to be done
   */
  Optional<Refusal> settingRefusal(String what) {
    Optional<Refusal> refusal = programRefusal(what);
    return refusal.isEmpty() && box.motion().moving()
        ? Optional.of(new Refusal(Code.ARM_MOVES, text("armMoves", text(what))))
        : refusal;
  }

  private Optional<Refusal> programRefusal(String what) {
    return switch (machine.state()) {
      case STOPPED -> Optional.empty();
      case RUNNING -> programHasArm(text("programRuns", machine.programName(), text(what)));
      case PAUSED -> programHasArm(text("programPaused", machine.programName(), text(what)));
    };
  }

  private static Optional<Refusal> programHasArm(String text) {
    return Optional.of(new Refusal(Code.PROGRAM, text));
  }

  private static Optional<Refusal> invalid(String text) {
    return Optional.of(new Refusal(Code.INVALID, text));
  }

  private static String number(double number) {
    return Value.of(number).text();
  }
}
