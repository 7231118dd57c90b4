package org.pendant.controller.builtin;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.box.Inertia;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.kinematics.InverseKinematics;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Wrench;
import org.pendant.script.function.Call;
import org.pendant.script.value.ListValue;
import org.pendant.script.value.MatrixValue;
import org.pendant.script.value.PoseValue;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;
import org.pendant.script.value.ValueKind;

/** Payload arguments: checks of what programs declare about payloads. */
final class PayloadArguments {
  /** How often the rated payload a program may declare; beyond, it likely means grams. */
  private static final double MAX_RATED_PAYLOADS = 4;

  /** Farthest centre of gravity along each axis of the flange, m. */
  private static final double MAX_COG_M = 4;

  private PayloadArguments() {}

  /**
   * A mass that the arm can be thought to hold; one beyond its rated payload is worth a warning.
   */
  static double massKg(Call<ControlBox> call, int index) throws ScriptError {
    double massKg = call.number(index);
    ArmDescription arm = call.host().arm().description();
    double most = MAX_RATED_PAYLOADS * arm.payloadKg();
    if (!(massKg >= 0 && massKg <= most)) {
      throw call.refuse(
          index, BuiltinTexts.text("mass", text(most), text(MAX_RATED_PAYLOADS), arm.id()));
    }
    if (massKg > arm.payloadKg()) {
      call.host()
          .log()
          .warnOnce(
              BuiltinTexts.text(
                  "payloadAboveRating", text(massKg), arm.id(), text(arm.payloadKg())));
    }
    return massKg;
  }

  /** A centre of gravity in the flange frame, m. */
  static double[] cogM(Call<ControlBox> call, int index) throws ScriptError {
    return MotionArguments.bounded(call, index, 3, MAX_COG_M, "eachM");
  }

  /** An inertia [Ixx, Iyy, Izz, Ixy, Ixz, Iyz] that a body can have, kg m². */
  static double[] inertiaKgM2(Call<ControlBox> call, int index) throws ScriptError {
    double[] elements = MotionArguments.bounded(call, index, 6, Inertia.MAX_KG_M2, "eachKgM2");
    Optional<String> problem = Inertia.of(elements).problem();
    if (problem.isPresent()) {
      throw call.refuse(index, problem.get());
    }
    return elements;
  }

  /** Poses of the flange, from a list of poses of the active TCP. */
  static List<Pose> flangesInBase(Call<ControlBox> call, int index) throws ScriptError {
    Pose tcpInFlange = call.host().flange().tool().inFlange();
    List<Pose> flanges = new ArrayList<>();
    for (Pose tcpInBase : poses(call, index)) {
      flanges.add(InverseKinematics.flangeOf(tcpInBase, tcpInFlange));
    }
    return flanges;
  }

  /** Wrenches, from a list of such poses as get_tcp_force answers, or from one of lists. */
  static List<Wrench> wrenches(Call<ControlBox> call, int index) throws ScriptError {
    List<Wrench> wrenches = new ArrayList<>();
    if (call.value(index) instanceof MatrixValue rows) {
      if (rows.columns() != 6) {
        throw call.refuse(index, BuiltinTexts.text("wrenches"));
      }
      for (int row = 0; row < rows.rows(); row++) {
        wrenches.add(wrench(call, index, rows, row));
      }
      return wrenches;
    }
    for (Pose p : poses(call, index)) {
      wrenches.add(new Wrench(p.x(), p.y(), p.z(), p.rx(), p.ry(), p.rz()));
    }
    return wrenches;
  }

  private static Wrench wrench(Call<ControlBox> call, int index, MatrixValue rows, int row)
      throws ScriptError {
    double[] elements = new double[rows.columns()];
    for (int i = 0; i < elements.length; i++) {
      elements[i] = rows.numberAt(row, i);
      if (!Double.isFinite(elements[i])) {
        throw call.refuse(index, BuiltinTexts.text("finite"));
      }
    }
    return new Wrench(elements[0], elements[1], elements[2], elements[3], elements[4], elements[5]);
  }

  private static List<Pose> poses(Call<ControlBox> call, int index) throws ScriptError {
    ListValue list = call.list(index);
    if (list.length() > 0 && list.elementKind() != ValueKind.POSE) {
      throw call.wrongKind(index, BuiltinTexts.text("poses"));
    }
    List<Pose> poses = new ArrayList<>();
    for (int i = 0; i < list.length(); i++) {
      if (list.get(i) instanceof PoseValue element) {
        poses.add(MotionArguments.finite(call, index, element.pose()));
      }
    }
    return poses;
  }

  private static String text(double number) {
    return Value.of(number).text();
  }
}
