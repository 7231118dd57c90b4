package org.pendant.controller;

import java.util.Optional;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.box.Inertia;
import org.pendant.controller.box.ToolCentre;
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
final class ManualControl {
  /** Farthest TCP and centre of gravity along each axis of the flange, m. */
  private static final double MAX_M = 4;

  /** How often the rated payload may be declared; beyond, it likely means grams. */
  private static final double MAX_RATED_PAYLOADS = 4;

  private final ControlBox box;
  private final Machine machine;
  private final Jogging jogging;
  private final FreedriveSession guiding;

  ManualControl(ControlBox box, Machine machine) {
    this.box = box;
    this.machine = machine;
    jogging = new Jogging(box);
    guiding = new FreedriveSession(box);
  }

  /** Looks at how a move by hand goes; after the step of the motion. */
  void step() {
    jogging.step();
    guiding.step();
    guiding.followInput(
        box.signals().freedriveDemanded() || box.links().modbus().freedriveDemanded(),
        () -> programRefusal("an input asks for freedrive"));
  }

  Optional<String> guide(FreeAxes axes, FreedriveFrame frame) {
    Optional<String> refusal = programRefusal("the arm is guided by hand");
    if (refusal.isEmpty()) {
      jogging.giveUp();
      refusal = guiding.hold(axes, frame);
    }
    return refusal;
  }

  /** Ends {@link #guide}: the arm holds where it is. */
  void endGuiding() {
    guiding.release();
  }

  /** Each of these answers why not, empty if it is done. */
  Optional<String> jog(JogMove move, double speedFraction) {
    Optional<String> refusal = programRefusal("the arm is moved by hand");
    return refusal.isPresent() ? refusal : jogging.hold(move, speedFraction);
  }

  void stop() {
    jogging.release();
  }

  /** A program takes the arm over. */
  void giveUp() {
    jogging.giveUp();
    guiding.release();
  }

  Optional<String> setTool(ToolCentre tool) {
    Optional<String> refusal = settingRefusal("the TCP is changed");
    if (refusal.isEmpty()) {
      Pose p = tool.inFlange();
      refusal = distanceRefusal("the TCP", p.x(), p.y(), p.z());
    }
    if (refusal.isEmpty() && !Double.isFinite(angleRad(tool.inFlange()))) {
      refusal = Optional.of("the rotation of the TCP is " + tool.inFlange() + ", must be finite");
    }
    if (refusal.isEmpty()) {
      box.flange().setTool(tool);
    }
    return refusal;
  }

  private static double angleRad(Pose p) {
    return new Vector3(p.rx(), p.ry(), p.rz()).length();
  }

  Optional<String> declarePayload(double massKg, Vector3 cogM, Optional<Inertia> inertia) {
    Optional<String> refusal = settingRefusal("the payload is changed");
    if (refusal.isEmpty()) {
      refusal = massRefusal(massKg);
    }
    if (refusal.isEmpty()) {
      refusal = distanceRefusal("the centre of gravity", cogM.x(), cogM.y(), cogM.z());
    }
    if (refusal.isEmpty()) {
      refusal = inertia.flatMap(Inertia::problem).map(why -> "the inertia is refused: " + why);
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

  private Optional<String> massRefusal(double massKg) {
    ArmDescription arm = box.armDescription();
    double most = MAX_RATED_PAYLOADS * arm.payloadKg();
    return massKg >= 0 && massKg <= most
        ? Optional.empty()
        : Optional.of(
            "the mass is "
                + text(massKg)
                + " kg, must be 0 to "
                + text(most)
                + " kg on "
                + arm.id());
  }

  private static Optional<String> distanceRefusal(String what, double x, double y, double z) {
    boolean near = Math.abs(x) <= MAX_M && Math.abs(y) <= MAX_M && Math.abs(z) <= MAX_M;
    return near
        ? Optional.empty()
        : Optional.of(
            what
                + " is at ["
                + text(x)
                + ", "
                + text(y)
                + ", "
                + text(z)
                + "] m, each must be -"
                + text(MAX_M)
                + " to "
                + text(MAX_M)
                + " m");
  }

  /** Why nothing about the arm can be set up anew now; empty if it can. */
  Optional<String> settingRefusal(String what) {
    Optional<String> refusal = programRefusal(what);
    return refusal.isEmpty() && box.motion().moving()
        ? Optional.of("the arm is moving, must be at rest when " + what)
        : refusal;
  }

  private Optional<String> programRefusal(String what) {
    return switch (machine.state()) {
      case STOPPED -> Optional.empty();
      case RUNNING ->
          Optional.of("program " + machine.programName() + " runs, stop it before " + what);
      case PAUSED ->
          Optional.of("program " + machine.programName() + " is paused, stop it before " + what);
    };
  }

  private static String text(double number) {
    return Value.of(number).text();
  }
}
