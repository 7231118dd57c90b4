package org.pendant.controller.device.gripper;

import static org.pendant.controller.device.gripper.GripperTexts.text;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.pendant.controller.world.GripperSetup;
import org.pendant.script.value.FloatValue;
import org.pendant.script.value.IntValue;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

/**
 * Grip procedures: a gripper that programs work by remote procedures, as the server of the maker's
 * tools on a real controller has them at port {@value #PORT}. Widths are in mm there, the first
 * argument is the place of the tool, 0.
 */
public final class GripProcedures {
  /** The port of the server on a robot's controller. */
  public static final int PORT = 41414;

  private static final double MM = 1e-3;
  private static final double PERCENT = 1e-2;

  /** Between the outer sides of the fingers it is so much more than between the inner ones, m. */
  private static final double INNER_M = 2 * GripperSetup.FINGER_M;

  /** What is answered for a tool that is not there. */
  private static final double NO_WIDTH = -999;

  /**
   * A make of gripper.
   *
   * @param prefix with which the names of its procedures begin
   * @param strokeM how far it opens
   * @param minForceN the least force
   * @param maxForceN the greatest force
   * @param speedMPerS how fast the fingers are at most
   */
  public record Make(
      String prefix, double strokeM, double minForceN, double maxForceN, double speedMPerS) {
    /** With long fingers that turn. */
    public static final Make RG = new Make("rg_", 0.110, 3, 40, 0.110);

    /** With parallel fingers. */
    public static final Make TWO_FG = new Make("twofg_", 0.039, 20, 140, 0.450);
  }

  private final Make make;
  private final String name;
  private final Consumer<String> tell;
  private final Fingers fingers;
  private boolean gripped;

  /**
   * An open gripper.
   *
   * @param name its own, for what it tells
   * @param tell is told what a user wants to know
   */
  public GripProcedures(String name, Make make, Consumer<String> tell) {
    this.make = make;
    this.name = name;
    this.tell = tell;
    fingers = new Fingers(make.strokeM());
  }

  /** Its fingers. */
  public Fingers fingers() {
    return fingers;
  }

  /** Whether it holds a part. */
  public boolean gripped() {
    return gripped;
  }

  /**
   * Answers a call; empty where it has no such procedure.
   *
   * @throws ScriptError where it is called wrongly
   */
  public Optional<Value> call(String method, List<Value> arguments) throws ScriptError {
    if (!method.startsWith(make.prefix())) {
      return Optional.empty();
    }
    String what = method.substring(make.prefix().length());
    boolean there = number(method, arguments, 0) == 0;
    return switch (what) {
      case "grip", "grip_external" ->
          Optional.of(Value.of(there ? grip(method, arguments, 0) : -1));
      case "grip_internal" -> Optional.of(Value.of(there ? grip(method, arguments, INNER_M) : -1));
      case "stop" -> {
        if (there) {
          fingers.stop();
        }
        yield Optional.of(Value.of(there ? 0 : -1));
      }
      case "get_width", "get_external_width" ->
          Optional.of(Value.of(there ? fingers.openingM() / MM : NO_WIDTH));
      case "get_internal_width" ->
          Optional.of(Value.of(there ? (fingers.openingM() + INNER_M) / MM : NO_WIDTH));
      case "get_min_external_width" -> Optional.of(Value.of(0.0));
      case "get_max_external_width" -> Optional.of(Value.of(make.strokeM() / MM));
      case "get_busy" -> Optional.of(Value.of(there && busy()));
      case "get_grip_detected", "grip_detected" -> Optional.of(Value.of(there && gripped));
      case "get_status" -> Optional.of(Value.of(there ? status() : -1));
      case "get_safety_failed", "get_s1_pushed", "get_s2_pushed" -> Optional.of(Value.of(false));
      default -> Optional.empty();
    };
  }

  private int status() {
    return (busy() ? 1 : 0) + (gripped ? 2 : 0);
  }

  private boolean busy() {
    return fingers.direction() != 0 && !gripped;
  }

  /**
   * Goes to a width.
   *
   * @param innerM how much more the width counts than the fingers are open
   */
  private int grip(String method, List<Value> arguments, double innerM) throws ScriptError {
    double widthMm = number(method, arguments, 1);
    double forceN = number(method, arguments, 2);
    double share = arguments.size() > 3 ? PERCENT * number(method, arguments, 3) : 1;
    fingers.drive(
        MM * widthMm - innerM,
        make.speedMPerS() * Math.clamp(share, 0.1, 1),
        Math.clamp(forceN, make.minForceN(), make.maxForceN()));
    gripped = gripped && fingers.pressing();
    return 0;
  }

  private static double number(String method, List<Value> arguments, int index) throws ScriptError {
    if (index >= arguments.size()) {
      throw new ScriptError("rpc-arguments", text("tooFewArguments", arguments.size(), method));
    }
    return switch (arguments.get(index)) {
      case IntValue whole -> whole.value();
      case FloatValue number when Double.isFinite(number.value()) -> number.value();
      default ->
          throw new ScriptError(
              "rpc-arguments", text("argumentNoNumber", index + 1, arguments.get(index).text()));
    };
  }

  /** Moves it through one frame. */
  public void step() {
    fingers.step();
    boolean now = fingers.pressing() && (gripped || fingers.pressedS() >= AdaptiveGripper.SETTLE_S);
    if (now != gripped) {
      gripped = now;
      tell.accept(gripped ? AdaptiveGripper.gripping(name, fingers) : text("partLetGo", name));
    }
  }
}
