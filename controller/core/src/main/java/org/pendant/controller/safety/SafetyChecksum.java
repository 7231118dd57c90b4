package org.pendant.controller.safety;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.zip.CRC32;
import org.pendant.models.arm.Joints;

/**
 * Safety checksum: a short number that tells safety configurations apart: equal ones have the same,
 * others nearly always another one. It is no protection against deliberate deception.
 *
 * @param value 32 bits
 */
public record SafetyChecksum(int value) {
  /** The checksum of a configuration. */
  public static SafetyChecksum of(SafetyConfiguration safety) {
    Sum sum = new Sum();
    sum.add(safety.normal());
    sum.add(safety.reduced());
    sum.add(safety.planes().size());
    for (SafetyPlane each : safety.planes()) {
      sum.add(each.name());
      sum.add(each.pointXM());
      sum.add(each.pointYM());
      sum.add(each.pointZM());
      sum.add(each.allowedSide());
      sum.add(each.applies().word());
      sum.add(each.elbow() ? 1 : 0);
    }
    if (safety.toolDirection().isPresent()) {
      ToolDirection direction = safety.toolDirection().get();
      sum.add(direction.allowedInBase());
      sum.add(direction.toolInFlange());
      sum.add(direction.largestAngleRad());
      sum.add(direction.applies().word());
    }
    return new SafetyChecksum((int) sum.crc.getValue());
  }

  /** Four groups of two hexadecimal digits, such as {@code 57-F4-28-5B}. */
  @Override
  public String toString() {
    String digits = String.format(Locale.ROOT, "%08X", value);
    return String.join(
        "-",
        digits.substring(0, 2),
        digits.substring(2, 4),
        digits.substring(4, 6),
        digits.substring(6));
  }

  /** Takes in one value after the other. */
  private static final class Sum {
    private final CRC32 crc = new CRC32();
    private final byte[] bytes = new byte[Double.BYTES];

    void add(double number) {
      // the two zeros mean the same
      ByteBuffer.wrap(bytes).putDouble(number + 0.0);
      crc.update(bytes);
    }

    void add(String text) {
      byte[] encoded = text.getBytes(StandardCharsets.UTF_8);
      add(encoded.length);
      crc.update(encoded);
    }

    void add(Axis axis) {
      add(axis.x());
      add(axis.y());
      add(axis.z());
    }

    void add(Joints joints) {
      for (int i = 0; i < Joints.COUNT; i++) {
        add(joints.get(i));
      }
    }

    void add(SafetyLimits limits) {
      add(limits.powerW());
      add(limits.momentumKgMPerS());
      add(limits.stoppingTimeS());
      add(limits.stoppingDistanceM());
      add(limits.toolSpeedMPerS());
      add(limits.toolForceN());
      add(limits.elbowSpeedMPerS());
      add(limits.elbowForceN());
      add(limits.jointSpeedRadPerS());
      add(limits.jointMinRad());
      add(limits.jointMaxRad());
    }
  }
}
