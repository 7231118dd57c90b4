package org.pendant.protocols.primary;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.state.ControllerState;
import org.pendant.protocols.wire.Direction;
import org.pendant.protocols.wire.Dissector;
import org.pendant.protocols.wire.Reading;

class PrimaryDissectorTest {
  private final Dissector dissector = new PrimaryDissector(true);

  private Reading out(byte[] message) {
    ByteBuffer bytes = ByteBuffer.wrap(message);
    assertEquals(message.length, dissector.length(Direction.OUT, bytes));
    return dissector.read(Direction.OUT, bytes);
  }

  private static ByteBuffer text(String text) {
    return ByteBuffer.wrap(text.getBytes(StandardCharsets.ISO_8859_1));
  }

  private Reading in(String text) {
    assertEquals(text.length(), dissector.length(Direction.IN, text(text)));
    return dissector.read(Direction.IN, text(text));
  }

  @Test
  void readsModesAndJointsOutOfAState() {
    ControllerState state = new Controller(ControllerOptions.headless()).state();
    Reading reading = out(new RobotStateCodec(state.arm().description()).full(state));
    assertTrue(reading.summary().startsWith(state.safety().robotMode().name()), reading.summary());
    Map<?, ?> joints = (Map<?, ?>) reading.fields().get().get("joint_data");
    assertEquals(6, ((List<?>) joints.get("actual_q")).size());
    Map<?, ?> cartesian = (Map<?, ?>) reading.fields().get().get("cartesian_info");
    assertEquals(6, ((List<?>) cartesian.get("actual_tcp")).size());
  }

  @Test
  void readsWhatTheBoxTells() {
    assertEquals(
        "hello", out(RobotMessageCodec.encode(new RobotMessage.Text(7, "hello"))).summary());
    assertEquals(
        "C153A2: stopped",
        out(RobotMessageCodec.encode(
                new RobotMessage.ErrorCode(7, 153, 2, RobotMessage.Level.VIOLATION, "stopped")))
            .summary());
    assertEquals(
        "PROGRAM_XXX_STARTED: p",
        out(RobotMessageCodec.encode(new RobotMessage.Key(7, "PROGRAM_XXX_STARTED", "p")))
            .summary());
    assertEquals(
        "safety mode PROTECTIVE_STOP",
        out(RobotMessageCodec.encode(new RobotMessage.Safety(7, 3))).summary());
    assertEquals(
        "3:4: wrong",
        out(RobotMessageCodec.encode(new RobotMessage.RuntimeFault(7, 3, 4, "wrong"))).summary());
    assertTrue(
        out(RobotMessageCodec.encode(new RobotMessage.Version()))
            .summary()
            .startsWith("URControl 5."));
  }

  @Test
  void takesAProgramToItsEndInTheFirstColumn() {
    String begun = "def p():\n  if True:\n  end\n";
    assertEquals(Dissector.MORE, dissector.length(Direction.IN, text(begun)));
    Reading reading = in(begun + "end\n");
    assertEquals("def p(): \u2026, 4 lines", reading.summary());
    assertEquals(Optional.of("sends the program def p():"), reading.effect());
  }

  @Test
  void tellsCommandsFromLinesOfScript() {
    assertEquals("command", in("stop program\n").type());
    assertEquals(Optional.of("stop program"), in("stop program\n").effect());
    assertEquals("line", in("movej([0,0,0,0,0,0])\n").type());
    assertEquals(Optional.empty(), in("# nothing\n").effect());
    assertEquals("line", in("define(1)\n").type());
  }

  @Test
  void saysOfNoMessageToAReadOnlyPortThatItDoesSomething() {
    Dissector readOnly = new PrimaryDissector(false);
    assertEquals(Optional.empty(), readOnly.read(Direction.IN, text("stop program\n")).effect());
  }
}
