package org.pendant.command.rpc;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.box.ArmChoice;
import org.pendant.controller.box.CellEquipment;
import org.pendant.controller.box.EquipmentReader;
import org.pendant.controller.io.InputWaveforms;
import org.pendant.models.json.JsonException;
import org.pendant.protocols.egress.AllowedHosts;

/** Lines that a server is sent, and those that it answers. */
final class Lines implements RpcServer.Output {
  /** What a server is asked first. */
  static final String CREATE = "robot.create";

  private final List<String> answers = new ArrayList<>();
  private final List<Throwable> faults = new ArrayList<>();

  /** What a server answers to requests. */
  static List<String> answers(String... requests) {
    return new Lines()
        .sent(
            new ByteArrayInputStream(String.join("\n", requests).getBytes(StandardCharsets.UTF_8)));
  }

  /** The last of these answers. */
  static String last(String... requests) {
    return answers(requests).getLast();
  }

  /** What a server answers to bytes. */
  List<String> sent(InputStream bytes) {
    try {
      new RpcServer(Lines::ideal, "Pendant", this, faults::add).serve(bytes);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    if (!faults.isEmpty()) {
      throw new AssertionError(faults.getFirst());
    }
    return answers;
  }

  /** A request with the id 1. */
  static String request(String method, String... members) {
    return "{\"jsonrpc\":\"2.0\",\"id\":1,\"method\":\""
        + method
        + "\",\"params\":{"
        + String.join(",", members).replace('\'', '"')
        + "}}";
  }

  /** The request that loads a program. */
  static String load(String text) {
    return request("program.load", "'text':'" + text.replace("\n", "\\n") + "'");
  }

  private static RobotSource.NewRobot ideal(List<String> words) throws RpcFailure {
    boolean gripper = words.equals(List.of("--device=two-finger"));
    if (!words.isEmpty() && !gripper) {
      throw RpcFailure.params("unknown option " + words.getFirst());
    }
    ControllerOptions options = ControllerOptions.headless().withArm(ArmChoice.IDEAL);
    return new RobotSource.NewRobot(
        gripper ? options.withEquipment(gripper()) : options,
        InputWaveforms.NONE,
        AllowedHosts.parse("none"),
        file -> {
          throw new RpcFailure(RpcFailure.UNREADABLE, file + ": there is no such file");
        });
  }

  private static CellEquipment gripper() throws RpcFailure {
    try {
      return EquipmentReader.read(
          "cell",
          new ByteArrayInputStream(
              """
              {"devices": [
                {"type": "two-finger"},
                {"type": "modbus", "name": "plc", "address": "192.168.0.20"}
              ]}
              """
                  .getBytes(StandardCharsets.UTF_8)));
    } catch (JsonException e) {
      throw RpcFailure.params(e.getMessage());
    }
  }

  @Override
  public void line(String ascii) {
    answers.add(ascii);
  }

  @Override
  public boolean closed() {
    return false;
  }

  /** The text between two others. */
  static Optional<String> between(String text, String before, String after) {
    int start = text.indexOf(before);
    return start < 0
        ? Optional.empty()
        : Optional.of(
            text.substring(start + before.length(), text.indexOf(after, start + before.length())));
  }
}
