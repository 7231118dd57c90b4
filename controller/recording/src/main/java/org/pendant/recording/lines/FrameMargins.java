package org.pendant.recording.lines;

import static org.pendant.recording.lines.LinesTexts.text;

import java.util.List;
import org.pendant.controller.safety.SafetyConfiguration;
import org.pendant.controller.safety.SafetyLimits;
import org.pendant.controller.safety.SafetyPlane;
import org.pendant.controller.state.ArmState;
import org.pendant.controller.state.ControllerState;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;
import org.pendant.models.time.FrameTime;

/**
 * Frame margins: how near the arm is to each of its limits in one frame, and how far its tool has
 * come in it. Positions and speeds are those of the target, torques those of the drives. Mutable,
 * for one thread, and allocates nothing after it was made; frames are shown in their order.
 */
public final class FrameMargins {
  private static final List<Margin> MARGIN_LIST = List.of(Margin.values());
  private static final int MARGINS = MARGIN_LIST.size();
  private static final int ELBOW = 1;
  private static final int FLANGE = Joints.COUNT - 1;

  private final ArmDescription arm;
  private final ForwardKinematics kinematics;
  private final SafetyConfiguration safety;
  private final double[] q = new double[Joints.COUNT];
  private final double[][] links = new double[Joints.COUNT][Transforms.SIZE];
  private final double[] tool = new double[3];
  private final double[] lastTool = new double[3];
  private final double[] values = new double[MARGINS];
  private final int[] parts = new int[MARGINS];
  private Pose tcpInFlange = Pose.ZERO;
  private long frame;
  private long frames = 1;
  private boolean seen;
  private double stepM;

  /** The margins of an arm to what it can do and to {@code safety}. */
  public FrameMargins(ArmState arm, SafetyConfiguration safety) {
    this.arm = arm.description();
    kinematics = arm.kinematics();
    this.safety = safety;
  }

  /** Looks at a frame. */
  public void look(ControllerState state) {
    ArmState now = state.arm();
    System.arraycopy(tool, 0, lastTool, 0, tool.length);
    // another tool is elsewhere without having moved there
    boolean follows = seen && now.tool().inFlange().equals(tcpInFlange);
    frames = state.frame() - frame;
    seen = true;
    frame = state.frame();
    tcpInFlange = now.tool().inFlange();
    now.targetPositionRad().copyTo(q);
    kinematics.frames(q, links);
    double[] flange = links[FLANGE];
    for (int row = 0; row < tool.length; row++) {
      tool[row] =
          flange[9 + row]
              + flange[3 * row] * tcpInFlange.x()
              + flange[3 * row + 1] * tcpInFlange.y()
              + flange[3 * row + 2] * tcpInFlange.z();
    }
    stepM = follows ? distance() : 0;
    for (Margin each : MARGIN_LIST) {
      values[each.index()] = each.farthest();
    }
    boolean reduced = state.safety().reduced();
    joints(state, reduced ? safety.reduced() : safety.normal());
    planes(reduced);
  }

  private double distance() {
    double x = tool[0] - lastTool[0];
    double y = tool[1] - lastTool[1];
    double z = tool[2] - lastTool[2];
    return Math.sqrt(x * x + y * y + z * z);
  }

  private void joints(ControllerState state, SafetyLimits limits) {
    for (int i = 0; i < Joints.COUNT; i++) {
      double speed = Math.abs(state.arm().targetSpeedRadPerS().get(i));
      note(Margin.JOINT_SPEED, speed / arm.joints().get(i).maxSpeedRadPerS(), i);
      double torque = Math.abs(state.readings().torqueNm().get(i));
      note(Margin.TORQUE, torque / arm.joints().get(i).maxTorqueNm(), i);
      note(Margin.JOINT_LIMIT, q[i] - limits.jointMinRad().get(i), i);
      note(Margin.JOINT_LIMIT, limits.jointMaxRad().get(i) - q[i], i);
    }
    note(Margin.TOOL_SPEED, toolSpeedMPerS() / limits.toolSpeedMPerS(), 0);
  }

  private void planes(boolean reduced) {
    List<SafetyPlane> planes = safety.planes();
    for (int i = 0; i < planes.size(); i++) {
      SafetyPlane plane = planes.get(i);
      boolean restricts =
          switch (plane.applies()) {
            case NORMAL -> !reduced;
            case REDUCED -> reduced;
            case BOTH -> true;
            case TRIGGERS_REDUCED -> false;
          };
      if (restricts) {
        note(Margin.PLANE, plane.insideM(tool[0], tool[1], tool[2]), 2 * i);
        if (plane.elbow()) {
          double[] elbow = links[ELBOW];
          note(Margin.PLANE, plane.insideM(elbow[9], elbow[10], elbow[11]), 2 * i + 1);
        }
      }
    }
  }

  private void note(Margin margin, double value, int part) {
    int at = margin.index();
    if (margin.nearer(value, values[at])) {
      values[at] = value;
      parts[at] = part;
    }
  }

  /** How near the arm is to a limit, in the unit of the margin; infinity where there is none. */
  public double value(Margin margin) {
    return values[margin.index()];
  }

  /**
   * Which part of the arm that is: 0 to 5 for a joint; for planes twice their number, and 1 more
   * for the elbow.
   */
  public int part(Margin margin) {
    return parts[margin.index()];
  }

  /** How far the tool has come since the frame before, m. */
  double stepM() {
    return stepM;
  }

  /** How fast the tool is, m/s: by its way since the frame before. */
  public double toolSpeedMPerS() {
    return stepM / (Math.max(1, frames) * FrameTime.FRAME_S);
  }

  /** What is nearest to a limit, for people. */
  public String part(Margin margin, int number) {
    return switch (margin) {
      case JOINT_SPEED, TORQUE, JOINT_LIMIT -> Worst.JOINTS.get(number);
      case TOOL_SPEED -> text("tool");
      case PLANE -> {
        String plane = safety.planes().get(number / 2).name();
        yield number % 2 == 1 ? text("elbowAtPlane", plane) : plane;
      }
    };
  }
}
