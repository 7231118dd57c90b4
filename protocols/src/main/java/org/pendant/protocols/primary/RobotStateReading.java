package org.pendant.protocols.primary;

import static org.pendant.protocols.primary.PrimaryTexts.text;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.pendant.controller.safety.RobotMode;
import org.pendant.controller.safety.SafetyMode;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.protocols.wire.Reading;

/** Robot state reading: what {@link RobotStateCodec} has written, for people. */
final class RobotStateReading {
  private static final List<String> PARTS =
      List.of(
          "robot_mode_data",
          "joint_data",
          "tool_data",
          "masterboard_data",
          "cartesian_info",
          "kinematics_info",
          "configuration_data",
          "force_mode_data",
          "additional_info",
          "calibration_data",
          "safety_data",
          "tool_communication_info",
          "tool_mode_info");

  private static final int ROBOT_MODE_DATA = 0;
  private static final int JOINT_DATA = 1;
  private static final int MASTERBOARD_DATA = 3;
  private static final int CARTESIAN_INFO = 4;
  private static final int PART_HEADER = 5;
  private static final int MODE_AT = 15;

  private RobotStateReading() {}

  /**
   * Reads a state.
   *
   * @param body what stands behind size and type
   */
  static Reading of(ByteBuffer body) {
    Map<Integer, ByteBuffer> parts = parts(body);
    return Reading.of("robot-state", summary(parts), () -> fields(parts));
  }

  private static String summary(Map<Integer, ByteBuffer> parts) {
    ByteBuffer mode = parts.get(ROBOT_MODE_DATA);
    if (mode == null) {
      return text("parts", parts.size());
    }
    String program =
        mode.get(13) == 0 ? "withoutProgram" : mode.get(14) == 0 ? "playing" : "paused";
    return text(program, robotMode(mode.get(MODE_AT)), parts.size());
  }

  private static Map<Integer, ByteBuffer> parts(ByteBuffer body) {
    Map<Integer, ByteBuffer> parts = new LinkedHashMap<>();
    while (body.remaining() >= PART_HEADER) {
      int size = body.getInt(body.position());
      int type = body.get(body.position() + Integer.BYTES);
      parts.put(type, body.slice(body.position() + PART_HEADER, size - PART_HEADER));
      body.position(body.position() + size);
    }
    return parts;
  }

  private static String robotMode(int code) {
    return Arrays.stream(RobotMode.values())
        .filter(each -> each.code() == code)
        .findFirst()
        .map(RobotMode::name)
        .orElse(text("robotMode", code));
  }

  /** The name of a safety mode. */
  static String safetyMode(int code) {
    return Arrays.stream(SafetyMode.values())
        .filter(each -> each.code() == code)
        .findFirst()
        .map(SafetyMode::name)
        .orElse("" + code);
  }

  private static Map<String, Object> fields(Map<Integer, ByteBuffer> parts) {
    Map<String, Object> fields = new LinkedHashMap<>();
    parts.forEach(
        (type, part) -> {
          String name = type >= 0 && type < PARTS.size() ? PARTS.get(type) : "part_" + type;
          ByteBuffer in = part.duplicate();
          fields.put(
              name,
              switch (type) {
                case ROBOT_MODE_DATA -> modes(in);
                case JOINT_DATA -> joints(in);
                case MASTERBOARD_DATA -> masterboard(in);
                case CARTESIAN_INFO -> cartesian(in);
                default -> Map.of("bytes", in.remaining());
              });
        });
    return fields;
  }

  private static Map<String, Object> modes(ByteBuffer in) {
    Map<String, Object> modes = new LinkedHashMap<>();
    modes.put("time_us", in.getLong());
    for (String name :
        List.of(
            "robot_connected",
            "robot_enabled",
            "power_on",
            "emergency_stopped",
            "protective_stopped",
            "program_running",
            "program_paused")) {
      modes.put(name, in.get() != 0);
    }
    modes.put("robot_mode", (int) in.get());
    modes.put("control_mode", (int) in.get());
    modes.put("speed_slider", in.getDouble());
    modes.put("speed_scaling", in.getDouble());
    return modes;
  }

  private static Map<String, Object> joints(ByteBuffer in) {
    Map<String, List<Object>> joints = new LinkedHashMap<>();
    for (int i = 0; i < Joints.COUNT; i++) {
      for (String name : List.of("actual_q", "target_q", "actual_qd")) {
        joints.computeIfAbsent(name, absent -> new ArrayList<>()).add(in.getDouble());
      }
      for (String name : List.of("current", "voltage", "temperature", "unused")) {
        joints.computeIfAbsent(name, absent -> new ArrayList<>()).add((double) in.getFloat());
      }
      joints.computeIfAbsent("mode", absent -> new ArrayList<>()).add(in.get() & 0xFF);
    }
    joints.remove("unused");
    return new LinkedHashMap<>(joints);
  }

  private static Map<String, Object> masterboard(ByteBuffer in) {
    Map<String, Object> bits = new LinkedHashMap<>();
    bits.put("digital_input_bits", in.getInt());
    bits.put("digital_output_bits", in.getInt());
    return bits;
  }

  private static Map<String, Object> cartesian(ByteBuffer in) {
    Map<String, Object> poses = new LinkedHashMap<>();
    for (String name : List.of("actual_tcp", "tcp_offset")) {
      List<Double> numbers = new ArrayList<>();
      for (int i = 0; i < Pose.SIZE; i++) {
        numbers.add(in.getDouble());
      }
      poses.put(name, numbers);
    }
    return poses;
  }
}
