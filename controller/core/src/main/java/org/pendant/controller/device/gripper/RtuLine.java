package org.pendant.controller.device.gripper;

import java.util.function.BooleanSupplier;
import org.pendant.controller.external.DeviceTalk;

/**
 * RTU line: what an adaptive gripper is told by Modbus RTU on the serial line of the tool: three
 * registers to write at 0x03E8 and three to read at 0x07D0, as slave {@value #SLAVE}. A message
 * ends when nothing has followed it for a frame; one with a wrong checksum or for another slave is
 * not answered.
 */
public final class RtuLine implements DeviceTalk {
  /** The port by which programs reach the serial line of the tool. */
  public static final int PORT = 54321;

  private static final int SLAVE = 9;
  private static final int READ = 3;
  private static final int READ_INPUTS = 4;
  private static final int WRITE = 16;
  private static final int READ_AND_WRITE = 23;
  private static final int OUTPUTS = 0x03E8;
  private static final int INPUTS = 0x07D0;
  private static final int REGISTERS = 3;
  private static final int NO_FUNCTION = 1;
  private static final int NO_ADDRESS = 2;
  private static final int MAX_MESSAGE = 256;
  private static final int POLYNOMIAL = 0xA001;

  private final AdaptiveGripper gripper;
  private final BooleanSupplier on;
  private final StringBuilder message = new StringBuilder();

  /**
   * A connection to the line.
   *
   * @param on whether the line is on, and as the gripper wants it
   */
  public RtuLine(AdaptiveGripper gripper, BooleanSupplier on) {
    this.gripper = gripper;
    this.on = on;
  }

  @Override
  public String hear(String bytes) {
    if (bytes.isEmpty() && message.isEmpty()) {
      return "";
    }
    if (!on.getAsBoolean()) {
      message.setLength(0);
      return "";
    }
    message.append(bytes);
    if (!bytes.isEmpty() && message.length() <= MAX_MESSAGE) {
      return "";
    }
    String whole = message.toString();
    message.setLength(0);
    return answer(whole);
  }

  private String answer(String request) {
    int end = request.length() - 2;
    if (end < 2
        || request.charAt(0) != SLAVE
        || !checksum(request.substring(0, end)).equals(request.substring(end))) {
      return "";
    }
    String body = reply(request.charAt(1), request.substring(2, end));
    return body + checksum(body);
  }

  private String reply(int function, String data) {
    return switch (function) {
      case READ, READ_INPUTS ->
          data.length() == 4
              ? read(function, word(data, 0), word(data, 2))
              : no(function, NO_ADDRESS);
      case WRITE ->
          data.length() == 5 + 2 * REGISTERS && writes(data, 0)
              ? written(data)
              : no(function, NO_ADDRESS);
      case READ_AND_WRITE ->
          data.length() == 9 + 2 * REGISTERS && writes(data, 4)
              ? readAfter(data)
              : no(function, NO_ADDRESS);
      default -> no(function, NO_FUNCTION);
    };
  }

  private static String no(int function, int code) {
    return "" + (char) SLAVE + (char) (function | 0x80) + (char) code;
  }

  private static boolean writes(String data, int at) {
    return word(data, at) == OUTPUTS
        && word(data, at + 2) == REGISTERS
        && data.charAt(at + 4) == 2 * REGISTERS;
  }

  private String written(String data) {
    set(data.substring(5));
    return "" + (char) SLAVE + (char) WRITE + data.substring(0, 4);
  }

  private String readAfter(String data) {
    set(data.substring(9));
    return read(READ_AND_WRITE, word(data, 0), word(data, 2));
  }

  private String read(int function, int address, int count) {
    String values =
        switch (address) {
          case INPUTS, INPUTS + 1, INPUTS + 2 -> status();
          case OUTPUTS, OUTPUTS + 1, OUTPUTS + 2 -> outputs();
          default -> "";
        };
    int first = 2 * (address - (address >= INPUTS ? INPUTS : OUTPUTS));
    if (values.isEmpty() || count < 1 || first + 2 * count > values.length()) {
      return no(function, NO_ADDRESS);
    }
    return ""
        + (char) SLAVE
        + (char) function
        + (char) (2 * count)
        + values.substring(first, first + 2 * count);
  }

  private void set(String bytes) {
    int action = bytes.charAt(0);
    gripper.setSpeed(bytes.charAt(4));
    gripper.setForce(bytes.charAt(5));
    gripper.setReleaseOpens((action & 0x20) != 0);
    gripper.activate((action & 1) != 0);
    gripper.request(bytes.charAt(3));
    gripper.go((action & 8) != 0);
    if ((action & 0x10) != 0) {
      gripper.release();
    }
  }

  private String outputs() {
    int action =
        (gripper.active() ? 1 : 0)
            | (gripper.goes() ? 8 : 0)
            | (gripper.released() ? 0x10 : 0)
            | (gripper.releaseOpens() ? 0x20 : 0);
    return ""
        + (char) action
        + (char) 0
        + (char) 0
        + (char) gripper.requested()
        + (char) gripper.speed()
        + (char) gripper.force();
  }

  private String status() {
    int status =
        (gripper.active() ? 1 : 0)
            | (gripper.goes() ? 8 : 0)
            | gripper.status() << 4
            | gripper.contact().ordinal() << 6;
    return ""
        + (char) status
        + (char) 0
        + (char) gripper.fault().number()
        + (char) gripper.requested()
        + (char) gripper.position()
        + (char) (gripper.fingers().pressing() ? 30 : 0);
  }

  private static int word(String data, int at) {
    return data.charAt(at) << 8 | data.charAt(at + 1);
  }

  /** The checksum of Modbus RTU, its low byte first. */
  static String checksum(String bytes) {
    int sum = 0xFFFF;
    for (int i = 0; i < bytes.length(); i++) {
      sum ^= bytes.charAt(i);
      for (int bit = 0; bit < 8; bit++) {
        sum = (sum & 1) != 0 ? sum >> 1 ^ POLYNOMIAL : sum >> 1;
      }
    }
    return "" + (char) (sum & 0xFF) + (char) (sum >> 8);
  }
}
